# SPDX-License-Identifier: GPL-3.0-or-later
"""The bundled papers and washes: equal to the script's output, seamless, even, and without worms or repetitions that
show."""

import importlib.util
import json
import sys
from pathlib import Path

import numpy as np
import pytest
from test_textures import read_png

PROJECT = Path(__file__).parents[2]
ADDON = PROJECT / "addon"
SCRIPT = PROJECT / "blender_scripts" / "make_papers.py"
NAMES = [
    f"{path.parent.name}/{path.stem}" for kind in ("papers", "washes") for path in sorted((ADDON / kind).glob("*.png"))
]
PAPERS = [name for name in NAMES if name.startswith("papers/")]
OF_FIBRES = [name for name in PAPERS if not name.endswith(("laid", "canvas"))]  # those have wires and threads


def heights(name):
    return read_png(ADDON / f"{name}.png")


def tile_mm(name):
    kind, of = name.split("/")
    return json.loads((ADDON / kind / f"{kind}.json").read_text())[of]["tile_mm"]


def quantiles(values):
    """The share of the tile that lies lower, as paper is drawn by; ties get the middle of theirs."""
    _, which, counts = np.unique(values, return_inverse=True, return_counts=True)
    return ((np.cumsum(counts) - counts / 2) / values.size)[which].reshape(values.shape)


def spectrum(picture):
    """(frequencies in cycles per tile, power), radially averaged over quarters of octaves, from 12 cycles on: below,
    there are too few waves."""
    power = np.abs(np.fft.fft2(picture - picture.mean())) ** 2
    cycles = np.fft.fftfreq(len(picture)) * len(picture)
    radius = np.hypot(cycles[:, None], cycles[None, :])
    middles = 12 * 2 ** np.arange(0, np.log2(len(picture) / 2 / 12), 0.25)
    return middles, np.array([power[np.abs(np.log2(np.maximum(radius, 1) / at)) < 0.125].mean() for at in middles])


def coherence(picture, window=2.0):
    """In [0, 1], how far all contours within about so many texels run the same way: that of the structure tensor, which
    is 1 for stripes. The picture repeats on all sides."""
    f = np.fft.fftfreq(len(picture))
    soft = np.exp(-2 * (np.pi * window) ** 2 * (f[:, None] ** 2 + f[None, : len(f) // 2 + 1] ** 2))
    dy, dx = (np.roll(picture, -1, axis) - np.roll(picture, 1, axis) for axis in (0, 1))
    xx, yy, xy = (np.fft.irfft2(np.fft.rfft2(part) * soft, s=picture.shape) for part in (dx * dx, dy * dy, dx * dy))
    return np.hypot(xx - yy, 2 * xy).sum() / (xx + yy).sum()


def test_there_are_papers_with_their_sizes():
    assert {"papers/cold_press", "papers/rough", "papers/laid", "papers/canvas", "papers/kraft"} <= set(PAPERS)
    for kind in ("papers", "washes"):
        assert {f"{kind}/{name}" for name in json.loads((ADDON / kind / f"{kind}.json").read_text())} <= set(NAMES)
    assert all(50 <= tile_mm(name) <= 300 for name in NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_a_tile_repeats_without_a_seam(name):
    sheet = heights(name)
    assert sheet.shape[0] == sheet.shape[1] and np.ptp(sheet) > 150
    for along in (sheet, sheet.T):
        steps = np.abs(np.diff(along, axis=1)).mean(axis=0)
        assert np.abs(along[:, 0] - along[:, -1]).mean() <= 1.25 * np.quantile(steps, 0.95)


@pytest.mark.parametrize("name", OF_FIBRES)
def test_no_frequency_stands_out(name):
    """A ring in the spectrum would be worms: the power is nowhere 1.4 times the mean of that half an octave below and
    above, and does not rise with the frequency."""
    _, power = spectrum(quantiles(heights(name)))
    assert (power[2:-2] < 1.4 * np.sqrt(power[:-4] * power[4:])).all()
    assert (power[2:] < 1.2 * power[:-2]).all()


@pytest.mark.parametrize("name", OF_FIBRES)
def test_ink_breaks_up_into_specks_and_not_into_worms(name):
    lower = quantiles(heights(name))
    for share in (0.2, 0.5, 0.7):
        assert coherence((lower > share).astype(float)) < 0.26, share


@pytest.mark.parametrize("name", PAPERS)
def test_tone_is_even_all_over_a_paper(name):
    """The mean over squares of a tenth of a tile, about 8 mm, is the paper's own: a spot would show wherever the tile
    repeats."""
    lower = quantiles(heights(name))
    side = len(lower) // 10
    squares = lower[: 10 * side, : 10 * side].reshape(10, side, 10, side).mean((1, 3))
    assert np.abs(squares - 0.5).max() < 0.12
    assert lower.mean() == pytest.approx(0.5, abs=1e-9)


@pytest.mark.parametrize("name", OF_FIBRES)
def test_nothing_repeats_within_a_paper(name):
    """The autocorrelation beyond 5 mm."""
    lower = quantiles(heights(name)) - 0.5
    correlation = np.fft.ifft2(np.abs(np.fft.fft2(lower)) ** 2).real
    step = np.minimum(np.arange(len(lower)), len(lower) - np.arange(len(lower))) * tile_mm(name) / len(lower)
    far = np.hypot(step[:, None], step[None, :]) > 5
    assert np.abs(correlation[far]).max() < 0.05 * correlation[0, 0]


@pytest.mark.parametrize("name, across, along", [("papers/laid", 72, 0), ("papers/canvas", 64, 0)])
def test_wires_and_threads_are_as_close_as_real_ones(name, across, along):
    """The strongest wave away from the lowest has so many cycles per tile down and along: wires 1.2 mm apart, threads
    1.3 mm."""
    power = np.abs(np.fft.fft2(quantiles(heights(name)) - 0.5)) ** 2
    power[:10, :10] = power[-9:, :10] = power[:10, -9:] = power[-9:, -9:] = 0
    row, column = np.unravel_index(power.argmax(), power.shape)
    assert abs(min(row, len(power) - row) - across) <= 2 and abs(min(column, len(power) - column) - along) <= 2


@pytest.mark.skipif(not SCRIPT.exists(), reason="only in the checkout")
def test_the_script_makes_them(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "path", [str(SCRIPT.parent), *sys.path])
    spec = importlib.util.spec_from_file_location("make_papers", SCRIPT)
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    script.main(tmp_path)
    made = {f"{path.parent.name}/{path.stem}" for path in tmp_path.glob("*/*.png")}
    assert made == set(NAMES)
    for name in NAMES:
        difference = np.abs(read_png(tmp_path / f"{name}.png") - heights(name))
        # A step between two levels where the machine rounds otherwise.
        assert difference.max() <= 9 and (difference > 0).mean() < 1e-3, f"{name}: run blender_scripts/make_papers.py"
    for kind in ("papers", "washes"):
        assert (tmp_path / kind / f"{kind}.json").read_text() == (ADDON / kind / f"{kind}.json").read_text()
