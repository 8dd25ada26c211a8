# SPDX-License-Identifier: GPL-3.0-or-later
"""Fovea: 3D scenes drawn as line drawings, inside Blender's own render pipeline.

Importable without Blender: only `register` imports modules that need it.
"""

import importlib

MODULES = (
    *("ui.preferences", "render.properties", "style.style_operators", "style.line_set_operators"),
    *("ui.panels", "ui.viewport_settings", "render.engine"),
)
TOOLS = (
    *("focus.focus_operators", "focus.focus_place_operators", "focus.focus_pull", "focus.focus_gizmos"),
    *("ui.focus_overlay", "style.style_assets", "render.line_operators", "render.report", "style.freestyle"),
    "ui.tools_panel",
)


def _modules():
    return [importlib.import_module(f".{name}", __package__) for name in MODULES + TOOLS]


def register():
    for module in _modules():
        module.register()


def unregister():
    for module in reversed(_modules()):
        module.unregister()
