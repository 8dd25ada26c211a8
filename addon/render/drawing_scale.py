# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings to scale: how the frame of an orthographic camera and the page of the style belong together."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty

from .. import native
from ..scene.operator import Operator
from ..style import style_data
from ..style.style_operators import OnStyle
from . import vectors

LARGEST = 1e6  # N of a scale 1:N
SHEET_MARGIN = 10.0  # mm


def hindrance(scene):
    """Why a scene has no scale, as one sentence; None if it has one."""
    camera = scene.camera
    if camera is None or camera.type != "CAMERA":
        return "The scene has no camera: a drawing to scale needs one"
    if camera.data.type != "ORTHO":
        return f"Camera '{camera.name}' is not orthographic: a drawing has a scale only without perspective"
    return None


def frame_height(scene):
    """Height of the frame of the scene's orthographic camera, in meters."""
    corners = scene.camera.data.view_frame(scene=scene)
    return abs(corners[0].y - corners[1].y) * scene.unit_settings.scale_length


def page_height(scene):
    """Height of the page in millimeters, as the scene's style says."""
    tree = style_data.of(scene)
    return tree.fovea.paper.height_mm if tree else style_data.default().paper.height_mm


def scale_of(scene):
    """N of the scene's scale 1:N; 0 without one."""
    return 0.0 if hindrance(scene) else 1000.0 * frame_height(scene) / page_height(scene)


def set_scale(scene, wanted):
    """Makes the scene's scale 1:wanted by the size of the camera's frame; nothing without a scale."""
    now = scale_of(scene)
    if now > 0.0:
        scene.camera.data.ortho_scale *= wanted / now


def fit_page(scene, wanted):
    """Makes the scene's scale 1:wanted by the height of its style's page. ValueError without a scale."""
    if reason := hindrance(scene):
        raise ValueError(reason)
    style_data.own(scene).paper.height_mm = 1000.0 * frame_height(scene) / wanted


def annotations():
    """Property annotations for the scene's settings."""
    told = "N of the scale 1:N at which the camera's frame is drawn on the page; setting it sizes the frame"
    return {
        "drawing_scale": FloatProperty(
            name="Scale 1 :",
            description=told,
            min=0.0,
            max=LARGEST,
            precision=2,
            step=100,
            options={"SKIP_SAVE"},
            get=lambda settings: scale_of(settings.id_data),
            set=lambda settings, wanted: set_scale(settings.id_data, wanted) if wanted > 0.0 else None,
        )
    }


def _sheets(_operator, _context):
    return [item for item in vectors.kept_items("SHEETS") if any(native.load().sheet_size(item[0]))]


class FOVEA_OT_sheet(OnStyle, bpy.types.Operator):
    """Make the picture as large as a sheet of paper within its margins: the page of the style, and the proportions of
    the render. The scale stays"""

    bl_idname, bl_label = "fovea.sheet", "Sheet of Paper"

    sheet: EnumProperty(name="Paper", description="Size of the sheet", items=_sheets)
    upright: BoolProperty(name="Upright", description="The sheet stands on its short side", default=False)
    margin: FloatProperty(
        name="Margin", description="Left free around the picture [mm]", default=SHEET_MARGIN, min=0.0, max=1000.0
    )

    def invoke(self, context, _event):
        return context.window_manager.invoke_props_dialog(self)

    def act(self, context):
        scene = context.scene
        short, long = native.load().sheet_size(self.sheet)
        width, height = (side - 2 * self.margin for side in ((short, long) if self.upright else (long, short)))
        if min(width, height) <= 0.0:
            raise ValueError(f"a margin of {self.margin:g} mm leaves no room on this sheet: make it smaller")
        before = scale_of(scene)
        style_data.own(scene).paper.height_mm = height
        render = scene.render
        across = width / height * render.pixel_aspect_y / render.pixel_aspect_x
        render.resolution_x = max(4, round(render.resolution_y * across))
        set_scale(scene, before)


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
