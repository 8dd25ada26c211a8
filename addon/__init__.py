# SPDX-License-Identifier: GPL-3.0-or-later
"""Fovea: 3D scenes drawn as line drawings, inside Blender's own render pipeline.

Importable without Blender: only `register` imports modules that need it.
"""

import importlib

MODULES = (  # those with something to register; panels stand in this order
    *("ui.preferences", "style.style_groups", "focus.focus_settings", "render.properties"),
    *("style.style_operators", "style.line_set_operators", "ui.thumbnails", "ui.gallery", "ui.panels", "ui.hints"),
    *("ui.style", "ui.lines", "ui.focus", "ui.effects", "ui.elision", "ui.animation", "ui.paper", "ui.to_scale"),
    *("ui.method", "ui.vectors", "ui.things", "ui.sidebar", "ui.lines_over", "ui.menu", "ui.viewport_settings"),
    "ui.simplify",
    *("scene.overrides", "render.engine", "render.write_flag", "render.near_frames", "render.whole_frames"),
    *("render.frame_check", "render.sockets"),
)
TOOLS = (
    *("focus.focus_operators", "focus.focus_place_operators", "focus.focus_pull", "focus.focus_gizmos"),
    *("focus.focus_tool", "style.renamed"),
    *("ui.focus_overlay", "style.style_assets", "render.line_operators", "render.bake_operators"),
    "render.marks_operators",
    *("render.compare_operators", "render.register_operators", "render.fit_operators", "render.learn_operators"),
    "render.gaze_operators",
    *("render.vector_operators", "render.to_scale_operators", "render.cameras"),
    *("render.lines_over_operators", "render.lines_over_check", "render.lines_overlay", "render.report"),
    *("style.freestyle", "style.line_art"),
    *("ui.gauge_setting", "ui.tools_panel"),
)


def _imported(name):
    return importlib.import_module(f".{name}", __package__)


def register():
    for name in MODULES + TOOLS:
        _imported("scene.registration").register(_imported(name))


def unregister():
    for name in reversed(MODULES + TOOLS):
        _imported("scene.registration").unregister(_imported(name))
