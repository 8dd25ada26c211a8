# SPDX-License-Identifier: GPL-3.0-or-later
"""Textures and render targets, to and from NumPy arrays."""

from contextlib import contextmanager

import gpu
import numpy as np

from .. import native

_FORMATS = {1: "R32F", 2: "RG32F", 4: "RGBA32F"}


def size_limit():
    """The GPU's limit on texture size along an axis, in texels."""
    return gpu.capabilities.max_texture_size_get()


def row_width():
    """Width in texels at which one-dimensional tables wrap into texture rows."""
    return native.load().AtlasBatch.ROW_WIDTH


def upload(pixels, format=None):
    """Texture from an array (height, width) or (height, width, channels), float32, bottom row first."""
    height, width = pixels.shape[:2]
    channels = pixels.shape[2] if pixels.ndim == 3 else 1
    flat = np.ascontiguousarray(pixels, dtype=np.float32).reshape(-1)
    data = gpu.types.Buffer("FLOAT", flat.size, flat)
    return gpu.types.GPUTexture((width, height), format=format or _FORMATS[channels], data=data)


def upload_row(entries):
    """Texture from a table (n,) or (n, channels), wrapped into rows of row_width() texels and padded with 0; three
    channels become four."""
    channels = entries.shape[1] if entries.ndim == 2 else 1
    width, texel = row_width(), 4 if channels == 3 else channels
    rows = max(1, -(-len(entries) // width))
    pixels = np.zeros((rows * width, texel), np.float32)
    pixels[: len(entries), :channels] = entries.reshape(-1, channels)
    return upload(pixels.reshape(rows, width, texel))


class Target:
    """A framebuffer of width x height texels with a color texture of a `format`, optionally a `second` color texture of
    that format, and a depth texture (True: a new one; or an existing GPUTexture).

    References the textures, because a GPUFrameBuffer does not keep them alive. ValueError above the GPU's size limit.
    """

    def __init__(self, width, height, format, second=None, depth=False):
        if max(width, height) > size_limit():
            raise ValueError(f"{width} x {height} pixels are more than this GPU draws at once; use the CPU")
        self.width, self.height = width, height
        self._numbers = "UINT" if format.endswith("UI") else "FLOAT"
        self.color = gpu.types.GPUTexture((width, height), format=format)
        self.second = gpu.types.GPUTexture((width, height), format=second) if second else None
        self.depth = depth or None
        if depth is True:
            self.depth = gpu.types.GPUTexture((width, height), format="DEPTH_COMPONENT32F")
        slots = {"color_slots": (self.color, self.second) if second else self.color}
        if self.depth:
            slots["depth_slot"] = self.depth
        self._framebuffer = gpu.types.GPUFrameBuffer(**slots)

    @contextmanager
    def bind(self, depth_test="NONE", blend="NONE"):
        """Context in which draws go into this target; restores the framebuffer, depth and blend state afterwards. With
        a depth test, depth is written."""
        before = gpu.state.depth_test_get(), gpu.state.depth_mask_get(), gpu.state.blend_get()
        try:
            with self._framebuffer.bind():
                _set_state(depth_test, depth_test != "NONE", blend)
                yield self._framebuffer
        finally:
            _set_state(*before)

    def wait(self):
        """Blocks until all draws into it are finished, by reading back one pixel."""
        with self._framebuffer.bind():
            self._framebuffer.read_color(0, 0, 1, 1, 1, 0, self._numbers)

    def read(self, channels, slot=0):
        """(height, width, channels) float32 of the first (0) or second (1) color texture; blocks until draws finish."""
        count = self.width * self.height * channels
        with self._framebuffer.bind():
            data = self._framebuffer.read_color(0, 0, self.width, self.height, channels, slot, "FLOAT")
        data.dimensions = count  # 4.3 scrambles the strides of buffers of several dimensions
        return np.asarray(data, dtype=np.float32).reshape(self.height, self.width, channels)


def _set_state(depth_test, depth_mask, blend):
    gpu.state.depth_test_set(depth_test)
    gpu.state.depth_mask_set(depth_mask)
    gpu.state.blend_set(blend)
    gpu.state.face_culling_set("NONE")
