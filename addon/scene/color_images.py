# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's images as native textures, kept as long as their pixels stay the same."""

import os

import bpy
import numpy as np


class ImageCache:
    """Textures by image. One that is read from a file is read again when the file, its size or how it is to be read
    changes; painted and generated ones are looked at every time, and told apart by content."""

    def __init__(self, core):
        self._core = core
        self._entries = {}  # name -> (how it is read, content hash, texture)

    def size(self):
        """Bytes of all textures: four a texel, and smaller copies."""
        return sum(4 * width * height * 4 // 3 for (width, height, *_), _, _ in self._entries.values())

    def clear(self):
        self._entries.clear()

    def texture(self, image):
        """The native ColorTexture of an image, or None where it has no pixels (a missing file, say)."""
        if not all(image.size):
            return None
        how, known = _how(image), self._entries.get(image.name_full)
        settled = image.source == "FILE" and not image.is_dirty
        if known and known[0] == how and settled:
            return known[2]
        pixels = _pixels(image)
        if pixels is None:
            return None
        content = self._core.content_hash(pixels)
        if not known or known[:2] != (how, content):
            known = (how, content, self._core.ColorTexture(pixels, _is_encoded(image)))
        self._entries[image.name_full] = known
        return known[2]


def _how(image):
    """Everything that says what an image's pixels are, but the pixels."""
    file, written = bpy.path.abspath(image.filepath, library=image.library), None
    if image.source == "FILE" and not image.packed_file and os.path.exists(file):
        written = os.stat(file).st_mtime_ns
    packed = image.packed_file.size if image.packed_file else None
    reading = (image.colorspace_settings.name, image.alpha_mode, image.is_float, image.source)
    return (*image.size, image.channels, file, written, packed, *reading)


def _pixels(image):
    """(H, W, channels) float32, bottom row first, alpha straight."""
    width, height = image.size
    channels = image.channels
    if not 1 <= channels <= 4 or len(image.pixels) != width * height * channels:
        return None
    pixels = np.empty(width * height * channels, np.float32)
    image.pixels.foreach_get(pixels)
    pixels = pixels.reshape(height, width, channels)
    if image.is_float and channels == 4 and image.alpha_mode == "PREMUL":
        alpha = pixels[..., 3:]
        np.divide(pixels[..., :3], alpha, out=pixels[..., :3], where=alpha > 0)
    return pixels


def _is_encoded(image):
    """Whether pixels are as sRGB has them: floats are scene-linear, bytes as their color space says."""
    space = image.colorspace_settings
    return not (image.is_float or space.is_data or space.name.startswith("Linear"))
