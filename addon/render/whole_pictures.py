# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of pictures that Blender writes: on a full disk it reports success for most formats, so they are read."""

import hashlib
import struct

import bpy

from .. import native


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


def pixels_sha256(path):
    """Hash, in hexadecimal, of the pixels that a file stores, whatever else is in it; None if it is not whole. Between
    the frames of a render, too, where Blender crashes when an image is removed. Of OpenEXR files it is that of the
    compressed pixels, of files other than these and PNG that of the file."""
    try:
        data = path.read_bytes()
        if not ENDS.get(path.suffix.lower(), bool)(data):
            return None
        stored = STORED.get(data[:4], lambda data: [data])(data)
    except (IndexError, ValueError, struct.error, FileNotFoundError):
        return None
    return hashlib.sha256(b"".join(stored)).hexdigest()


def _png_pixels(data):
    stored = native.load().stored_png(data)
    return struct.pack("<4I", stored.width, stored.height, stored.channels, stored.bits), stored.values


def _exr_blocks(data):
    """The chunks of an OpenEXR file, in the order of its table. A header is a list of attributes (name, type, size,
    value); a file of several parts has several, and an empty one after them. Then follow the offsets of all chunks (8
    bytes each, 0 until written) and the chunks: the part's number if there are several, and two 32-bit integers, the
    second of which is the size of the data after them. IndexError, ValueError or struct.error if the file breaks off
    before the end of a chunk."""
    at, has_parts = 8, data[5] & 0x10
    while data[at]:
        while data[at]:
            size_at = data.index(0, data.index(0, at) + 1) + 1
            at = size_at + 4 + struct.unpack_from("<I", data, size_at)[0]
        at += bool(has_parts)
    table = at + 1
    (first,) = struct.unpack_from("<Q", data, table)
    blocks = []
    for place in struct.unpack_from(f"<{(first - table) // 8}Q", data, table):
        size_at = place + (8 if has_parts else 4)
        end = size_at + 4 + struct.unpack_from("<I", data, size_at)[0]
        if not table < place < end <= len(data):
            raise ValueError
        blocks.append(data[place:end])
    return blocks


def _exr_ends(data):
    try:
        return sum(map(len, _exr_blocks(data))) > 0
    except (IndexError, ValueError, struct.error):
        return False


ENDS = {  # suffix -> test that a file's bytes are not truncated
    ".png": lambda data: data.endswith(b"IEND\xaeB`\x82"),
    ".jpg": lambda data: data.endswith(b"\xff\xd9"),
    ".exr": _exr_ends,
    ".webp": lambda data: data[4:8] == struct.pack("<I", max(len(data) - 8, 0)),  # Blender 4.3 fills up what is missing
}

STORED = {b"\x89PNG": _png_pixels, b"v/1\x01": _exr_blocks}  # first bytes of a file -> what is hashed of its bytes
