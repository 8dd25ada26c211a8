# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel: the focus, with one box per focus point."""

import bpy

from ..focus import focus_kinds
from .common import FoveaPanel


class RENDER_PT_fovea_focus(FoveaPanel, bpy.types.Panel):
    bl_label = "Focus"

    def show(self, layout, context):
        draw_focus(layout, context.scene.fovea)


def draw_focus(layout, settings):
    """Draws the focus in a scene's settings."""
    layout.prop(settings, "focus_model")
    kind = focus_kinds.of(settings)
    for name in kind.settings:
        layout.prop(settings, name)
    if not kind.place:
        return
    _draw_place(layout, settings, kind)
    for index, place in enumerate(settings.focus_points):
        box = layout.box()
        row = box.row()
        row.label(text=f"Place {index + 2}")
        row.operator("fovea.focus_place_remove", text="", icon="X", emboss=False).index = index
        _draw_place(box, place, kind)
    if settings.focus_points:
        layout.prop(settings, "focus_combine")


def _draw_place(layout, place, kind):
    column = layout.column()
    for name in kind.place:
        if name != "focus_location" or place.focus_object is None:
            column.prop(place, name)
