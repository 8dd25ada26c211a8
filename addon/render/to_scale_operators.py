# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators for drawings to scale: a section plane, and a sheet of paper."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty

from ..scene.operator import Operator
from ..style import style_data
from ..style.style_operators import OnStyle
from . import drawing_scale, vectors


def _sheets(_operator, _context):
    return vectors.sheets()


class FOVEA_OT_sheet(OnStyle, bpy.types.Operator):
    """Make the picture as large as a sheet of paper within its margins, and beside a title block: the page of the
    style, and the proportions of the render. The scale stays"""

    bl_idname, bl_label = "fovea.sheet", "Sheet of Paper"

    sheet: EnumProperty(name="Paper", description="Size of the sheet", items=_sheets)
    upright: BoolProperty(name="Upright", description="The sheet stands on its short side", default=False)
    margin: FloatProperty(
        name="Margin", description="Left free around the picture [mm]", default=10.0, min=0.0, max=1000.0
    )

    title_block: BoolProperty(name="Title Block", description="Leave room for a title block", default=False)

    def invoke(self, context, _event):
        return context.window_manager.invoke_props_dialog(self)

    def act(self, context):
        scene = context.scene
        asked = {"sheet": self.sheet, "margin": self.margin, "title_block": self.title_block}
        width, height = vectors.room_on_sheet(self.upright, **asked)
        before = drawing_scale.scale_of(scene)
        style_data.own(scene).paper.height_mm = height
        render = scene.render
        across = width / height * render.pixel_aspect_y / render.pixel_aspect_x
        render.resolution_x = max(4, int(render.resolution_y * across + 1e-6))  # not more than there is room for
        drawing_scale.set_scale(scene, before)


class FOVEA_OT_section_add(Operator, bpy.types.Operator):
    """Add an Empty at the 3D cursor and make it the scene's section plane: what is above it is cut away"""

    bl_idname, bl_label = "fovea.section_add", "Add Section Plane"

    def act(self, context):
        scene = context.scene
        plane = bpy.data.objects.new("Section Plane", None)
        plane.empty_display_type, plane.empty_display_size = "SINGLE_ARROW", 1.0
        plane.location = scene.cursor.location
        context.collection.objects.link(plane)
        scene.fovea.section = plane
