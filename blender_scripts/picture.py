# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders pictures to files with Blender, checks that they are complete, and reads them back."""

import bpy
import numpy as np
from bl_ext.user_default.fovea.render import lines_scenes
from bl_ext.user_default.fovea.render.whole_pictures import is_whole, literal
from command import output


def render(scene, path):
    """Renders the scene to `path`, which is replaced only when the file is complete. ValueError if it is not drawn."""
    with output.written(path, is_whole) as fresh:
        scene.render.filepath = literal(fresh)
        try:
            bpy.ops.render.render(scene=scene.name, write_still=True)
        except RuntimeError as error:
            if fresh.name in str(error):
                raise  # drawn, but not written: handled by `written`
            raise ValueError(str(error)) from error
        if why := lines_scenes.failure(scene):
            raise ValueError(why)


def pixels(path):
    """(H, W, C) float32 values of a picture as stored, without color conversion, bottom row first."""
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    flat = np.empty(len(image.pixels), np.float32)
    image.pixels.foreach_get(flat)
    width, height = image.size
    bpy.data.images.remove(image)
    return flat.reshape(height, width, -1)
