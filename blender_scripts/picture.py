# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders pictures to files with Blender, checks that they are complete, and reads them back."""

import struct

import bpy
import numpy as np
from command import output


def render(scene, path):
    """Renders the scene to `path`, which is replaced only when the file is complete. ValueError if it is not drawn."""
    with output.written(path, is_whole) as fresh:
        scene.render.filepath = _literal(fresh)
        try:
            bpy.ops.render.render(scene=scene.name, write_still=True)
        except RuntimeError as error:
            if fresh.name in str(error):
                raise  # drawn, but not written: handled by `written`
            raise ValueError(str(error)) from error


def _literal(path):
    """A path escaped for Blender's render settings: from 5.0 on, braces enclose template variables."""
    return str(path).replace("{", "{{").replace("}", "}}") if bpy.app.version >= (5, 0, 0) else str(path)


def is_whole(path):
    """Whether a file exists, is not truncated, and Blender can read it. Truncation is tested first, because Blender 4.3
    accepts an OpenEXR file without its last tenth, and hangs on one that ends in its header."""
    if not path.is_file() or not ENDS[path.suffix](path.read_bytes()):
        return False
    image = bpy.data.images.load(str(path))
    found = len(image.pixels) > 0 and image.has_data  # pixels are loaded on first access
    bpy.data.images.remove(image)
    return found


def exr_ends(data):
    """Whether the last chunk of a single-part OpenEXR file ends at the end of the file. The header is a list of
    attributes (name, type, size, value); then follow the offsets of all chunks (8 bytes each, 0 until written) and the
    chunks: two 32-bit integers, the second of which is the size of the data after them."""
    try:
        at = 8
        while data[at]:
            size_at = data.index(0, data.index(0, at) + 1) + 1
            at = size_at + 4 + struct.unpack_from("<I", data, size_at)[0]
        table = at + 1
        (first,) = struct.unpack_from("<Q", data, table)
        places = struct.unpack_from(f"<{(first - table) // 8}Q", data, table)
        return all(places) and max(places) + 8 + struct.unpack_from("<I", data, max(places) + 4)[0] == len(data)
    except (IndexError, ValueError, struct.error):
        return False


ENDS = {  # suffix -> test that a file's bytes are not truncated
    ".png": lambda data: data.endswith(b"IEND\xaeB`\x82"),
    ".jpg": lambda data: data.endswith(b"\xff\xd9"),
    ".exr": exr_ends,
}


def pixels(path):
    """(H, W, C) float32 values of a picture as stored, without color conversion, bottom row first."""
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    flat = np.empty(len(image.pixels), np.float32)
    image.pixels.foreach_get(flat)
    width, height = image.size
    bpy.data.images.remove(image)
    return flat.reshape(height, width, -1)
