# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines by a model that a style names: its file in Blender, in files of styles, and what is said where it is none."""

import json
from pathlib import Path

import bpy
import numpy as np
import pytest
from pictures import ink, pixels_of
from the_addon import add_camera, empty_scene, part, use_style

native = part("native")
style, style_data, style_read = part("style"), part("style.style_data"), part("style.style_read")
definition_strengths, explained_lines = part("render.definition_strengths"), part("explained_lines")
SIZE = 640, 480


@pytest.fixture
def scene(tmp_path):
    """A smooth monkey in a saved file."""
    made = empty_scene()
    bpy.ops.mesh.primitive_monkey_add()
    bpy.ops.object.shade_smooth()
    bpy.context.object.modifiers.new("Subdivision", "SUBSURF").render_levels = 2
    add_camera((0.8, -4.5, 0.5), (0, 0, 0))
    made.render.engine, made.view_settings.view_transform = "FOVEA", "Standard"
    made.render.resolution_x, made.render.resolution_y = SIZE
    use_style(made, "plain")
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    return bpy.context.scene


def rendered(scene, path):
    """(H, W) ink."""
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    return ink(pixels_of(path))


def drawing(scene, folder):
    """A picture of the monkey's contours and valleys."""
    held = style_data.use(scene, "plain")
    style_data.choose_lines(held, ["contour", "valley"])
    for line_set in held.line_sets:
        line_set.pen.width = 5.0
    rendered(scene, folder / "artist.png")
    return folder / "artist.png"


def learn(scene, folder, **words):
    assert bpy.ops.fovea.learn_lines(filepath=str(drawing(scene, folder)), kind="TREE", **words) == {"FINISHED"}
    return folder / "artist.lines.json"


def kinds_of(scene):
    return [dict(line_set.kinds) for line_set in style_read.read(scene.fovea.style).line_sets]


def test_a_drawing_is_learned_and_the_scene_drawn_by_it(scene, tmp_path):
    artist = ink(pixels_of(drawing(scene, tmp_path)))
    path = learn(scene, tmp_path)
    assert part("learned_lines").read(path).kind == "tree"
    (*others, edited) = kinds_of(scene)
    assert not any(others) and list(edited) == ["learned_line"] and edited["learned_line"]["model"] == str(path)
    found = rendered(scene, tmp_path / "found.png")
    lines, wanted = (native.load().Bitmap(np.uint8(picture > 0.5)) for picture in (found, artist))
    assert lines.measures(wanted, 3.0)["f1"] > 0.8


def test_learned_lines_explain_the_drawing_they_are_learned_from_better_than_others_do(scene, tmp_path):
    path = learn(scene, tmp_path)
    judge = part("comparison").read(tmp_path / "artist.png").bitmap(SIZE)
    names, given = ["learned_line", "ridge"], part("line_files").parameters(["learned_line"], path)
    of_scene = definition_strengths.found(bpy.context, SIZE, names, "silhouette", "contour", given=given)
    curves = explained_lines.explain(*of_scene, [judge], 3.0)["curves"]
    assert curves["learned_line"]["area"] > max(0.9, curves["ridge"]["area"] + 0.1)


def test_of_several_drawings_the_mean_is_learned_with_a_tolerance_in_millimeters(scene, tmp_path):
    first = drawing(scene, tmp_path)
    (tmp_path / "other.png").write_bytes(first.read_bytes())
    asked = {"unit": "MILLIMETERS", "tolerance": 1.0, "paper_width": 128.0}  # five pixels
    names = [{"name": "artist.png"}, {"name": "other.png"}]
    done = bpy.ops.fovea.learn_lines(filepath=str(first), directory=str(tmp_path), files=names, kind="TREE", **asked)
    assert done == {"FINISHED"}
    of_both = (tmp_path / "artist.lines.json").read_text()
    assert bpy.ops.fovea.learn_lines(filepath=str(first), kind="TREE", tolerance=5.0) == {"FINISHED"}
    assert (tmp_path / "artist.lines.json").read_text() == of_both


def test_the_other_lines_of_a_style_stay_if_one_likes(scene, tmp_path):
    use_style(scene, "plain")
    picture = drawing(scene, tmp_path)
    before = kinds_of(scene)
    assert bpy.ops.fovea.learn_lines(filepath=str(picture), kind="REGRESSION", alone=False) == {"FINISHED"}
    after = kinds_of(scene)
    assert after[:-1] == before[:-1] and set(after[-1]) == {*before[-1], "learned_line"}


def test_a_line_set_with_filters_is_refused_before_anything_is_learned(scene, tmp_path):
    picture = drawing(scene, tmp_path)
    held = style_data.own(scene)
    held.line_sets[held.line_set_index].object = "Suzanne"
    with pytest.raises(RuntimeError, match="has filters, and learned lines need one without"):
        bpy.ops.fovea.learn_lines(filepath=str(picture))
    assert not (tmp_path / "artist.lines.json").exists()


def test_a_path_may_be_relative_to_the_file(scene, tmp_path):
    path = learn(scene, tmp_path)
    kinds = style_data.own(scene).line_sets[-1].kinds
    kinds.learned_line_model = "//" + path.name
    assert Path(kinds_of(scene)[-1]["learned_line"]["model"]) == path
    assert rendered(scene, tmp_path / "found.png").max() > 0.5


def test_a_missing_file_is_told_and_the_other_lines_are_drawn(scene, tmp_path, capfd):
    path = learn(scene, tmp_path)
    kinds = style_data.own(scene).line_sets[-1].kinds
    kinds.contour = True
    kinds.learned_line = False
    plain = rendered(scene, tmp_path / "plain.png")
    kinds.learned_line = True
    both = rendered(scene, tmp_path / "both.png")
    path.unlink()
    capfd.readouterr()
    found = rendered(scene, tmp_path / "found.png")
    said = "".join(capfd.readouterr())
    assert "Learned Line draws nothing: " in said and "artist.lines.json cannot be read" in said
    assert (found == plain).all() and (both != plain).any()


def test_a_style_that_is_exported_takes_its_file_along(scene, tmp_path):
    path, folder = learn(scene, tmp_path), tmp_path / "styles"
    folder.mkdir()
    assert bpy.ops.fovea.style_export(filepath=str(folder / "style.json")) == {"FINISHED"}
    said = json.loads((folder / "style.json").read_text())["line_sets"][-1]["kinds"]["learned_line"]
    assert said["model"] == "models/artist.lines.json"
    before = rendered(scene, tmp_path / "before.png")
    path.unlink()
    assert bpy.ops.fovea.style_import(filepath=str(folder / "style.json")) == {"FINISHED"}
    assert (rendered(scene, tmp_path / "after.png") == before).all()


def test_a_style_without_lines_of_a_file_loses_the_one_that_was_named(scene, tmp_path):
    learn(scene, tmp_path)
    held = style_data.own(scene)
    part("style.style_write").write_line_set(held.line_sets[-1], style.LineSet(kinds={"contour": {}}))
    assert held.line_sets[-1].kinds.learned_line_model == ""
