# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the papers of addon/papers: python3 blender_scripts/make_papers.py [FOLDER]

Each is a gray PNG of heights (white: high) that tiles seamlessly in both directions. A texel covers about one reference
pixel. Seeds are fixed: every run writes the same files.
"""

import sys
from pathlib import Path

import numpy as np
from make_textures import smoothstep, write_png

SIZE = 384  # texels along a side
LEVELS = 48  # gray levels; quantization halves the size of the files


class Sheet:
    """One tile of a paper, x and y in texels; all noise is periodic in it."""

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)
        self.x = (np.arange(SIZE) + 0.5)[None, :]
        self.y = (np.arange(SIZE) + 0.5)[:, None]
        self.fx = np.fft.rfftfreq(SIZE)[None, :]
        self.fy = np.fft.fftfreq(SIZE)[:, None]

    def shaped(self, response):
        """Periodic noise of mean 0 and deviation 1: white noise filtered by a frequency response."""
        spectrum = np.fft.rfft2(self.random.standard_normal((SIZE, SIZE)))
        noise = np.fft.irfft2(spectrum * response, s=(SIZE, SIZE))
        return (noise - noise.mean()) / noise.std()

    def clouds(self, along_x, along_y=None):
        """Low-pass noise: features larger than so many texels along each axis."""
        radius = np.hypot(self.fx * along_x, self.fy * (along_y or along_x))
        return self.shaped(np.exp(-2 * radius**2))

    def grain(self, size):
        """High-pass noise: features smaller than so many texels. Band-pass noise would show worm-like contours;
        including all higher frequencies breaks them up, except the very highest, which would show as checkerboards."""
        square = self.fx**2 + self.fy**2
        return self.shaped((1 - np.exp(-2 * square * size**2)) * np.exp(-4 * square))

    def blurred(self, height, width):
        """Heights blurred by a Gaussian of so many texels, normalized to mean 0 and deviation 1."""
        soft = np.exp(-2 * (np.pi * width) ** 2 * (self.fx**2 + self.fy**2))
        height = np.fft.irfft2(np.fft.rfft2(height) * soft, s=height.shape)
        return (height - height.mean()) / height.std()

    def pebbles(self, apart):
        """Round bumps with creases between them, as felt presses them: the upper envelope of paraboloids about so many
        texels apart, of random size, height and eccentricity."""
        height = np.full((SIZE, SIZE), -np.inf)
        reach = np.arange(-int(2.5 * apart), int(2.5 * apart) + 1)
        for x, y in self.scattered(apart):
            radius, top = apart * np.exp(self.random.normal(0, 0.2)), self.random.normal(0, 0.3)
            angle, longer = self.random.uniform(0, np.pi), self.random.uniform(1, 1.3)
            columns, rows = int(x) + reach, int(y) + reach
            dx, dy = (columns + 0.5 - x)[None, :] / radius, (rows + 0.5 - y)[:, None] / radius
            along, across = dx * np.cos(angle) + dy * np.sin(angle), dy * np.cos(angle) - dx * np.sin(angle)
            place = np.ix_(rows % SIZE, columns % SIZE)
            height[place] = np.maximum(height[place], top - (along / longer) ** 2 - (across * longer) ** 2)
        return self.blurred(height, 0.6)

    def scattered(self, apart):
        """(n, 2) positions x, y of a periodic Poisson-disk sample with that minimum distance in texels, by dart
        throwing."""
        free, found = np.ones((SIZE, SIZE), bool), []
        reach = np.arange(-int(apart), int(apart) + 1)
        near = np.hypot(reach[:, None], reach[None, :]) < apart
        for place in self.random.permutation(SIZE * SIZE):
            y, x = divmod(int(place), SIZE)
            if free[y, x]:
                found.append((x, y))
                free[np.ix_((y + reach) % SIZE, (x + reach) % SIZE)] &= ~near
        return np.array(found) + self.random.uniform(0, 1, (len(found), 2))

    def fibres(self, count, length, width, bend):
        """`count` thin curved fibers, combined by the maximum; `length` and blur `width` in texels, `bend` in radians
        per texel."""
        height = np.zeros((SIZE, SIZE))
        steps = np.arange(-length / 2, length / 2, 0.5)
        for _ in range(count):
            at, angle = self.random.uniform(0, SIZE, 2), self.random.uniform(0, np.pi)
            turned = angle + self.random.normal(0, bend) * steps + self.random.normal(0, bend / 12) * steps**2
            x, y = at[0] + np.cumsum(np.cos(turned)) / 2, at[1] + np.cumsum(np.sin(turned)) / 2
            ends = 1 - (2 * np.abs(steps) / length) ** 4
            np.maximum.at(height, (np.floor(y).astype(int) % SIZE, np.floor(x).astype(int) % SIZE), ends)
        return self.blurred(height, width)


def cold_press():
    """Watercolor paper: coarse and fine felt marks, and grain."""
    s = Sheet(11)
    return s.pebbles(4.5) + 0.5 * s.pebbles(8) + 0.8 * s.grain(7) + 0.1 * s.clouds(60)


def rough():
    """Handmade paper: deeper, coarser and more uneven than cold press."""
    s = Sheet(12)
    return s.pebbles(6.5) + 0.5 * s.pebbles(12) + 0.5 * s.pebbles(3.5) + 0.8 * s.grain(8) + 0.15 * s.clouds(80)


def laid():
    """Laid paper: close wire lines in one direction, sparse chain lines in the other."""
    s = Sheet(13)
    sway = 0.5 * s.clouds(50)
    wires = np.cos(2 * np.pi * (s.y + 0.8 * sway) / 6)
    chains = np.exp(-(((s.x + sway) % 96 - 48) ** 2) / 12)
    return 0.7 * wires * (1 + 0.25 * s.clouds(30)) + 1.1 * chains + 0.5 * s.grain(6) + 0.3 * s.pebbles(6)


def canvas():
    """Plain weave of warp and weft threads."""
    s = Sheet(14)
    pitch = 8
    slub_x, slub_y = 0.35 * s.clouds(40, 8), 0.35 * s.clouds(8, 40)
    u, v = (s.x + 0.5 * s.clouds(40)) / pitch, (s.y + 0.5 * s.clouds(40)) / pitch
    over = np.cos(np.pi * u) * np.cos(np.pi * v)
    warp = np.abs(np.sin(np.pi * u)) * (1 + 0.6 * over + 0.3 * slub_y)
    weft = np.abs(np.sin(np.pi * v)) * (1 - 0.6 * over + 0.3 * slub_x)
    return np.maximum(warp, weft) + 0.06 * s.grain(4)


def kraft():
    """Wrapping paper: fibers in random directions."""
    s = Sheet(15)
    threads = s.fibres(1400, 26, 0.8, 0.03) + 0.6 * s.fibres(900, 12, 0.7, 0.05)
    return 0.7 * threads + 0.5 * s.grain(6) + 0.5 * s.pebbles(5) + 0.3 * s.clouds(24)


def bristol():
    """Smooth board: fine grain only."""
    s = Sheet(16)
    return s.grain(5) + 0.6 * s.pebbles(3) + 0.15 * s.clouds(40)


PAPERS = (cold_press, rough, laid, canvas, kraft, bristol)


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for make in PAPERS:
        height = make()
        low, high = np.quantile(height, (0.002, 0.998))
        relief = smoothstep(-0.2, 1.2, (height - low) / (high - low))
        write_png(folder / f"{make.__name__}.png", np.round(relief * LEVELS) / LEVELS)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent.parent / "addon" / "papers")
