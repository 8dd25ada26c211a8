# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel: where the viewer shall look, one box for each place."""

import bpy

from ..focus import focus_place_operators
from .common import FoveaPanel

NAMES = {  # model: properties of a place
    "IMAGE": ("place", "near", "far"),
    "SCENE": ("object", "location", "near_distance", "far_distance"),
    "OBJECT": ("object", "near_distance", "far_distance"),
}


class RENDER_PT_fovea_focus(FoveaPanel, bpy.types.Panel):
    bl_label = "Focus"

    def show(self, layout, context):
        draw_focus(layout, context.scene.fovea)


def draw_focus(layout, settings):
    """Where to look, as the scene says."""
    layout.prop(settings, "focus_model")
    if settings.focus_model == "PAINTED":
        layout.prop(settings, "focus_attribute")
    if settings.focus_model not in focus_place_operators.LISTED:
        return
    _draw_place(layout, settings, settings.focus_model)
    for index, place in enumerate(settings.focus_points):
        box = layout.box()
        row = box.row()
        row.label(text=f"Place {index + 2}")
        row.operator("fovea.focus_place_remove", text="", icon="X", emboss=False).index = index
        _draw_place(box, place, settings.focus_model)
    if settings.focus_points:
        layout.prop(settings, "focus_combine")


def _draw_place(layout, place, model):
    column = layout.column()
    for name in NAMES[model]:
        if name != "location" or place.focus_object is None:
            column.prop(place, f"focus_{name}")


CLASSES = (RENDER_PT_fovea_focus,)
