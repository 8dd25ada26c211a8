# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of pictures that Blender writes: on a full disk it reports success for most formats, so they are read."""

import struct

import bpy


def literal(path):
    """A path escaped for Blender's render settings: from 5.0 on, braces enclose template variables."""
    return str(path).replace("{", "{{").replace("}", "}}") if bpy.app.version >= (5, 0, 0) else str(path)


def is_whole(path):
    """Whether a file exists, is not truncated, and Blender can read it. Truncation is tested first, because Blender 4.3
    accepts an OpenEXR file without its last tenth, and hangs on one that ends in its header."""
    if not path.is_file() or not ENDS.get(path.suffix.lower(), bool)(path.read_bytes()):
        return False
    image = bpy.data.images.load(str(path))
    # Pixels, and the type, are loaded on first access; an image of several layers has none of its own.
    found = len(image.pixels) > 0 and image.has_data or image.type == "MULTILAYER"
    bpy.data.images.remove(image)
    return found


def _exr_ends(data):
    """Whether the last chunk of an OpenEXR file ends at the end of the file. A header is a list of attributes (name,
    type, size, value); a file of several parts has several, and an empty one after them. Then follow the offsets of all
    chunks (8 bytes each, 0 until written) and the chunks: the part's number if there are several, and two 32-bit
    integers, the second of which is the size of the data after them."""
    try:
        at, has_parts = 8, data[5] & 0x10
        while data[at]:
            while data[at]:
                size_at = data.index(0, data.index(0, at) + 1) + 1
                at = size_at + 4 + struct.unpack_from("<I", data, size_at)[0]
            at += bool(has_parts)
        table = at + 1
        (first,) = struct.unpack_from("<Q", data, table)
        places = struct.unpack_from(f"<{(first - table) // 8}Q", data, table)
        size_at = max(places) + (8 if has_parts else 4)
        return all(places) and size_at + 4 + struct.unpack_from("<I", data, size_at)[0] == len(data)
    except (IndexError, ValueError, struct.error):
        return False


ENDS = {  # suffix -> test that a file's bytes are not truncated
    ".png": lambda data: data.endswith(b"IEND\xaeB`\x82"),
    ".jpg": lambda data: data.endswith(b"\xff\xd9"),
    ".exr": _exr_ends,
    ".webp": lambda data: data[4:8] == struct.pack("<I", max(len(data) - 8, 0)),  # Blender 4.3 fills up what is missing
}
