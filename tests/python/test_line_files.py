# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that line definitions are given: read where they lie, kept with their styles, refused elsewhere, and told of
where they cannot be read."""

import json
import os

import numpy as np
import pytest
from command import lines
from native_core import core, scene, sphere, view

from addon import learned_lines, line_files, pipeline, style

NAMES = [name for name, _ in core.LocalProperties.names]
NAME, FILE = "learned_line", "model"


def rule(below=0.3):
    """A LineModel by which lines are where a surface is nearly seen from its side."""
    values = np.random.default_rng(1).uniform(-1, 1, (4000, len(NAMES))).astype(np.float32)
    facing = values[:, NAMES.index("facing")]
    return core.LineModel("tree", values, np.float32(facing < below), np.ones(4000, np.float32))


@pytest.fixture(scope="module")
def model():
    return rule()


@pytest.fixture
def file(model, tmp_path):
    path = tmp_path / "artist.json"
    path.write_text(model.json())
    return path


def style_of(path, **others):
    given = {FILE: str(path)} if path else {}
    return style.Style(line_sets=(style.LineSet(kinds={NAME: given, **others}, least_length=0.0),))


def path_in(chosen):
    return chosen.line_sets[0].kinds[NAME][FILE]


def drawn(chosen):
    seen = view((0, -4, 0), (0, 0, 0), size=(320, 240))
    frame = pipeline.frame(scene([sphere(48).surface()]), seen, chosen, core.CpuBackend(), pipeline.options())
    frame.thin()
    return frame.polylines()


def style_file(folder, path, name="style.json"):
    place = folder / name
    place.write_text(json.dumps({"schema": 1, "line_sets": [{"kinds": {NAME: {FILE: path}}}]}))
    return place


def test_a_style_draws_by_the_file_that_it_names(file):
    found = drawn(style_of(file))
    away = np.hypot(*(found.px - (160, 120)).T)
    assert len(found.path) and np.ptp(away) < 4.0
    assert not line_files.remarks(style_of(file))


def test_the_same_file_draws_the_same_lines_each_time_and_another_content_others(file):
    first, again = drawn(style_of(file)), drawn(style_of(file))
    assert (first.px == again.px).all() and (first.strength == again.strength).all()
    before = line_files.stamp(style_of(file))
    file.write_text(rule(0.6).json())
    os.utime(file, ns=(1, 1))
    assert line_files.stamp(style_of(file)) != before
    other = drawn(style_of(file))
    assert other.px.shape != first.px.shape or (other.px != first.px).any()


def broken(what, folder, model):
    """(path, part of the sentence)"""
    path = folder / f"{what}.json"
    if what == "missing":
        return path, "cannot be read: No such file or directory"
    if what == "folder":
        path.mkdir()
        return path, "cannot be read: it is no file"
    if what == "huge":
        path.write_text(model.json() + " " * (2 << 20))
        return path, "cannot be read: it has more than 1 MB"
    if what == "cut":
        path.write_text(model.json()[:-40])
        return path, "it is not JSON of finite numbers"
    path.write_text(style.dump(style.Style()))
    return path, "'line_model' is missing"


@pytest.mark.parametrize("what", ["missing", "folder", "huge", "cut", "style"])
def test_a_file_that_is_no_model_is_told_in_a_sentence_and_all_else_is_drawn(what, tmp_path, model):
    path, said = broken(what, tmp_path, model)
    (remark,) = line_files.remarks(style_of(path))
    assert remark.startswith("Learned Line draws nothing: ") and said in remark and path.name in remark
    assert "\n" not in remark and len(remark) < 400
    plain = drawn(style.Style(line_sets=(style.LineSet(kinds={"contour": {}}, least_length=0.0),)))
    found = drawn(style_of(path, contour={}))
    assert len(plain.path) and (found.px == plain.px).all()


def test_a_definition_without_its_file_says_so_and_draws_nothing():
    assert line_files.remarks(style_of(None)) == ["Learned Line draws nothing: name its file under Model"]
    assert not len(drawn(style_of(None)).path)


def test_a_style_file_is_read_and_written_with_the_file_beside_it(file, tmp_path):
    read = style.read(style_file(tmp_path, "artist.json"))
    assert path_in(read) == str(file) and len(drawn(read).path)
    written = line_files.beside(read, tmp_path)
    assert path_in(written) == "artist.json" and style.parse(style.dump(written)) == written


def test_a_style_that_is_written_elsewhere_takes_a_copy_with_it(file, tmp_path):
    folder = tmp_path / "elsewhere"
    first = line_files.beside(style_of(file), folder)
    assert (
        path_in(first) == "models/artist.json" and (folder / "models" / "artist.json").read_bytes() == file.read_bytes()
    )
    assert line_files.beside(style_of(file), folder) == first
    file.write_text(rule(0.6).json())
    other = line_files.beside(style_of(file), folder)
    assert path_in(other) != path_in(first) and (folder / path_in(other)).read_bytes() == file.read_bytes()
    again = style.read(style_file(folder, path_in(first)))
    assert learned_lines.read(path_in(again)) == rule()


@pytest.mark.parametrize("path", ["../artist.json", "/etc/artist.json", "a/../../artist.json", "C:/artist.json"])
def test_a_path_out_of_the_folder_of_the_style_is_refused(path, file, tmp_path):
    (tmp_path / "styles").mkdir()
    with pytest.raises(style.StyleError, match="must be the name of a file in the folder of the style"):
        style.read(style_file(tmp_path / "styles", path))


def test_a_link_out_of_the_folder_of_the_style_is_refused(file, tmp_path):
    folder = tmp_path / "styles"
    folder.mkdir()
    (folder / "link.json").symlink_to(file)
    with pytest.raises(style.StyleError, match="link.json, which the style names, leads out of its folder"):
        style.read(style_file(folder, "link.json"))


def test_what_cannot_be_copied_is_told(tmp_path):
    with pytest.raises(ValueError, match="gone.json, which a line definition is given, cannot be copied: No such file"):
        line_files.beside(style_of(tmp_path / "gone.json"), tmp_path / "elsewhere")


def extracted(tmp_path, *words):
    obj = tmp_path / "box.obj"
    corners = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    faces = ("1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4")
    obj.write_text("".join(f"v {x} {y} {z}\n" for x, y, z in corners) + "".join(f"f {face}\n" for face in faces))
    out = str(tmp_path / "out.npz")
    return lines.extract(core, lines.parse([str(obj), "--eye", "3,-5,4", "-o", out, *words]))[0]


def test_fovea_lines_extracts_lines_by_a_model(tmp_path):
    values = np.random.default_rng(1).uniform(-1, 1, (4000, len(NAMES))).astype(np.float32)
    steep = np.float32(values[:, NAMES.index("image_gradient")] > 0.05)
    path = tmp_path / "steep.json"
    path.write_text(core.LineModel("tree", values, steep, np.ones(4000, np.float32)).json())
    assert len(extracted(tmp_path, "--definition", NAME, "--model", str(path))["closed"])
    assert not len(extracted(tmp_path, "--definition", NAME)["closed"])
    with pytest.raises(ValueError, match="--model: crease needs no file"):
        extracted(tmp_path, "--definition", "crease", "--model", str(path))
    path.write_text("{}")
    with pytest.raises(ValueError, match=r"steep.json: a model of lines: 'line_model' is missing"):
        extracted(tmp_path, "--definition", NAME, "--model", str(path))


def test_a_command_gives_a_file_to_the_lines_that_need_one_and_says_where_it_is_of_no_use(file):
    assert line_files.parameters(["contour", NAME], file) == {NAME: {FILE: str(file)}}
    assert line_files.parameters(["contour"], None) == {}
    with pytest.raises(ValueError, match=f"{NAME}: name the file"):
        line_files.parameters(["contour", NAME], None)
    with pytest.raises(ValueError, match="contour, ridge needs no file"):
        line_files.parameters(["contour", "ridge"], file)
    file.write_text("{}")
    with pytest.raises(ValueError, match="artist.json"):
        line_files.parameters([NAME], file)
