# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel: the focus, with one box per focus point."""

import bpy

from ..focus import focus_kinds
from .common import FoveaPanel


class RENDER_PT_fovea_focus(FoveaPanel, bpy.types.Panel):
    bl_label = "Focus"

    def show(self, layout, context):
        draw_focus(layout, context.scene.fovea)
        draw_check(layout)


def draw_check(layout):
    """Draws the operators that tell whether the eye goes to the focus."""
    column = layout.column(align=True)
    column.operator("fovea.check_focus", icon="HIDE_OFF")
    column.operator("fovea.strengthen_focus")


def draw_focus(layout, settings):
    """Draws the focus in a scene's settings."""
    layout.prop(settings, "focus_model")
    kind = focus_kinds.of(settings)
    for name in kind.settings:
        layout.prop(settings, name)
    if not kind.place:
        return
    if not settings.focus_points:
        _draw_place(layout, settings, kind)
        return
    for number, place in enumerate((settings, *settings.focus_points), start=1):
        box = layout.box()
        row = box.row()
        row.label(text=f"Place {number}")
        remove = row.operator("fovea.focus_place_remove", text="", icon="X", emboss=False)
        remove.first, remove.index = number == 1, max(number - 2, 0)
        _draw_place(box, place, kind)
    layout.prop(settings, "focus_combine")


def _draw_place(layout, place, kind):
    """Draws a focus point; of one that an Empty marks, the Empty's location, which is what is keyed."""
    layout.use_property_decorate = True
    column, mark = layout.column(), place.focus_object
    for name in kind.place:
        if name != "focus_location" or mark is None:
            column.prop(place, name)
        elif mark.type == "EMPTY":
            column.prop(mark, "location")
