# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws an image into the 3D viewport that Blender is drawing."""

import blf
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader
from gpu_extras.presets import draw_texture_2d

from .program import triangles
from .texture import upload

VEIL = (0.5, 0.5, 0.5, 0.7)  # RGBA in display space, over a picture that is out of date
_PLACES = np.array([(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)], np.float32)
_WHOLE = np.column_stack([2 * _PLACES - 1, np.zeros(len(_PLACES)), np.ones(len(_PLACES))]), _PLACES


class Picture:
    """A texture from (H, W, 4) float32: scene-linear, premultiplied RGBA, bottom row first."""

    def __init__(self, pixels):
        self._texture = upload(pixels, "RGBA16F")

    def show(self, programs, engine, scene, width, height, moved=None):
        """Draws it over a region of width x height pixels: in the scene's display space if the texture has that size,
        else interpolated linearly by the program `magnify`. `moved`: None, or (6, 4) clip coordinates of two triangles
        and the (6, 2) places on the picture that they show. `programs`: a program.Programs."""
        gpu.state.blend_set("ALPHA_PREMULT")
        if moved is None and (self._texture.width, self._texture.height) == (width, height):
            engine.bind_display_space_shader(scene)
            draw_texture_2d(self._texture, (0, 0), width, height)
            engine.unbind_display_space_shader()
        else:
            corners, places = moved or _WHOLE
            batch = triangles({"corner": corners, "place": places})
            batch.draw(programs.bind("magnify", {"picture": self._texture}))
        gpu.state.blend_set("NONE")

    def show_over(self, programs, width, height, moved, inside, opacity):
        """Draws it over what another engine shows in a region of width x height pixels. Blender stores overlays as sRGB
        and lays them over the picture after its view transform: colors of lines are those of their pens. `inside`:
        (left, bottom, right, top) in pixels of where it is drawn. `programs` and `moved`: as for `show`."""
        corners, places = moved or _WHOLE
        batch = triangles({"corner": corners, "place": places})
        before = gpu.state.depth_test_get()
        gpu.state.depth_test_set("NONE")
        gpu.state.blend_set("ALPHA_PREMULT")
        batch.draw(programs.bind("overlay", {"picture": self._texture}, inside=inside, opacity=opacity))
        gpu.state.blend_set("NONE")
        gpu.state.depth_test_set(before)


def veil(width, height):
    """Fades what a region of width x height pixels shows to gray."""
    shader = gpu.shader.from_builtin("UNIFORM_COLOR")
    shader.uniform_float("color", VEIL)
    corners = [(0, 0, 0), (width, 0, 0), (0, height, 0), (width, height, 0)]
    gpu.state.blend_set("ALPHA")
    batch_for_shader(shader, "TRI_STRIP", {"pos": corners}).draw(shader)
    gpu.state.blend_set("NONE")


def say(text, width, height, size, up=0.5):
    """Draws a line of text in the middle of a region of width x height pixels; `size`: of its letters in pixels; `up`:
    how high it is, 1 is the region's top."""
    blf.size(0, size)
    across, _ = blf.dimensions(0, text)
    blf.color(0, 1.0, 1.0, 1.0, 1.0)
    blf.enable(0, blf.SHADOW)
    blf.shadow(0, 5, 0.0, 0.0, 0.0, 1.0)
    blf.position(0, (width - across) / 2, (height - size) * up, 0)
    blf.draw(0, text)
    blf.disable(0, blf.SHADOW)


def is_software():
    """Whether OpenGL is a software implementation on the CPU."""
    return gpu.platform.device_type_get() == "SOFTWARE"
