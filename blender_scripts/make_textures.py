# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pen textures of addon/textures: python3 blender_scripts/make_textures.py [FOLDER]

Each is a gray PNG (white: full ink): columns run along the stroke and tile seamlessly, rows run across it from its left
side to its right. All have as many texels per pen width along as across, so that grain is isotropic on paper;
textures.json has the length of each, in pen widths. Seeds are fixed: every run writes the same files.
"""

import json
import struct
import sys
import zlib
from pathlib import Path

import numpy as np

ROWS = 32  # texels across the pen
LEVELS = 48  # gray levels; quantization makes their files smaller
LONG = 64  # pen widths after which an irregular texture repeats


def smoothstep(low, high, x):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


class Canvas:
    """One period of a texture, `length` pen widths long; x and y in pen widths, y in [-.5, .5] across the pen."""

    def __init__(self, length, seed=0):
        self.length = length
        self.columns = length * ROWS
        self.random = np.random.default_rng(seed)
        self.x = (np.arange(self.columns) + 0.5)[None, :] / ROWS
        self.y = 0.5 - (np.arange(ROWS) + 0.5)[:, None] / ROWS

    def grain(self, size_along, size_across):
        """Noise of mean 0 and deviation 1 with features of all sizes up to the given ones in pen widths; periodic along
        the stroke. Larger frequencies have less power, none stands out: features of one size would look like worms."""
        rows = ROWS * 2
        spectrum = np.fft.rfft2(self.random.standard_normal((rows, self.columns)))
        f = np.fft.fftfreq(rows, 1 / ROWS)[:, None] * size_across
        g = np.fft.rfftfreq(self.columns, 1 / ROWS)[None, :] * size_along
        noise = np.fft.irfft2(spectrum * (1 + f**2 + g**2) ** -0.6, s=(rows, self.columns))[:ROWS]
        return (noise - noise.mean()) / noise.std()

    def wander(self, size):
        """(1, columns) low-pass noise along the stroke, for variations of pressure; `size` in pen widths."""
        spectrum = np.fft.rfft(self.random.standard_normal(self.columns))
        f = np.fft.rfftfreq(self.columns, 1 / ROWS) * size
        noise = np.fft.irfft(spectrum * np.exp(-2 * f**2), n=self.columns)
        return ((noise - noise.mean()) / noise.std())[None, :]

    def between_edges(self, left, right, softness):
        """Coverage between two edges, given along the stroke as distances from its center line; `softness`: width of
        the transition. All in pen widths."""
        return smoothstep(-softness, softness, left - self.y) * smoothstep(-softness, softness, right + self.y)

    def capsules(self, *spans):
        """Capsules with the pen's width, from one x to another (x is periodic), antialiased over one texel."""
        result = np.zeros((ROWS, self.columns))
        for start, end in spans:
            half, middle = (end - start) / 2, (end + start) / 2
            away = np.abs((self.x - middle + self.length / 2) % self.length - self.length / 2)
            beyond = np.maximum(away - half, 0)
            result = np.maximum(result, np.clip((0.5 - np.hypot(beyond, self.y)) * ROWS + 0.5, 0, 1))
        return result


def solid():
    return Canvas(1), np.ones((ROWS, ROWS))


# Dry pens: their shape and pressure, and little grain of their own, since the tooth of the paper breaks them up.


def pencil():
    """Graphite: fine grain, fading towards the sides."""
    c = Canvas(LONG, seed=1)
    pressure = 0.9 + 0.06 * c.wander(3.0) + 0.06 * c.wander(0.7)
    profile = 1 - np.abs(2 * (c.y + 0.03 * c.wander(2.0))) ** 3
    return c, 0.94 * smoothstep(-0.5, 0.82, pressure * profile - 0.34 + 0.2 * c.grain(0.5, 0.3))


def charcoal():
    """Soft black: full in the middle, ragged and crumbling at the sides."""
    c = Canvas(LONG, seed=2)
    pressure = 0.9 + 0.08 * c.wander(5.0) + 0.06 * c.wander(1.2)
    half = 0.42 + 0.03 * c.wander(1.5)
    profile = 1 - smoothstep(0.5, 1.15, np.abs(c.y) / half)
    return c, smoothstep(0, 1.15, pressure * profile + 0.06 * c.grain(1.0, 0.3))


def smudge():
    """Charcoal wiped with a finger: soft sides, streaks along the stroke."""
    c = Canvas(LONG, seed=7)
    profile = np.cos(np.pi * np.clip(c.y * (1 + 0.06 * c.wander(4.0)), -0.5, 0.5)) ** 2
    return c, np.clip(profile * (0.78 + 0.1 * c.wander(6.0) + 0.08 * c.grain(6.0, 0.3)), 0, 1)


def ink():
    """A nib: full black, slightly varying width, sharp and slightly rough edges."""
    c = Canvas(LONG, seed=3)
    breath = 0.455 + 0.016 * c.wander(7.0)
    left = breath + 0.020 * c.wander(1.6) + 0.009 * c.wander(0.35)
    right = breath + 0.020 * c.wander(1.6) + 0.009 * c.wander(0.35)
    return c, c.between_edges(np.minimum(left, 0.5), np.minimum(right, 0.5), 0.035)


def brush():
    """A dry brush: varying edges, and hair streaks without ink."""
    c = Canvas(LONG, seed=4)
    body = 0.44 + 0.03 * c.wander(6.0)
    shape = c.between_edges(body + 0.02 * c.wander(1.0), body + 0.02 * c.wander(1.0), 0.05)
    hairs = 0.8 * c.grain(9.0, 0.10) + 0.35 * c.grain(2.0, 0.07) + 0.25 * c.grain(0.2, 0.12)
    dryness = smoothstep(-0.6, 1.8, c.wander(9.0)) * (0.35 + 1.3 * np.abs(c.y))
    return c, shape * smoothstep(-0.16, 0.16, 0.55 - 0.75 * dryness + 0.30 * hairs)


def chalk():
    """Dusty: gaps from the board's grain everywhere, ragged sides."""
    c = Canvas(LONG, seed=8)
    half = 0.46 + 0.02 * c.wander(1.2)
    profile = 1 - smoothstep(0.72, 1.08, np.abs(c.y) / half)
    board = c.grain(0.45, 0.4)
    return c, 0.92 * smoothstep(-0.25, 0.42, (0.66 + 0.06 * c.wander(3.0)) * profile - 0.36 + 0.28 * board)


def marker():
    """Felt tip: uniform and slightly translucent, darker along its sides, where ink pools."""
    c = Canvas(LONG, seed=6)
    shape = c.between_edges(0.475 + 0.008 * c.wander(1.0), 0.475 + 0.008 * c.wander(1.0), 0.03)
    pool = smoothstep(0.28, 0.44, np.abs(c.y))
    felt = 0.02 * c.grain(6.0, 0.14) + 0.012 * c.grain(0.2, 0.2)
    return c, shape * np.clip(0.80 + 0.14 * pool + felt, 0, 1)


# Textures with gaps have a dash centered at u = 0, which is the middle of every path, so that short paths stay visible.


def dashes():
    c = Canvas(8)
    return c, c.capsules((-2.5, 2.5))


def dots():
    c = Canvas(2)
    return c, c.capsules((0.0, 0.0))


def dash_dot():
    """The center line of technical drawings."""
    c = Canvas(14)
    return c, c.capsules((-4.0, 4.0), (7.0, 7.0))


TEXTURES = (solid, pencil, charcoal, smudge, ink, brush, chalk, marker, dashes, dots, dash_dot)


def write_png(path, gray):
    """An 8-bit gray PNG of values in [0, 1]."""
    pixels = (np.clip(gray, 0, 1) * 255 + 0.5).astype(np.uint8)
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    header = struct.pack(">IIBBBBB", pixels.shape[1], pixels.shape[0], 8, 0, 0, 0, 0)
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
    )


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    lengths = {}
    for make in TEXTURES:
        canvas, texture = make()
        write_png(folder / f"{make.__name__}.png", np.round(texture * LEVELS) / LEVELS)
        lengths[make.__name__] = {"length_in_widths": canvas.length}
    (folder / "textures.json").write_text(json.dumps(lengths, indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent.parent / "addon" / "textures")
