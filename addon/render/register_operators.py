# SPDX-License-Identifier: GPL-3.0-or-later
"""Render > Fovea > Register Drawing: a scan brought to where the scene's lines are, behind what the camera sees."""

from pathlib import Path

import bpy

from .. import comparison, files
from ..scene.problem import CannotDraw
from .compare_operators import REGISTER, OfDrawing, lines_of_render

ENDING = "_registered"  # of the file's name


class FOVEA_OT_register_drawing(OfDrawing, bpy.types.Operator):
    """Move, turn and straighten a scanned drawing so that it lies over a final render of this frame. It is written as a
    PNG beside the scan, and is shown behind what the camera sees in viewports"""

    bl_idname, bl_label = "fovea.register_drawing", "Register Drawing"

    filter_glob: bpy.props.StringProperty(default="*.png", options={"HIDDEN"})
    register_by: bpy.props.EnumProperty(
        name="Register", description="What tells how the scan lies over the render", items=REGISTER[1:]
    )

    def act(self, context):
        path, camera = Path(bpy.path.abspath(self.filepath)), context.scene.camera
        if camera.type != "CAMERA" or camera.data.library:
            raise CannotDraw(f"'{camera.name}' is no camera of this file: make it local to show a drawing behind it")
        lines = lines_of_render(context)
        reference = lines.bitmap(lines.size)
        content, found = comparison.registered_png(path, reference, self.register_by.lower(), self.tolerance or None)
        made = path.with_name(f"{path.stem}{ENDING}.png")
        with files.written(made) as fresh:
            fresh.write_bytes(content)
        show_behind(camera.data, made)
        tolerance = self.tolerance or reference.usual_tolerance
        recall = reference.measures(found.bitmap, tolerance)["precision"]
        self.report(
            {"INFO"},
            f"'{made.name}' is behind what '{camera.name}' sees: {recall:.0%} of the scene's lines are within "
            f"{tolerance:.1f} pixels of it",
        )


def show_behind(camera, path):
    """Makes a picture, which fills the frame, the background of a Camera; one that it has is read again."""
    image = bpy.data.images.load(str(path), check_existing=True)
    image.reload()
    shown = next((shown for shown in camera.background_images if shown.image == image), None)
    shown = shown or camera.background_images.new()
    shown.source, shown.image, shown.show_background_image = "IMAGE", image, True
    shown.frame_method, shown.display_depth = "STRETCH", "BACK"
    shown.offset, shown.scale, shown.rotation = (0.0, 0.0), 1.0, 0.0
    shown.use_flip_x = shown.use_flip_y = False
    camera.show_background_images = True
