# SPDX-License-Identifier: GPL-3.0-or-later
"""Render > Fovea > Register Drawing: a scan brought to where the scene's lines are, behind what the camera sees."""

from functools import partial

import bpy

from .. import comparison, files, paper_scale
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
        path, camera = self._path(), context.scene.camera
        if camera.type != "CAMERA" or camera.data.library:
            raise CannotDraw(f"'{camera.name}' is no camera of this file: make it local to show a drawing behind it")
        content, found, tolerance, recall = lines_of_render(context, partial(self._registered, path))
        made = path.with_name(f"{path.stem}{ENDING}.png")
        with files.written(made) as fresh:
            fresh.write_bytes(content)
        show_behind(camera.data, made)
        self.report(
            {"INFO"},
            f"'{made.name}' is behind what '{camera.name}' sees: {recall:.0%} of the scene's lines are within "
            f"{tolerance:.1f} pixels of it",
        )

    def _path(self):
        path, *others = self.paths
        if others:
            raise CannotDraw("Register one drawing after the other: a camera shows the one that was registered last")
        return path

    def _registered(self, path, lines):
        """(bytes of the PNG, its Laid, tolerance [px], share of the lines near to it)."""
        reference, asked = lines.bitmap(lines.size), self.near
        on_paper = isinstance(asked, comparison.Millimeters)
        content, found = comparison.registered_png(
            path, reference, self.register_by.lower(), None if on_paper else asked
        )
        tolerance = asked or reference.usual_tolerance
        if on_paper:
            tolerance = paper_scale.in_pixels(asked, lines.size[0], [(path.stem, found.px_per_mm)])
        return content, found, tolerance, reference.measures(found.bitmap, tolerance)["precision"]


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
