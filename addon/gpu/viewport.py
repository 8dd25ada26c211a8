# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws an image into the 3D viewport that Blender is drawing."""

import gpu
from gpu_extras.presets import draw_texture_2d

from .texture import upload


class Picture:
    """A texture from (H, W, 4) float32: scene-linear, premultiplied RGBA, bottom row first."""

    def __init__(self, pixels):
        self._texture = upload(pixels, "RGBA16F")

    def show(self, programs, engine, scene, width, height):
        """Draws it over a region of width x height pixels: in the scene's display space if the texture has that size,
        else interpolated linearly by the program `magnify`. `programs`: a program.Programs."""
        gpu.state.blend_set("ALPHA_PREMULT")
        if (self._texture.width, self._texture.height) == (width, height):
            engine.bind_display_space_shader(scene)
            draw_texture_2d(self._texture, (0, 0), width, height)
            engine.unbind_display_space_shader()
        else:
            programs.cover("magnify", {"picture": self._texture}, region_size=(width, height))
        gpu.state.blend_set("NONE")


def is_software():
    """Whether OpenGL is a software implementation on the CPU."""
    return gpu.platform.device_type_get() == "SOFTWARE"
