# SPDX-License-Identifier: GPL-3.0-or-later
"""Papers: the bundled ones, and that ink and pigment on them keep their mean density."""

import importlib.util
import sys
from pathlib import Path

import numpy as np
import pytest
from native_core import Mesh, core, scene
from test_textures import read_png

from addon import pipeline, style
from addon.style import LineSet, Paper

PROJECT = Path(__file__).parents[2]
FOLDER = PROJECT / "addon" / "papers"
SCRIPT = PROJECT / "blender_scripts" / "make_papers.py"
NAMES = sorted(path.stem for path in FOLDER.glob("*.png"))
SIDE = 384
PAPER = Paper(color=(0.9, 0.8, 0.6))
NEAR, FAR = 0.1, 100.0


class Even(core.Backend):
    """Covers every picture with one color, premultiplied, as if it were strokes."""

    name = "even"

    def __init__(self, rgba):
        super().__init__()
        self._rgba = rgba

    def draw(self, frame, image):
        image[:] = self._rgba


def camera(width=SIDE, height=SIDE, left=0, lower=0):
    """Of a picture of which so much is seen; its axis meets the lower left corner of the whole picture, so that a
    paper's texels lie on pixels."""
    clip = np.diag([2 / width, 2 / height, -2 / (FAR - NEAR), 1]).astype(float)
    clip[:3, 3] = -1 - 2 * left / width, -1 - 2 * lower / height, -(FAR + NEAR) / (FAR - NEAR)
    return core.View(np.eye(4), clip, width, height, True, NEAR, FAR)


@pytest.fixture(params=NAMES)
def paper(request):
    return PAPER.replace(texture=request.param)


@pytest.fixture
def of_heights(tmp_path, monkeypatch):
    """A function from (SIDE, SIDE) heights to a Paper of them."""
    (tmp_path / "papers").mkdir()
    monkeypatch.setattr(pipeline, "_assets", lambda core: core.Assets(tmp_path))

    def make(heights, **amounts):
        rows = np.round(255 * heights[::-1]).astype(np.uint8)  # papers begin with the top row
        gray = np.repeat(rows[..., None], 3, axis=2)
        (tmp_path / "papers" / "heights.png").write_bytes(core.png_bytes(gray))
        return PAPER.replace(texture="heights", **amounts)

    return make


def drawn(paper, lines=(0, 0, 0, 0), layer=None, *, seen=None, background=None, usage=None):
    """(H, W, 4): a Paper under a sheet of an even color, premultiplied, or of none, under even lines."""
    corners = [(x, y, -5) for x, y in ((-9, -9), (999, -9), (999, 999), (-9, 999))]
    placed = scene([Mesh("sheet", corners, [(0, 1, 2, 3)]).surface()], usage=usage)
    chosen = style.Style(paper=paper, line_sets=(LineSet(kinds={"edge_mark": {}}),))
    sources = None
    if layer is not None:
        chosen = chosen.replace(color=style.Color(shading="flat", opacity=layer[3], background=background))
        base = tuple(value / layer[3] for value in layer[:3])
        sources = core.ColorSources([core.SurfaceColor([core.ColorSlot(base)])], [], (0, 0, 0))
    return pipeline.draw(placed, seen or camera(), chosen, Even(lines), pipeline.options(), colors=sources).combined


def test_there_are_papers():
    assert {"cold_press", "rough", "laid", "canvas", "kraft"} <= set(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_a_paper_repeats_without_a_seam(name):
    heights = read_png(FOLDER / f"{name}.png")
    assert heights.shape == (SIDE, SIDE) and heights.max() - heights.min() > 150
    for sheet in (heights, heights.T):
        steps = np.abs(np.diff(sheet, axis=1)).mean(axis=0)
        assert np.abs(sheet[:, 0] - sheet[:, -1]).mean() <= 1.25 * np.quantile(steps, 0.95)


def test_tooth_keeps_the_mean(paper):
    for opacity in (0.05, 0.3, 0.5, 0.8, 0.97):
        picture = drawn(paper.replace(tooth=1.0), (0, 0, 0, opacity))
        assert (picture[..., 0] / 0.9).mean() == pytest.approx(1 - opacity, abs=0.02)
        assert np.ptp(picture[..., 0]) > 0.1
    for opacity in (0.0, 1.0):
        assert np.ptp(drawn(paper.replace(tooth=1.0), (0, 0, 0, opacity))[..., 0]) == 0


def test_ink_stays_on_the_heights(of_heights):
    ramp = of_heights(np.linspace(0, 1, SIDE * SIDE).reshape(SIDE, SIDE), tooth=1.0, granulation=0.5)
    picture = drawn(ramp, (0, 0, 0, 0.5))[..., 0]
    assert picture[0].min() > 0.89 and picture[-1].max() < 0.01
    assert drawn(ramp, layer=(0.2, 0.2, 0.2, 1))[0, 0, 0] < 0.2


def test_pigment_keeps_its_density_in_the_mean(paper):
    picture = drawn(paper.replace(granulation=0.6), layer=(0.3, 0.4, 0.2, 1))
    density = -np.log(picture[..., :3] / np.array([0.9, 0.8, 0.6]))
    assert np.allclose(density.mean((0, 1)), -np.log(np.array([0.3 / 0.9, 0.4 / 0.8, 0.2 / 0.6])), rtol=0.02)
    assert np.ptp(density[..., 0]) > 0.3


def test_tint_keeps_the_mean(paper):
    picture = drawn(paper.replace(tint=0.2))
    assert picture[..., 0].mean() == pytest.approx(0.9, rel=0.01) and np.ptp(picture[..., 0]) > 0.2
    assert (picture[..., 3] == 1).all()


def test_relief_is_lit_from_the_upper_left(of_heights):
    """A dome: the side towards the light is brighter than flat paper, the other one darker; rows go upwards."""
    away = np.hypot(*(np.mgrid[:SIDE, :SIDE] - SIDE / 2)) / 100
    shade = drawn(of_heights(np.maximum(1 - away**2, 0), tint=0.2))[..., 0] / 0.9
    high, low, flat = SIDE // 2 + 40, SIDE // 2 - 40, shade[10, 10]
    assert shade[high, low] > flat + 0.1 and shade[low, high] < flat - 0.1
    assert shade[high, high] == pytest.approx(flat, abs=0.01)


def test_paper_without_relief_shades_nothing(of_heights):
    assert np.ptp(drawn(of_heights(np.ones((SIDE, SIDE)), tint=0.2))[..., 0]) == 0


def coherence(picture, window=2.0):
    """In [0, 1], how far all contours within about so many pixels run the same way: that of the structure tensor, which
    is 1 for stripes. The picture repeats on all sides."""
    f = np.fft.fftfreq(SIDE)
    soft = np.exp(-2 * (np.pi * window) ** 2 * (f[:, None] ** 2 + f[None, : SIDE // 2 + 1] ** 2))
    dy, dx = (np.roll(picture, -1, axis) - np.roll(picture, 1, axis) for axis in (0, 1))
    xx, yy, xy = (np.fft.irfft2(np.fft.rfft2(part) * soft, s=picture.shape) for part in (dx * dx, dy * dy, dx * dy))
    return np.hypot(xx - yy, 2 * xy).sum() / (xx + yy).sum()


@pytest.mark.parametrize("name", ["bristol", "cold_press", "rough"])
def test_ink_breaks_up_into_specks_and_not_into_worms(name):
    """On papers without wires, threads or fibres."""
    for opacity in (0.3, 0.5, 0.8):
        picture = drawn(PAPER.replace(texture=name, tooth=1.0), (0, 0, 0, opacity))
        assert coherence(picture[..., 0]) < 0.26, opacity


def test_without_amounts_a_paper_is_its_color(paper):
    lines, layer = (0.1, 0.2, 0.1, 0.5), (0.1, 0.3, 0.2, 0.6)
    expected = np.array([0.9, 0.8, 0.6, 1.0])
    for over in (layer, lines):
        expected = np.array(over) + expected * (1 - over[3])
    assert np.allclose(drawn(paper, lines, layer), expected, atol=1e-6)


def test_opacity_background_and_no_paper():
    picture = drawn(PAPER, layer=(0.2, 0, 0, 0.25), background=(0, 1, 0))
    assert np.allclose(picture[0, 0], (0.2, 0.75, 0, 1), atol=1e-6)
    clear = drawn(PAPER.replace(transparent=True), (0.1, 0.1, 0.1, 0.5), (0.4, 0, 0, 0.5))
    assert np.allclose(clear[0, 0], (0.3, 0.1, 0.1, 0.75), atol=1e-6)


def test_holdouts_cut_the_paper():
    assert (drawn(PAPER, usage=[core.Usage.OCCLUDE | core.Usage.HOLDOUT]) == 0).all()


def test_a_crop_shows_the_same_paper(paper):
    paper = paper.replace(tint=0.5)
    part = drawn(paper, seen=camera(100, 80, 40, 60))
    assert np.allclose(part, drawn(paper)[60:140, 40:140], atol=1e-4)


@pytest.mark.skipif(not SCRIPT.exists(), reason="only in the checkout")
def test_the_script_makes_them(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "path", [str(SCRIPT.parent), *sys.path])
    spec = importlib.util.spec_from_file_location("make_papers", SCRIPT)
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    script.main(tmp_path)
    assert sorted(path.stem for path in tmp_path.glob("*.png")) == NAMES
    for name in NAMES:
        difference = np.abs(read_png(tmp_path / f"{name}.png") - read_png(FOLDER / f"{name}.png"))
        # A step between two levels where the machine rounds otherwise.
        assert difference.max() <= 6 and (difference > 0).mean() < 1e-3, f"{name}: run blender_scripts/make_papers.py"
