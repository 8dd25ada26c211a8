# SPDX-License-Identifier: GPL-3.0-or-later
"""Fovea: 3D scenes drawn as line drawings, inside Blender's own render pipeline.

Importable without Blender: only `register` touches what needs it.
"""

import importlib

MODULES = (
    *("preferences", "properties", "style_operators", "line_set_operators"),
    *("panels", "viewport_settings", "engine"),
)
TOOLS = (
    *("focus_operators", "focus_place_operators", "focus_pull", "focus_gizmos", "focus_overlay"),
    *("style_assets", "line_operators", "report", "freestyle", "tools_panel"),
)


def _modules():
    return [importlib.import_module(f".blender.{name}", __package__) for name in MODULES + TOOLS]


def register():
    for module in _modules():
        module.register()


def unregister():
    for module in reversed(_modules()):
        module.unregister()
