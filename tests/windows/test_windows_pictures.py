# SPDX-License-Identifier: GPL-3.0-or-later
"""Windows' programs draw what those of Linux draw, to the last bit."""

import json

import pytest
from command.standalone import build, toolchain
from conftest import PROJECT
from models import MODELS

ADDON = PROJECT / "addon"
STYLES = sorted(path.stem for path in (ADDON / "styles").glob("*.json"))
SIZE = "480x320"


@pytest.fixture(scope="session")
def drawn(target, run, tmp_path_factory):
    """drawn(platform, model, words...): the bytes of a picture, and what is said of it."""
    folder = tmp_path_factory.mktemp("drawn")
    for name, text in MODELS.items():
        (folder / f"{name}.obj").write_text(text())

    def draw(name, model, *words):
        platform = toolchain.PLATFORMS[name]
        tool = build.program_place(target, platform, "fovea_tool")
        picture = folder / f"{model}-{name}.png"
        said = run(tool, folder / f"{model}.obj", "-o", picture, "--size", SIZE, "--assets", ADDON, *words)
        return picture.read_bytes(), counted(json.loads(said))

    return draw


def counted(said):
    """What a tool says without the times that it took."""
    return {key: value for key, value in said.items() if key != "milliseconds"}


@pytest.mark.parametrize("style", STYLES)
@pytest.mark.parametrize("model", MODELS)
def test_a_picture_is_the_same_on_windows(drawn, model, style):
    words = ("--style", ADDON / "styles" / f"{style}.json")
    assert drawn("windows-x64", model, *words) == drawn("linux-x64", model, *words)


@pytest.mark.parametrize("model", MODELS)
def test_every_line_definition_is_the_same_on_windows(drawn, model):
    words = ("--lines", "all", "--azimuth", "-20")
    assert drawn("windows-x64", model, *words) == drawn("linux-x64", model, *words)


def test_another_style_another_model_and_another_view_are_other_pictures(drawn):
    """So bytes that are equal say something."""
    plain, pencil = (("--style", ADDON / "styles" / f"{name}.json") for name in ("plain", "pencil"))
    kinds = [("torus", *plain), ("stairs", *plain), ("torus", *pencil), ("torus", *plain, "--azimuth", "10")]
    pictures = {drawn("windows-x64", *words)[0] for words in kinds}
    assert len(pictures) == len(kinds)


def test_one_thread_draws_the_same_on_windows(drawn):
    assert drawn("windows-x64", "hills", "--threads", "1") == drawn("linux-x64", "hills")
