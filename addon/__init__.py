"""Fovea: 3D scenes drawn as line drawings, inside Blender's own render pipeline.

Importable without Blender: only `register` touches what needs it.
"""

import importlib

MODULES = ("preferences", "properties", "viewport_settings", "panels", "engine")


def _modules():
    return [importlib.import_module(f".blender.{name}", __package__) for name in MODULES]


def register():
    for module in _modules():
        module.register()


def unregister():
    for module in reversed(_modules()):
        module.unregister()
