# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of `fovea draw`: their meaning, and what is rejected before anything is built."""

from pathlib import Path

import pytest
from command import draw_options
from native_core import core

NUMBERS = ("--lens", "--margin", "--azimuth", "--elevation", "--halo", "--overshoot")  # options of one number


def refused(capsys, *words):
    with pytest.raises(SystemExit):
        draw_options.parse(words)
    return capsys.readouterr().err


def test_nothing_named_is_the_demo_in_the_current_folder():
    options = draw_options.parse([])
    assert options.scene == "demo" and options.output == Path.cwd() / "demo-fovea.png"


@pytest.mark.parametrize("words", [[], ["demo"], ["demo", "--size", "64x36", "--frames", "1-2"]])
def test_the_demo_shows_stylized_focus(words):
    options = draw_options.parse(words)
    assert {name: getattr(options, name) for name in draw_options.DEMO} == draw_options.DEMO


@pytest.mark.parametrize(
    "words",
    [["--style", "pencil"], ["--lines", "crease"], ["--focus", "Bicycle"], ["--focus-painted", "Look"], ["--sheet"]],
)
def test_the_demo_is_drawn_as_words_say_where_they_do(words):
    options, other = draw_options.parse(["demo", *words]), draw_options.parse(["office", *words])
    names = ("style", "focus", "focus_painted", "focus_radii", "lines")
    assert [getattr(options, name) for name in names] == [getattr(other, name) for name in names]


def test_a_sheet_is_of_all_lines_on_something_smooth():
    options = draw_options.parse(["--sheet"])
    assert (options.scene, options.lines, options.output.name) == ("suzanne:3", ["all"], "suzanne-3-sheet.png")


def test_the_picture_of_a_model_never_replaces_one_of_the_users(tmp_path):
    model = tmp_path / "my model.obj"
    model.touch()
    assert draw_options.parse([str(model)]).output == Path.cwd() / "my model-fovea.png"
    assert draw_options.parse(["boxes:10"]).output.name == "boxes-10-fovea.png"


@pytest.mark.parametrize("name", ["chair.glb", "CHAIR.FBX", "Chair.Obj", "chair.svg", "room.BLEND"])
def test_a_file_is_known_by_its_suffix_however_it_is_written(tmp_path, name):
    (tmp_path / name).touch()
    options = draw_options.parse([str(tmp_path / name)])
    assert options.output == Path.cwd() / f"{Path(name).stem}-fovea.png"


def test_frames_are_numbered_files(tmp_path):
    options = draw_options.parse(["boxes:2", "--frames", "9-10", "-o", str(tmp_path / "out.exr")])
    assert [path.name for path in draw_options.pictures(options)] == ["out_0009.exr", "out_0010.exr"]


def test_frames_are_numbered_where_the_last_row_of_hashes_is(tmp_path):
    def files(name):
        options = draw_options.parse(["boxes:2", "--frames", "9-10", "-o", str(tmp_path / name)])
        return [path.name for path in draw_options.pictures(options)]

    assert files("x_####.svg") == ["x_0009.svg", "x_0010.svg"]
    assert files("#a_##b.ora") == ["#a_09b.ora", "#a_10b.ora"]


def test_black_and_white_is_a_png_as_large_as_its_page(tmp_path, capsys):
    out = ["boxes:2", "-o", str(tmp_path / "x.png")]
    options = draw_options.parse([*out, "--one-bit", "--dpi", "300", "--screen-angle", "30"])
    assert draw_options.screen_options(options) == {"dpi": 300, "angle": 30}
    assert draw_options.kind(options, options.output) == "png"
    assert draw_options.kind(draw_options.parse(out), options.output) is None
    assert "add --one-bit" in refused(capsys, *out, "--screen-angle", "30")
    assert "--one-bit is a .png" in refused(capsys, *out, "--one-bit", "--size", "64x36")
    assert "--one-bit is a .png" in refused(capsys, "boxes:2", "-o", str(tmp_path / "x.svg"), "--one-bit")


def test_a_dump_is_a_file_for_each_frame(tmp_path):
    words = ["boxes:2", "--dump", str(tmp_path / "frame.npz"), "-o", str(tmp_path / "out.png")]
    assert draw_options.dumps(draw_options.parse(words)) == [tmp_path / "frame.npz"]
    numbered = draw_options.dumps(draw_options.parse([*words, "--frames", "9-10"]))
    assert [path.name for path in numbered] == ["frame_0009.npz", "frame_0010.npz"]
    assert draw_options.dumps(draw_options.parse(words[:1])) == []


def test_a_dump_that_cannot_be_written_is_refused_before_anything_is_drawn(tmp_path, capsys):
    assert "a dump is a .npz, not frame.txt" in refused(capsys, "boxes:2", "--dump", "frame.txt")
    assert "there is no folder" in refused(capsys, "boxes:2", "--dump", str(tmp_path / "none" / "frame.npz"))
    assert "a sheet has no --dump" in refused(capsys, "--sheet", "--dump", "frame.npz")


@pytest.mark.parametrize("text, surfaces", [("1", (1, 1)), ("2-3", (2, 3)), ("4-", (4, None))])
def test_hidden_lines_are_chosen_by_what_hides_them(text, surfaces):
    assert draw_options.parse(["--hidden-by", text]).hidden_by == surfaces


@pytest.mark.parametrize(
    "text, where",
    [
        ("0.4,.5", (0.4, 0.5)),
        ("1,-2e1,+3", (1.0, -20.0, 3.0)),
        ("Suzanne", "Suzanne"),
        ("Box.001", "Box.001"),
        ("Tür 2", "Tür 2"),
        ("nan", "nan"),
        ("Box,nan", "Box,nan"),
    ],
)
def test_focus_is_a_place_or_an_object(text, where):
    assert draw_options.parse([f"--focus={text}"]).focus == where


@pytest.mark.parametrize(
    "text, where", [("0,0,1.2,0,0,1", (0, 0, 1.2, 0, 0, 1)), ("Cut", "Cut"), ("Wall, upper", "Wall, upper")]
)
def test_a_section_is_a_point_and_a_direction_or_an_object(text, where):
    assert draw_options.parse(["office", "--section", text]).section == where


def test_vectors_to_scale_keep_it_on_a_sheet_and_pixels_have_none(capsys, tmp_path):
    out = ["boxes:2", "-o", str(tmp_path / "out.svg"), "--scale", "50"]
    assert draw_options.vector_options(draw_options.parse([*out, "--paper", "a3"])) == {"sheet": "a3", "to_scale": True}
    assert "--scale is of paper" in refused(capsys, *out, "--paper", "pixels")


def test_how_visibility_is_found_is_the_scenes_choice_unless_it_is_named():
    options = draw_options.parse(["demo"])
    assert (options.visibility, options.probes, options.depth_scale, options.layers) == (None,) * 4
    words = "demo --visibility item-buffer --probes 16 --depth-scale 3 --layers 1".split()
    options = draw_options.parse(words)
    assert (options.visibility, options.probes, options.depth_scale, options.layers) == ("item-buffer", "16", 3, 1)


@pytest.mark.parametrize(
    "words, reason",
    [
        (["missing.obj"], "no file missing.obj"),
        (["model.doc"], ".svg or .blend"),
        (["nowhere"], "no scene is called 'nowhere'"),
        (["-o", "picture.jpg"], ".png or .exr"),
        (["-o", "no/such/folder/x.png"], "no folder"),
        (["--size", "100"], "WIDTHxHEIGHT"),
        (["--frames", "5-3"], "FIRST-LAST"),
        (["--margin", "50"], "leaves no picture"),
        (["-o", "/"], "a picture is .png or .exr"),
        (["boxes:0"], "a number from 1 to 1000"),
        (["suzanne:12"], "a number from 0 to 7"),
        (["--size", "3x100"], "not 4 to 65536 pixels"),
        (["--size", "100x65537"], "not 4 to 65536 pixels"),
        (["--frames", "1-99999999"], "FIRST-LAST, frames up to"),
        (["--hidden-by", "3-2"], "not FIRST-LAST surfaces"),
        (["--focus", "1e30,0,0"], "X,Y,Z in space"),
        (["--focus-radii", "0,1e30"], "not NEAR,FAR"),
        (["--sheet", "-o", "sheet.exr"], "a sheet is a .png"),
        (["--sheet", "--frames", "1-2"], "a sheet has no --frames"),
        (["--sheet", "--style", "pen_and_ink"], "a sheet has no --style"),
        (["--sheet", "--hidden"], "a sheet has no --hidden"),
        (["--hidden-by", "0"], "not FIRST-LAST"),
        (["--hidden-by", "3-2"], "not FIRST-LAST"),
        (["--focus", "0.5"], "X,Y,Z in space, or an object's name"),
        (["--focus", "1,2,3,4"], "X,Y,Z in space, or an object's name"),
        (["--focus", "0.5,0.5", "--focus-painted", "focus"], "not allowed with"),
        (["--sheet", "--focus-painted", "focus"], "a sheet has no --focus-painted"),
        (["--section", "0,0,1,0,0,0"], "has no direction"),
        (["--section", "0,0,1,0,0,nan"], "not OBJECT or X,Y,Z,NX,NY,NZ"),
        (["--scale", "0"], "meters to a meter on paper"),
        (["--sheet", "--section", "Cut"], "a sheet has no --section"),
        (["--halo", "wide"], "'wide' is not a number of pixels"),
        (["--over", "povray"], "invalid choice: 'povray'"),
        (["--over", "cycles", "--sheet"], "--over draws a picture"),
        (["--over", "cycles", "-o", "x.svg"], "--over draws a picture"),
        (["--blend", "multiply"], "--blend is for lines over renders"),
        (["--over", "cycles", "--opacity", "2"], "is not a number of 1 from 0 to 1"),
        (["--lens", "0"], "is not a number of millimeters from 1 to 5000"),
        *(([f"{name}={text}"], "is not a number of") for name in NUMBERS for text in ("nan", "inf", "-inf", "1e999")),
        *((["--focus", text], "X,Y,Z in space, or an object's name") for text in ("nan,0.5", "0,-inf", "1,Infinity,2")),
        *((["--focus-radii", text], "not NEAR,FAR") for text in ("nan,1", "0,inf", "nan,nan")),
        *((["--param", f"crease.angle={text}"], "not NAME=NUMBER") for text in ("nan", "inf")),
    ],
)
def test_mistakes_are_named(capsys, words, reason):
    assert reason in refused(capsys, *words)


RANGES = {
    "--lens": "millimeters from 1 to 5000",
    "--margin": "percent from 0 to 100",
    "--azimuth": "degrees from -360 to 360",
    "--elevation": "degrees from -360 to 360",
}


@pytest.mark.parametrize("option", RANGES)
@pytest.mark.parametrize("number", ["nan", "inf", "-inf", "-1e9", "1e9", "1e400", "", "5mm"])
def test_a_number_that_nothing_can_be_drawn_with_is_refused(capsys, option, number):
    assert f"argument {option}: '{number}' is not a number of {RANGES[option]}" in refused(capsys, f"{option}={number}")


@pytest.mark.parametrize("option", ["--halo", "--overshoot"])
@pytest.mark.parametrize("number", ["nan", "inf", "-inf", "1e400", "", "5mm"])
def test_what_the_style_has_a_range_for_is_a_finite_number(capsys, option, number):
    assert f"argument {option}: '{number}' is not a number of pixels" in refused(capsys, f"{option}={number}")


@pytest.mark.parametrize("number", ["nan", "inf", "1e400"])
def test_parameters_are_finite(capsys, number):
    assert "is not NAME=NUMBER" in refused(capsys, "--param", f"crease.angle={number}")
    assert "is not NEAR,FAR" in refused(capsys, "--focus-radii", f"0,{number}")


def test_a_folder_is_no_picture(capsys, tmp_path):
    folder = tmp_path / "out.png"
    folder.mkdir()
    assert f"{folder} is a folder" in refused(capsys, "-o", str(folder))


def test_each_frame_must_be_writable(capsys, tmp_path):
    (tmp_path / "out_0002.png").mkdir()
    assert "out_0002.png is a folder" in refused(capsys, "--frames", "1-3", "-o", str(tmp_path / "out.png"))


def test_options_of_vectors_are_those_that_are_given_and_for_vectors_alone(capsys, tmp_path):
    out = ["boxes:2", "-o", str(tmp_path / "out.svg")]
    assert draw_options.vector_options(draw_options.parse(out)) == {}
    options = draw_options.parse([*out, "--paper", "A4", "--paper-margin", "5", "--plotter", "--lines-alone"])
    assert draw_options.vector_options(options) == {"sheet": "a4", "margin": 5.0, "plotter": True, "ground": False}
    assert "--plotter is for vectors: name an output that ends in .svg" in refused(capsys, "boxes:2", "--plotter")
    assert "--paper is for vectors" in refused(capsys, "boxes:2", "--paper", "a3", "-o", str(tmp_path / "out.png"))
    assert "invalid choice" in refused(capsys, *out, "--paper", "b5")


def test_a_title_block_lies_on_a_sheet_of_paper_and_its_fields_are_named(capsys, tmp_path):
    out = ["boxes:2", "-o", str(tmp_path / "out.svg")]
    fields = ["--title-field", "title=a = b", "--title-field", "number="]
    options = draw_options.parse([*out, "--paper", "a4", *fields])
    assert draw_options.vector_options(options) == {"sheet": "a4", "title_block": True}
    assert draw_options.titles(options, "1/2") == {"sheet": "1/2", "title": "a = b", "number": ""}
    assert draw_options.titles(options, "") == {"title": "a = b", "number": ""}
    for words in ([], ["--paper", "pixels"], ["--paper", "page"]):
        assert "choose one, as --paper a4" in refused(capsys, *out, *words, "--title-block")
    for field in ("title", "head=Plan"):
        assert f"'{field}' is not NAME=TEXT; NAME can be: title," in refused(capsys, *out, "--title-field", field)
    png = str(tmp_path / "out.png")
    assert "--title-block is for vectors" in refused(capsys, "boxes:2", "--title-block", "-o", png)


def test_sheets_and_kinds_of_vectors_are_those_of_the_module():
    assert [name for name, *_ in core.SHEETS] == list(draw_options.SHEETS)
    assert [f".{name}" for name, *_ in core.VECTORS] == list(draw_options.VECTORS)
    assert [field["name"] for field in core.Titles.fields] == list(draw_options.TITLES)
