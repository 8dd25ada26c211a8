# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of a final render as an image with alpha; what operators share that draw a scene."""

from contextlib import contextmanager
from functools import partial

import bpy
import numpy as np

from .. import native
from ..scene import followed
from ..scene.operator import Operator
from ..scene.problem import CannotDraw
from . import as_rendered, session


class OfRender(Operator):
    """One that draws the context's scene."""

    @classmethod
    def hindrance(cls, context):
        if problem := native.problem():
            return problem
        if context.scene and followed.follows(context.scene):
            return f"This scene draws the lines of '{followed.of(context.scene).name}': go to that one"
        if context.scene is None or context.scene.camera is None:
            return "The scene has no camera: add one, or make one the scene's active camera"
        fits = context.mode in {"OBJECT", "POSE"}
        return None if fits else "Leave the mode first: this works in Object mode"


@contextmanager
def progress(context):
    """Context with a function progress(share, text) that shows the share in [0, 1] at the pointer."""
    manager = context.window_manager
    manager.progress_begin(0.0, 1.0)
    try:
        yield lambda share, _text: manager.progress_update(share)
    finally:
        manager.progress_end()


class FOVEA_OT_render_lines(OfRender, bpy.types.Operator):
    """Draw the lines alone to a new image with alpha, as a final render of this frame and view layer has them, and open
    it. The scene may use any render engine"""

    bl_idname = "fovea.render_lines"
    bl_label = "Render Line Layer to Image"

    name: bpy.props.StringProperty(name="Name", description="Of the image", default="Lines")

    def invoke(self, context, _event):
        """Opens the image, too, which scripts that execute the operator may not want."""
        done = self.execute(context)
        if done == {"FINISHED"}:
            open_image(context, self.image)
        return done

    def act(self, context):
        with progress(context) as tell:
            drawn = as_rendered.look(context, partial(session.final_image, lines_alone=True, tell=tell))
        if drawn is None:
            raise CannotDraw("Stopped before the lines were drawn")
        image = self.image = image_of(self.name, drawn.lines)
        self.report({"INFO"}, f"The lines are in the image '{image.name}'")


def image_of(name, pixels):
    """A new image from (H, W, 4) float32, scene-linear, premultiplied; packed, so that saving and undo include it."""
    height, width = pixels.shape[:2]
    image = bpy.data.images.new(name, width, height, alpha=True, float_buffer=True)
    image.alpha_mode = "PREMUL"
    image.pixels.foreach_set(np.ascontiguousarray(pixels, np.float32).ravel())
    image.update()
    image.pack()
    return image


def linear(picture):
    """(H, W, 4) float32, scene-linear and opaque, of (H, W, 3) uint8 as displayed."""
    value = picture / np.float32(255)
    colors = np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)
    return np.concatenate([colors, np.ones((*colors.shape[:2], 1))], axis=2).astype(np.float32)


def open_image(context, image):
    """Shows an image in an image editor; where there is none, in one that Blender opens as it does for renders, which
    the preferences say (none at all, maybe)."""
    if not _image_editors(context):
        bpy.ops.render.view_show("INVOKE_DEFAULT")
    for editor in _image_editors(context)[:1]:
        editor.image = image


def _image_editors(context):
    areas = (area for window in context.window_manager.windows for area in window.screen.areas)
    editors = (area.spaces.active for area in areas if area.type == "IMAGE_EDITOR")
    return [editor for editor in editors if editor.mode == "VIEW" and not editor.use_image_pin]
