# SPDX-License-Identifier: GPL-3.0-or-later
"""PNG files of pictures: what is written, and the pixels that files store."""

import struct
import zlib

import numpy as np
import pytest
from native_core import core


def test_the_file_has_the_size_of_the_picture():
    data = core.png_bytes(np.zeros((5, 7, 3), np.uint8))
    assert data[1:4] == b"PNG" and struct.unpack(">II", data[16:24]) == (7, 5)


@pytest.mark.parametrize("shape", [(0, 3, 3), (3, 0, 3), (4, 4), (4, 4, 4)])
def test_what_is_no_picture_is_refused(shape):
    with pytest.raises(ValueError):
        core.png_bytes(np.zeros(shape, np.uint8))


def chunks(data):
    """[(kind, body)] of a PNG file."""
    found, at = [], 8
    while at < len(data):
        (size,) = struct.unpack(">I", data[at : at + 4])
        found.append((data[at + 4 : at + 8], data[at + 8 : at + 8 + size]))
        at += 12 + size
    return found


def file_of(parts):
    whole = (
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body)) for kind, body in parts
    )
    return b"\x89PNG\r\n\x1a\n" + b"".join(whole)


NOISE = np.random.default_rng(1).integers(0, 256, (13, 21, 3), np.uint8)


def stored(data):
    image = core.stored_png(data)
    return (image.width, image.height, image.channels, image.bits), image.values


def test_stored_pixels_are_those_that_were_written():
    assert stored(core.png_bytes(NOISE)) == ((21, 13, 3, 8), NOISE[::-1].tobytes())


def test_values_of_sixteen_bits_are_kept():
    values = np.arange(6, dtype=">u2") * 9999
    rows = b"".join(b"\0" + row.tobytes() for row in values.reshape(3, 2))
    header = struct.pack(">IIBBBBB", 2, 3, 16, 0, 0, 0, 0)
    data = file_of([(b"IHDR", header), (b"IDAT", zlib.compress(rows)), (b"IEND", b"")])
    assert stored(data) == ((2, 3, 1, 16), values.tobytes())


def test_stored_pixels_do_not_depend_on_what_else_the_file_says_nor_on_its_compression():
    data = core.png_bytes(NOISE)
    parts = chunks(data)
    pixels = zlib.decompress(b"".join(body for kind, body in parts if kind == b"IDAT"))
    said = (b"tEXt", b"Date\0today")
    other = file_of([parts[0], said, (b"IDAT", zlib.compress(pixels, 0)), (b"IEND", b"")])
    assert other != data and stored(other) == stored(data)


def test_a_file_that_breaks_off_or_has_a_wrong_bit_is_refused():
    data = core.png_bytes(NOISE)
    for kept in range(len(data)):
        with pytest.raises(ValueError, match="broken"):
            core.stored_png(data[:kept])
    for place in range(8 * 8, 8 * len(data), 37):
        wrong = bytearray(data)
        wrong[place // 8] ^= 1 << place % 8
        with pytest.raises(ValueError, match="broken"):
            core.stored_png(bytes(wrong))


def test_a_header_that_promises_too_many_pixels_is_refused():
    header = struct.pack(">IIBBBBB", 900_000, 900_000, 16, 6, 0, 0, 0)
    with pytest.raises(ValueError, match="broken"):
        core.stored_png(file_of([(b"IHDR", header), (b"IDAT", zlib.compress(b"")), (b"IEND", b"")]))
