# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes addon/papers and addon/washes: python3 blender_scripts/make_papers.py [FOLDER]

Each is a gray PNG of heights (white: high) that tiles seamlessly in both directions; papers.json and washes.json have
the side of each tile in millimeters. Papers are modelled on how paper is made: fibers laid down at random, pressed by
felts, wires or threads. Power falls steadily from low to high frequencies: a ring of one frequency would show as worms
wherever ink follows a contour of height, or light its slope. Of a wash, high is where water leaves least pigment. Seeds
are fixed: every run writes the same files.
"""

import json
import sys
from pathlib import Path

import numpy as np
from make_textures import smoothstep, write_png

# (side of a tile in mm, texels along it). A texel of paper covers a pixel of a picture 1080 high on a page of 210 mm.
PAPER, WASH = (84.0, 432), (252.0, 288)
LEVELS = 20  # gray levels; quantization halves the size of the files


class Sheet:
    """One tile of a paper; all lengths in mm, x and y the places of its texels. All its parts are periodic in the tile,
    and have mean 0 and deviation 1."""

    def __init__(self, seed, tile=PAPER):
        self.random = np.random.default_rng(seed)
        self.tile, self.size = tile
        self.step = step = self.tile / self.size
        self.x = ((np.arange(self.size) + 0.5) * step)[None, :]
        self.y = ((np.arange(self.size) + 0.5) * step)[:, None]
        self.frequency = np.hypot(np.fft.rfftfreq(self.size, step)[None, :], np.fft.fftfreq(self.size, step)[:, None])

    def filtered(self, height, response):
        height = np.fft.irfft2(np.fft.rfft2(height) * response, s=height.shape)
        return (height - height.mean()) / height.std()

    def noise(self, largest, slope):
        """Noise of all octaves below the wavelength `largest`: its power falls with the frequency to that slope. Above,
        it is flat, so that no cloud marks the repetition of the tile."""
        response = (1 + (self.frequency * largest) ** 2) ** (-slope / 4)
        return self.filtered(self.random.standard_normal((self.size, self.size)), response)

    def fibres(self, count, length, width):
        """The mass of thin fibers, slightly bent, of all directions and of various lengths and weights about
        `length`."""
        random, size, steps = self.random, self.size, int(np.ceil(3.2 * length / self.step))
        lengths = length * random.uniform(0.4, 1.6, (count, 1))
        along = (np.arange(steps) / steps - 0.5)[None, :] * lengths
        turned = random.uniform(0, 2 * np.pi, (count, 1)) + random.normal(0, 0.08, (count, 1)) * along
        turned += random.normal(0, 0.08, (count, 1)) * along**2 / length
        ends = [random.uniform(0, self.tile, (count, 1)) for _ in "xy"]
        x, y = (
            (end + np.cumsum(way(turned), axis=1) * lengths / steps) / self.step
            for end, way in zip(ends, (np.cos, np.sin))
        )
        weight = lengths * random.lognormal(0, 0.5, (count, 1)) * np.ones(steps)
        mass = np.zeros(size * size)
        for row in (np.floor(y), np.floor(y) + 1):
            for column in (np.floor(x), np.floor(x) + 1):
                texel = (row % size * size + column % size).astype(int)
                share = weight * (1 - np.abs(y - row)) * (1 - np.abs(x - column))
                mass += np.bincount(texel.ravel(), share.ravel(), size * size)
        return self.filtered(mass.reshape(size, size), np.exp(-2 * (np.pi * width * self.frequency) ** 2))

    def felt(self, smallest, largest):
        """Bumps of all sizes with creases between them, as felts press them: the upper envelope of paraboloids whose
        radii follow a power law (as many areas of each octave), of random height and eccentricity."""
        random, size, step = self.random, self.size, self.step
        radii = smallest * (smallest / largest) ** (-random.uniform(0, 1, 10**5))
        radii = radii[random.uniform(0, 1, radii.size) < (smallest / radii) ** 2]
        radii = radii[: np.searchsorted(np.cumsum(np.pi * radii**2), 4 * self.tile**2)]
        height = np.full((size, size), -np.inf)
        for radius in radii:
            x, y = random.uniform(0, self.tile, 2)
            top, angle, longer = random.normal(0, 0.6), random.uniform(0, np.pi), random.uniform(1, 1.4)
            reach = np.arange(-int(2.8 * radius / step) - 2, int(2.8 * radius / step) + 3)
            columns, rows = int(x / step) + reach, int(y / step) + reach
            dx, dy = ((columns + 0.5) * step - x)[None, :] / radius, ((rows + 0.5) * step - y)[:, None] / radius
            along, across = dx * np.cos(angle) + dy * np.sin(angle), dy * np.cos(angle) - dx * np.sin(angle)
            bump = radius**0.4 * (top - (along / longer) ** 2 - (across * longer) ** 2)
            place = np.ix_(rows % size, columns % size)
            height[place] = np.maximum(height[place], bump)
        return self.filtered(height, 1)


def cold_press():
    """Watercolor paper, pressed between felts."""
    s = Sheet(11)
    return s.felt(0.3, 1.4) + 0.4 * s.fibres(38000, 3, 0.05) + 0.75 * s.noise(1.6, 1.5)


def rough():
    """Handmade paper: deeper, coarser and more uneven than cold press."""
    s = Sheet(12)
    return s.felt(0.4, 2.0) + 0.35 * s.fibres(30000, 4, 0.05) + 0.8 * s.noise(2.4, 1.6)


def laid():
    """Laid paper: close wire lines in one direction, chain lines 28 mm apart in the other."""
    s = Sheet(13)
    sway = 0.12 * s.noise(20, 3)
    wires = np.cos(2 * np.pi * (s.y + sway) * 72 / s.tile)
    chains = np.exp(-((((s.x + 0.8 * sway) % 28 - 14) / 0.55) ** 2))
    return (
        0.5 * wires * (1 + 0.3 * s.noise(8, 2))
        + 0.9 * chains
        + 0.5 * s.fibres(30000, 3, 0.05)
        + 0.7 * s.noise(1.5, 1.2)
    )


def canvas():
    """Plain weave of warp and weft threads."""
    s = Sheet(14)
    u, v = ((at + 0.1 * s.noise(12, 2.5)) * 64 / s.tile for at in (s.x, s.y))
    over = np.cos(np.pi * u) * np.cos(np.pi * v)
    warp = np.abs(np.sin(np.pi * u)) * (1 + 0.6 * over + 0.15 * s.noise(6, 2))
    weft = np.abs(np.sin(np.pi * v)) * (1 - 0.6 * over + 0.15 * s.noise(6, 2))
    return np.maximum(warp, weft) + 0.15 * s.noise(1, 1)


def kraft():
    """Wrapping paper: long coarse fibers."""
    s = Sheet(15)
    return s.fibres(15000, 4, 0.07) + 0.9 * s.noise(3, 1.2)


def bristol():
    """Smooth board: short fibers, and fine grain."""
    s = Sheet(16)
    return 0.7 * s.fibres(50000, 1.5, 0.05) + s.noise(0.8, 1)


def water():
    """Flows of water in a wash, and backruns: where it ran back into drying paint, blooms without pigment, which lies
    in a crinkled rim around them."""
    s = Sheet(17, WASH)
    bloom = s.noise(40, 4.2) - 1
    rim = np.exp(-(((bloom + 0.1) / 0.13) ** 2))
    return 0.7 * s.noise(90, 3.4) + 0.9 * smoothstep(0, 0.7, bloom) - rim


KINDS = {"papers": (PAPER, (cold_press, rough, laid, canvas, kraft, bristol)), "washes": (WASH, (water,))}


def main(parent):
    for kind, ((tile_mm, _), makers) in KINDS.items():
        folder = parent / kind
        folder.mkdir(parents=True, exist_ok=True)
        for make in makers:
            height = make()
            low, high = np.quantile(height, (0.002, 0.998))
            relief = smoothstep(-0.2, 1.2, (height - low) / (high - low))
            write_png(folder / f"{make.__name__}.png", np.round(relief * LEVELS) / LEVELS)
        sizes = {make.__name__: {"tile_mm": tile_mm} for make in makers}
        (folder / f"{kind}.json").write_text(json.dumps(sizes, indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent.parent / "addon")
