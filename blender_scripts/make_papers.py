"""Makes the papers of addon/papers: python3 blender_scripts/make_papers.py [FOLDER]

Each is a grey PNG of heights, white is high, that repeats without a seam on all sides. A texel is meant to cover about
one reference pixel. Seeds are fixed: every run makes the same files.
"""

import sys
from pathlib import Path

import numpy as np
from make_textures import smoothstep, write_png

SIZE = 384  # texels along a side
LEVELS = 48  # heights are told apart no finer: files are half as large


class Sheet:
    """One repetition of a paper, x and y in texels; all noise repeats with it."""

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)
        self.x = (np.arange(SIZE) + 0.5)[None, :]
        self.y = (np.arange(SIZE) + 0.5)[:, None]
        self.fx = np.fft.rfftfreq(SIZE)[None, :]
        self.fy = np.fft.fftfreq(SIZE)[:, None]

    def shaped(self, response):
        """Noise of mean 0 and deviation 1 whose spectrum is the response's."""
        spectrum = np.fft.rfft2(self.random.standard_normal((SIZE, SIZE)))
        noise = np.fft.irfft2(spectrum * response, s=(SIZE, SIZE))
        return (noise - noise.mean()) / noise.std()

    def bumps(self, along_x, along_y=None):
        """Bumps of one size, so many texels large."""
        radius = np.hypot(self.fx * along_x, self.fy * (along_y or along_x))
        return self.shaped(radius * np.exp(-2 * radius**2))

    def clouds(self, size):
        """Everything that is larger than so many texels."""
        return self.shaped(np.exp(-2 * (np.hypot(self.fx, self.fy) * size) ** 2))

    def fibres(self, count, length, width, bend):
        """Thin curved threads lying over each other, each as high as it is thick."""
        height = np.zeros((SIZE, SIZE))
        steps = np.arange(-length / 2, length / 2, 0.5)
        for _ in range(count):
            at, angle = self.random.uniform(0, SIZE, 2), self.random.uniform(0, np.pi)
            turned = angle + self.random.normal(0, bend) * steps + self.random.normal(0, bend / 12) * steps**2
            x, y = at[0] + np.cumsum(np.cos(turned)) / 2, at[1] + np.cumsum(np.sin(turned)) / 2
            ends = 1 - (2 * np.abs(steps) / length) ** 4
            np.maximum.at(height, (np.floor(y).astype(int) % SIZE, np.floor(x).astype(int) % SIZE), ends)
        soft = np.exp(-2 * (np.pi * width) ** 2 * (self.fx**2 + self.fy**2))
        blurred = np.fft.irfft2(np.fft.rfft2(height) * soft, s=height.shape)
        return (blurred - blurred.mean()) / blurred.std()


def cold_press():
    """Watercolour paper: soft irregular bumps of the felt, and a fine tooth on them."""
    s = Sheet(11)
    felt = 0.9 * s.bumps(9) + 0.6 * s.bumps(5.5)
    # Hollows are rounder than what lies between them.
    return np.tanh(0.9 * felt) + 0.3 * s.bumps(3) + 0.12 * s.clouds(60)


def rough():
    """Handmade: deep, uneven hollows."""
    s = Sheet(12)
    felt = s.bumps(15) + 0.75 * s.bumps(9) + 0.45 * s.bumps(5)
    return np.tanh(0.8 * felt) + 0.35 * s.bumps(3) + 0.15 * s.clouds(80)


def laid():
    """The wires of the mould: close lines one way, the few chains that hold them the other."""
    s = Sheet(13)
    sway = 0.5 * s.clouds(50)
    wires = np.cos(2 * np.pi * (s.y + 0.8 * sway) / 6)
    chains = np.exp(-(((s.x + sway) % 96 - 48) ** 2) / 12)
    return 0.7 * wires * (1 + 0.25 * s.clouds(30)) + 1.1 * chains + 0.5 * s.bumps(4) + 0.3 * s.bumps(11)


def canvas():
    """Plain weave: threads that pass over and under each other."""
    s = Sheet(14)
    pitch = 8
    slub_x, slub_y = 0.35 * s.bumps(40, 8), 0.35 * s.bumps(8, 40)
    u, v = (s.x + 0.5 * s.clouds(40)) / pitch, (s.y + 0.5 * s.clouds(40)) / pitch
    over = np.cos(np.pi * u) * np.cos(np.pi * v)
    warp = np.abs(np.sin(np.pi * u)) * (1 + 0.6 * over + 0.3 * slub_y)
    weft = np.abs(np.sin(np.pi * v)) * (1 - 0.6 * over + 0.3 * slub_x)
    return np.maximum(warp, weft) + 0.06 * s.bumps(3)


def kraft():
    """Wrapping paper: fibres that lie every way."""
    s = Sheet(15)
    threads = s.fibres(1400, 26, 0.8, 0.03) + 0.6 * s.fibres(900, 12, 0.7, 0.05)
    return 0.6 * threads + 0.7 * s.bumps(4) + 0.5 * s.bumps(8) + 0.3 * s.clouds(24)


def bristol():
    """Smooth board: nothing but a fine tooth."""
    s = Sheet(16)
    return s.bumps(3.4) + 0.6 * s.bumps(5.5) + 0.3 * s.clouds(40)


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
