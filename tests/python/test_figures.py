"""The figures of README: what they are made of can be drawn, they are there, and they are small."""

from pathlib import Path

import pytest
from command import draw_options, figures

README = Path(__file__).parents[2] / "README.md"


@pytest.mark.parametrize("name", figures.FIGURES)
def test_a_figure_is_drawn_by_words_that_draw_understands(name):
    words = [str(word) for word in figures.FIGURES[name]]
    if words[0].endswith(".obj") and not Path(words[0]).exists():
        pytest.skip(f"there is no {words[0]}")
    options = draw_options.parse([*figures.SIZE, *words])
    assert options.hidden or options.hidden_by or options.halo or options.overshoot or options.visibility


def test_readme_shows_every_figure_and_no_other():
    shown = [word.split(")")[0] for word in README.read_text().split("](blender_scripts/figures/")[1:]]
    assert shown == [f"{name}.png" for name in figures.FIGURES]
    assert {path.name for path in figures.FOLDER.iterdir()} == set(shown)


@pytest.mark.parametrize("name", figures.FIGURES)
def test_figures_are_small_pictures(name):
    content = (figures.FOLDER / f"{name}.png").read_bytes()
    assert content[:8] == b"\x89PNG\r\n\x1a\n" and len(content) < 400_000


def test_other_names_are_refused(capsys):
    with pytest.raises(SystemExit):
        figures.figures(None, ["no-such-figure"])
    assert "there is no figure no-such-figure" in capsys.readouterr().err
