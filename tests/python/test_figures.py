# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of README and of the page of figures: their inputs can be drawn, their files exist, and they are
small."""

import re
from pathlib import Path

import pytest
from command import draw_options, figures, variants

from addon import style

README = Path(__file__).parents[2] / "README.md"
PAGE = figures.FOLDER / "README.md"
PICTURES = sorted({*figures.FOLDER.iterdir()} - {PAGE})


@pytest.mark.parametrize("name", figures.FIGURES)
def test_a_figure_is_drawn_by_words_that_draw_understands(name):
    words = [str(word) for word in figures.FIGURES[name]]
    if words[0].endswith(".obj") and not Path(words[0]).exists():
        pytest.skip(f"there is no {words[0]}")
    options = draw_options.parse([*figures.SIZE, *words])
    shown = options.hidden, options.hidden_by, options.halo, options.overshoot, options.visibility, options.sheet
    assert any(shown)


@pytest.mark.parametrize("name", figures.VECTORS)
def test_a_figure_of_vectors_is_drawn_to_scale(name, tmp_path):
    assert draw_options.parse([*figures.VECTORS[name], "-o", str(tmp_path / f"{name}.svg")]).scale


TILES = [(sheet, label, words) for sheet, (_, tiles) in variants.SHEETS.items() for label, words in tiles]


@pytest.mark.parametrize("sheet, label, words", TILES)
def test_a_tile_is_drawn_by_words_that_draw_understands(sheet, label, words):
    options = draw_options.parse([variants.SHEETS[sheet][0], *words])
    assert options.style in style.names()
    assert options.focus or options.elision is not None


@pytest.mark.parametrize("name", style.names())
def test_a_style_has_a_thumbnail(name):
    content = (figures.STYLES / f"{name}.jpg").read_bytes()
    assert content.startswith(b"\xff\xd8\xff") and len(content) < 60_000


def pictures_of(page):
    return re.findall(r"!\[[^\]]*\]\(([^)]*)\)", page.read_text(encoding="utf-8"))


def test_readme_shows_the_demo_scene_with_lines_over_a_render_and_vectors_and_a_page_every_other_figure_once():
    first, *sheets = (f"{name}.jpg" for name in variants.SHEETS)
    vectors = [f"{name}.svg" for name in figures.VECTORS]
    of_figures = [f"blender_scripts/figures/{name}" for name in (first, *vectors)]
    assert sorted(pictures_of(README)) == sorted([*of_figures, "addon/docs/over/cycles.jpg"])
    assert pictures_of(PAGE) == [*(f"{name}.png" for name in figures.FIGURES), *vectors, *sheets]
    assert {path.name for path in PICTURES} == {first, *pictures_of(PAGE)}


@pytest.mark.parametrize("path", PICTURES, ids=lambda path: path.name)
def test_figures_are_small_pictures(path):
    content = path.read_bytes()
    begins = {".png": b"\x89PNG\r\n\x1a\n", ".jpg": b"\xff\xd8\xff", ".svg": b"<?xml "}
    assert content.startswith(begins[path.suffix])
    assert len(content) < 400_000


def test_other_names_are_refused(capsys):
    with pytest.raises(SystemExit):
        figures.figures(None, ["no-such-figure"])
    assert "there is no figure no-such-figure" in capsys.readouterr().err
