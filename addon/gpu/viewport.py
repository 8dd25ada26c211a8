# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows a picture in the 3D viewport that Blender is drawing."""

import gpu
from gpu_extras.presets import draw_texture_2d

from .texture import upload


class Picture:
    """Scene-linear, premultiplied RGBA, (H, W, 4) float32, bottom row first, in a texture."""

    def __init__(self, pixels):
        self._texture = upload(pixels, "RGBA16F")

    def show(self, programs, engine, scene, width, height):
        """Fills a region of that size, in the scene's display space; `programs`: a gpu_program.Programs."""
        gpu.state.blend_set("ALPHA_PREMULT")
        if (self._texture.width, self._texture.height) == (width, height):
            engine.bind_display_space_shader(scene)
            draw_texture_2d(self._texture, (0, 0), width, height)
            engine.unbind_display_space_shader()
        else:
            programs.cover("magnify", {"picture": self._texture}, region_size=(width, height))
        gpu.state.blend_set("NONE")


def is_software():
    """Whether OpenGL runs on the CPU here."""
    return gpu.platform.device_type_get() == "SOFTWARE"
