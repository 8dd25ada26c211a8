# SPDX-License-Identifier: GPL-3.0-or-later
"""Native textures and opacities of Blender's images, cached until their pixels change."""

import os

import bpy
import numpy as np

LUMINANCE = (0.2126, 0.7152, 0.0722)


class ImageCache:
    """Textures and opacities by image. An image file is read again when the file, its size or its read settings change;
    the pixels of painted and generated images are hashed each time."""

    def __init__(self, core):
        self.core = core
        self._entries = {}  # (name, use) -> (result of _how, content hash, texture or opacity)

    def size(self):
        """Bytes of all textures and opacities: four per texel, and mipmaps."""
        return sum(4 * width * height * 4 // 3 for (width, height, *_), _, _ in self._entries.values())

    def clear(self):
        self._entries.clear()

    def texture(self, image):
        """The native ColorTexture of an image, or None if it has no pixels (a missing file, for example)."""
        known = self._known(image, None, lambda pixels: self.core.ColorTexture(pixels, _is_encoded(image)))
        return known and known[2]

    def opacity(self, image, source):
        """(content hash, native Opacity) of an image as an opacity_nodes.Source uses it, or None."""
        known = self._known(image, source, lambda pixels: _opacity(self.core, image, pixels, source))
        return known and known[1:]

    def _known(self, image, use, make):
        """The entry of an image in some use, `make(pixels)`; None if it has no pixels."""
        if not all(image.size):
            return None
        how, known = _how(image), self._entries.get((image.name_full, use))
        settled = image.source == "FILE" and not image.is_dirty
        if known and known[0] == how and settled:
            return known
        pixels = _pixels(image)
        if pixels is None:
            return None
        content = self.core.content_hash(pixels)
        if not known or known[:2] != (how, content):
            known = (how, content, make(pixels))
        self._entries[image.name_full, use] = known
        return known


def _how(image):
    """Key of everything that determines an image's pixels: size, file, modification time, read settings."""
    file, written = bpy.path.abspath(image.filepath, library=image.library), None
    if image.source == "FILE" and not image.packed_file and os.path.exists(file):
        written = os.stat(file).st_mtime_ns
    packed = image.packed_file.size if image.packed_file else None
    reading = (image.colorspace_settings.name, image.alpha_mode, image.is_float, image.source)
    return (*image.size, image.channels, file, written, packed, *reading)


def _pixels(image):
    """(H, W, channels) float32, bottom row first, straight alpha; None if unreadable."""
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


def _opacity(core, image, pixels, source):
    """The native Opacity of an image's pixels."""
    if source.channel == "ALPHA":
        has_alpha = pixels.shape[2] == 4 and image.alpha_mode != "NONE"
        values = pixels[..., 3] if has_alpha else np.ones(pixels.shape[:2], np.float32)
    else:
        colors = pixels[..., :3] if pixels.shape[2] >= 3 else pixels[..., :1]
        if _is_encoded(image):
            curve = ((np.maximum(colors, 0.0) + 0.055) / 1.055) ** 2.4
            colors = np.where(colors <= 0.04045, colors / 12.92, curve)
        weights = {"GRAY": LUMINANCE, "RED": (1, 0, 0), "GREEN": (0, 1, 0), "BLUE": (0, 0, 1)}[source.channel]
        values = colors @ np.array(weights) if colors.shape[2] == 3 else colors[..., 0]
    opacity = (source.gain * values + source.offset).astype(np.float32)
    return core.Opacity(opacity, source.threshold, source.extension, source.closest)


def _is_encoded(image):
    """Whether the pixels are sRGB-encoded: float images are scene-linear, byte images follow their color space."""
    space = image.colorspace_settings
    return not (image.is_float or space.is_data or space.name.startswith("Linear"))
