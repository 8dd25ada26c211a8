# SPDX-License-Identifier: GPL-3.0-or-later
"""PNG files of black and white alone, a bit for each pixel."""

import struct
import zlib

import numpy as np

SIGNATURE = b"\x89PNG\r\n\x1a\n"
GRAY, NO_FILTER = 0, 0
INCH = 0.0254  # meters


def file_of(white, dpi):
    """The bytes of a file. `white`: (H, W) uint8, bottom row first: 1 is white, 0 black; `dpi`: pixels per inch."""
    height, width = white.shape
    rows = np.packbits(white[::-1], axis=1)
    filtered = np.insert(rows, 0, NO_FILTER, axis=1)
    per_meter = round(dpi / INCH)
    chunks = [
        (b"IHDR", struct.pack(">IIBBBBB", width, height, 1, GRAY, 0, 0, 0)),
        (b"pHYs", struct.pack(">IIB", per_meter, per_meter, 1)),
        (b"IDAT", zlib.compress(filtered.tobytes(), 9)),
        (b"IEND", b""),
    ]
    return SIGNATURE + b"".join(_chunk(name, content) for name, content in chunks)


def _chunk(name, content):
    return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
