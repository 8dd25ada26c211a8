# SPDX-License-Identifier: GPL-3.0-or-later
"""Ink and pigment on papers: they keep their mean density, and have the paper's size and place."""

import json
from pathlib import Path

import numpy as np
import pytest
from native_core import Mesh, core, scene
from test_paper_tiles import coherence

from addon import pipeline, style
from addon.style import LineSet, Paper

PROJECT = Path(__file__).parents[2]
FOLDER = PROJECT / "addon" / "papers"
NAMES = sorted(path.stem for path in FOLDER.glob("*.png"))
SIDE = 432  # texels of a paper; of pictures that show one tile
TILE_MM = 84.0
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


def camera(width=SIDE, height=SIDE, left=0, lower=0, scale=1.0):
    """Of a picture of which so much is seen, with so many pixels to a reference pixel; its axis meets the lower left
    corner of the whole picture, so that a paper's texels lie on reference pixels."""
    clip = np.diag([2 / width, 2 / height, -2 / (FAR - NEAR), 1]).astype(float)
    clip[:3, 3] = -1 - 2 * left / width, -1 - 2 * lower / height, -(FAR + NEAR) / (FAR - NEAR)
    return core.View(np.eye(4), clip, width, height, True, NEAR, FAR, reference_scale=scale)


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
        (tmp_path / "papers" / "papers.json").write_text(json.dumps({"heights": {"tile_mm": TILE_MM}}))
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
    """A dome: the side towards the light is brighter than flat paper, the other one darker, and what lies across the
    light about as bright; rows go upwards. Means over some texels, since a dome in 256 steps has edges."""
    away = np.hypot(*(np.mgrid[:SIDE, :SIDE] - SIDE / 2)) / 100
    shade = drawn(of_heights(np.maximum(1 - away**2, 0), tint=0.2))[..., 0] / 0.9

    def around(row, column):
        return shade[SIDE // 2 + row - 8 : SIDE // 2 + row + 8, SIDE // 2 + column - 8 : SIDE // 2 + column + 8].mean()

    assert around(40, -40) > shade[10, 10] + 0.1 and around(-40, 40) < shade[10, 10] - 0.1
    assert abs(around(40, 40) - shade[10, 10]) < 0.04 and abs(around(-40, -40) - shade[10, 10]) < 0.04


@pytest.mark.parametrize("name", ["bristol", "cold_press", "kraft", "rough"])
def test_light_on_paper_shows_grain_and_not_worms(name):
    """On papers without wires or threads. Half of what light shows is finer than four texels, and its contours run all
    ways: bumps of one size would be lit like worms that lie across the light."""
    shade = drawn(PAPER.replace(texture=name, tint=0.2))[..., 0]
    power = np.abs(np.fft.fft2(shade - shade.mean())) ** 2
    frequency = np.hypot(*np.meshgrid(np.fft.fftfreq(SIDE), np.fft.fftfreq(SIDE)))
    assert power[frequency > 0.25].sum() > 0.45 * power.sum()
    assert coherence(shade) < 0.25


def test_paper_without_relief_shades_nothing(of_heights):
    assert np.ptp(drawn(of_heights(np.ones((SIDE, SIDE)), tint=0.2))[..., 0]) == 0


def test_without_amounts_a_paper_is_its_color(paper):
    lines, layer = (0.1, 0.2, 0.1, 0.5), (0.1, 0.3, 0.2, 0.6)
    expected = np.array([0.9, 0.8, 0.6, 1.0])
    for over in (layer, lines):
        expected = np.array(over) + expected * (1 - over[3])
    assert np.allclose(drawn(paper, lines, layer), expected, atol=1e-6)


def test_smooth_paper_has_neither_teeth_nor_valleys():
    smooth = PAPER.replace(texture="none", tooth=1.0, granulation=1.0, tint=1.0)
    lines, layer = (0.1, 0.2, 0.1, 0.3), (0.1, 0.3, 0.2, 0.6)
    assert np.allclose(drawn(smooth, lines, layer), drawn(PAPER, lines, layer), atol=1e-6)


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


def blocks(picture, size):
    """Means over blocks of so many pixels along each side."""
    rows, columns = (side // size for side in picture.shape)
    return picture.reshape(rows, size, columns, size).mean((1, 3))


@pytest.mark.parametrize("amounts", [{"tint": 0.2}, {"tooth": 1.0}, {"granulation": 0.5}], ids=lambda one: [*one][0])
def test_paper_is_as_large_at_every_resolution(amounts):
    """A viewport, half as large, shows a picture of 1080 rows, made smaller; and that shows one twice as large."""
    paper = PAPER.replace(texture="rough", **amounts)
    lines, layer = ((0, 0, 0, 0.5), None) if "tooth" in amounts else ((0, 0, 0, 0), (0.3, 0.4, 0.2, 1))
    small, whole, large = (
        drawn(paper, lines, layer, seen=camera(int(SIDE * scale), int(SIDE * scale), scale=scale))[..., 0]
        for scale in (0.5, 1, 2)
    )
    for one, other, least in ((small, blocks(whole, 2), 0.99), (whole, blocks(large, 2), 0.9)):
        assert np.corrcoef(one.ravel(), other.ravel())[0, 1] > least
        assert one.mean() == pytest.approx(other.mean(), rel=0.02)


def test_tooth_keeps_the_mean_in_small_pictures(paper):
    for opacity in (0.05, 0.5, 0.97):
        picture = drawn(paper.replace(tooth=1.0), (0, 0, 0, opacity), seen=camera(108, 108, scale=0.25))
        assert (picture[..., 0] / 0.9).mean() == pytest.approx(1 - opacity, abs=0.02)


def test_grain_is_finer_on_a_larger_page_and_coarser_by_its_size():
    """A page twice as high shows four tiles where the other shows one; grain twice as large undoes that."""
    paper = PAPER.replace(texture="rough", tint=0.2)
    one, twice = drawn(paper), drawn(paper.replace(height_mm=420.0), seen=camera(SIDE // 2, SIDE // 2))
    again = drawn(paper.replace(height_mm=420.0, scale=2.0))
    assert np.allclose(one, again)
    assert np.corrcoef(twice[..., 0].ravel(), blocks(one[..., 0], 2).ravel())[0, 1] > 0.95
