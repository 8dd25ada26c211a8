# SPDX-License-Identifier: GPL-3.0-or-later
"""Overlays over a viewport: rings, dots and translucent images, in pixels of the region that Blender is drawing."""

import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader
from gpu_extras.presets import draw_texture_2d

from .texture import upload

_SEGMENTS = 96
_ANGLES = np.linspace(0, 2 * np.pi, _SEGMENTS + 1)
_CIRCLE = np.stack([np.cos(_ANGLES), np.sin(_ANGLES), np.zeros_like(_ANGLES)], axis=1)


def ring(center, radius, color, width):
    """Draws a circle; center, radius and line width in pixels, color: RGBA in display space."""
    curve(_circle(center, radius), color, width)


def dot(center, radius, color):
    """Draws a filled disc; arguments as for `ring`."""
    _draw(gpu.shader.from_builtin("UNIFORM_COLOR"), "TRI_FAN", _circle(center, radius), color)


def curve(points, color, width):
    """Draws a polyline of points (n, 2) or (n, 3) in pixels; other arguments as for `ring`."""
    shader = gpu.shader.from_builtin("POLYLINE_UNIFORM_COLOR")
    shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    shader.uniform_float("lineWidth", width)
    points = np.asarray(points, np.float32)
    _draw(shader, "LINE_STRIP", np.pad(points, ((0, 0), (0, 3 - points.shape[1]))), color)


def _circle(center, radius):
    return (radius * _CIRCLE + (*center, 0)).astype(np.float32)


def _draw(shader, kind, points, color):
    shader.uniform_float("color", color)
    gpu.state.blend_set("ALPHA")
    batch_for_shader(shader, kind, {"pos": points}).draw(shader)
    gpu.state.blend_set("NONE")


class Veil:
    """An image (H, W, 4) float32, bottom row first, in display space, straight alpha."""

    def __init__(self, pixels):
        self._texture = upload(pixels, "RGBA16F")

    def show(self, width, height):
        """Draws it stretched over a region of width x height pixels."""
        gpu.state.blend_set("ALPHA")
        draw_texture_2d(self._texture, (0, 0), width, height)
        gpu.state.blend_set("NONE")
