# SPDX-License-Identifier: GPL-3.0-or-later
"""Stylized focus in renders: its location, its effects, and that frames are independent of each other."""

import bpy
import numpy as np
import pytest
from bpy_extras.object_utils import world_to_camera_view
from pictures import drawn, ink
from the_addon import add_camera, box_mesh, empty_scene, lines_of, new_object, own_style, part, use_style

style, properties = part("style"), part("render.properties")
SIZE = (480, 270)


@pytest.fixture
def row():
    """Three boxes in a row, thick lines in focus and none out of it."""
    scene = empty_scene()
    scene.render.engine, scene.render.resolution_x, scene.render.resolution_y = "FOVEA", *SIZE
    scene.render.dither_intensity = 0.0
    scene.view_settings.view_transform = "Standard"
    mesh = box_mesh()
    for x in (-5, 0, 5):
        new_object(mesh, f"Box{x}").location = (0.8 * x, 0.4 * x, 0)
    add_camera((3, -16, 6), (0, 0, 0))
    fovea = scene.fovea
    fovea.backend, fovea.visibility = "CPU", "EXACT"
    lines = use_style(scene, "plain").line_sets[-1]
    lines.pen.width, lines.away, lines.pen_away.width, lines.pen_away.opacity = 8, True, 8, 0
    return scene


def place_of(scene, name):
    """Where an object's origin is in the image: from the left and from the top."""
    bpy.context.view_layer.update()
    x, y, _ = world_to_camera_view(scene, scene.camera, bpy.data.objects[name].matrix_world.translation)
    return x, 1 - y


def ink_at(picture, place):
    """Mean ink within 40 pixels of a place."""
    x, y = place[0] * SIZE[0], (1 - place[1]) * SIZE[1]
    rows, columns = np.mgrid[: SIZE[1], : SIZE[0]]
    return ink(picture)[np.hypot(columns - x, rows - y) < 40].mean()


def inks(scene, tmp_path):
    picture = drawn(scene, tmp_path / "row.png")
    return {name: ink_at(picture, place_of(scene, name)) for name in ("Box-5", "Box0", "Box5")}


def test_without_focus_all_lines_are_in_focus(row, tmp_path):
    assert min(inks(row, tmp_path).values()) > 0.03


def test_a_place_in_the_image(row, tmp_path):
    row.fovea.focus_model = "IMAGE"
    row.fovea.focus_place = place_of(row, "Box-5")
    row.fovea.focus_near, row.fovea.focus_far = 0.2, 0.5
    found = inks(row, tmp_path)
    assert found["Box-5"] > 0.03 and found["Box5"] < 0.01


@pytest.mark.parametrize("backend", ["CPU", "GPU"])
def test_an_object_in_the_scene(row, tmp_path, backend):
    if backend == "GPU" and part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    row.fovea.backend, row.fovea.focus_model, row.fovea.focus_object = backend, "SCENE", bpy.data.objects["Box5"]
    row.fovea.focus_near_distance, row.fovea.focus_far_distance = 2, 4
    found = inks(row, tmp_path)
    assert found["Box5"] > 0.03 and found["Box0"] < 0.02 and found["Box-5"] < 0.01
    row.fovea.focus_object = bpy.data.objects["Box-5"]
    assert inks(row, tmp_path)["Box-5"] > 0.03


def test_several_places(row, tmp_path):
    row.fovea.focus_model, row.fovea.focus_object = "SCENE", bpy.data.objects["Box5"]
    row.fovea.focus_near_distance, row.fovea.focus_far_distance = 2, 4
    more = row.fovea.focus_points.add()
    more.focus_object, more.focus_near_distance, more.focus_far_distance = bpy.data.objects["Box-5"], 2, 4
    found = inks(row, tmp_path)
    assert found["Box5"] > 0.03 and found["Box-5"] > 0.03 and found["Box0"] < 0.02


def test_uniform_lines_do_not_answer(row, tmp_path):
    effects = own_style(row).effects
    row.fovea.focus_model, effects.lines, effects.uniform = "IMAGE", "UNIFORM", 0.5
    row.fovea.focus_place = place_of(row, "Box5")
    uniform = drawn(row, tmp_path / "here.png")
    row.fovea.focus_place = place_of(row, "Box-5")
    np.testing.assert_array_equal(drawn(row, tmp_path / "there.png"), uniform)
    effects.uniform = 0.0
    assert ink(drawn(row, tmp_path / "in_focus.png")).sum() > 1.5 * ink(uniform).sum()


def test_lines_or_colors_may_be_left_out(row, tmp_path):
    own_style(row).color.shading = "FLAT"
    material = bpy.data.materials.new("Red")
    material.use_nodes = True
    material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0.8, 0.1, 0.1, 1)
    for obj in row.objects:
        if obj.type == "MESH":
            obj.data.materials.clear()
            obj.data.materials.append(material)
    both = drawn(row, tmp_path / "both.png")
    effects = own_style(row).effects
    effects.lines = "NONE"
    colors = drawn(row, tmp_path / "colors.png")
    effects.lines, effects.colors = "EMPHASIZED", "NONE"
    lines = drawn(row, tmp_path / "lines.png")

    def red(picture):
        return (picture[..., 0] > picture[..., 1] + 0.1).mean()

    def black(picture):
        return (picture[..., :3].max(axis=2) < 0.2).mean()

    assert red(both) > 0.02 and black(both) > 0.01
    assert red(colors) > red(both) and black(colors) == 0
    assert red(lines) == 0 and black(lines) == pytest.approx(black(both), rel=0.2)


def test_a_render_border_shows_its_part_of_the_same_picture(row, tmp_path):
    row.fovea.focus_model, row.fovea.focus_place = "IMAGE", (0.4, 0.5)
    whole = drawn(row, tmp_path / "whole.png")
    row.render.use_border = row.render.use_crop_to_border = True
    row.render.border_min_x, row.render.border_max_x = 0.25, 0.75
    row.render.border_min_y, row.render.border_max_y = 0.25, 0.75
    part_of_it = drawn(row, tmp_path / "part.png")
    left, lower = SIZE[0] // 4, int(SIZE[1] * 0.25)
    expected = whole[lower : lower + part_of_it.shape[0], left : left + part_of_it.shape[1]]
    assert np.abs(ink(part_of_it) - ink(expected)).mean() < 0.002


def test_a_frame_alone_is_that_of_the_animation(row, tmp_path):
    """A focus pull over ten frames, forwards, and its seventh frame alone."""
    row.fovea.focus_model = "IMAGE"
    for frame, name in ((1, "Box-5"), (10, "Box5")):
        row.fovea.focus_place = place_of(row, name)
        row.fovea.keyframe_insert("focus_place", frame=frame)
    pen = lines_of(row).pen
    pen.keyframe_insert("width", frame=1)
    pen.width = 12
    pen.keyframe_insert("width", frame=10)

    def at(frame):
        row.frame_set(frame)
        return drawn(row, tmp_path / f"{frame}.png")

    run = [at(frame) for frame in range(1, 11)]
    assert np.abs(run[0] - run[9]).max() > 0.3
    at(2)
    np.testing.assert_array_equal(at(7), run[6])


def test_effects_of_distance(row, tmp_path):
    bpy.context.view_layer.update()
    view = row.camera.matrix_world.inverted()
    depth = {name: -(view @ bpy.data.objects[name].matrix_world.translation).z for name in ("Box-5", "Box5")}
    near, far = min(depth, key=depth.get), max(depth, key=depth.get)
    distance = own_style(row).distance
    distance.near, distance.far = depth[near], depth[far]
    before = inks(row, tmp_path)
    distance.opacity.strength = 1.0
    found = inks(row, tmp_path)
    assert found[near] > 0.7 * before[near] and found[far] < 0.4 * before[far]


@pytest.mark.parametrize("name", style.names())
def test_a_style_chosen_in_the_panel_draws_as_its_file_says(row, name):
    use_style(row, name)
    chosen, file = properties.style_of(row), style.load(name)
    assert len(chosen.pens()) == len(file.pens())
    assert [bool(s.pen_away) for s in chosen.line_sets] == [bool(s.pen_away) for s in file.line_sets]
    for field in ("start", "end", "strength"):
        for effect in ("width", "fade", "blur"):
            ours, theirs = (getattr(getattr(s.effects, effect), field) for s in (chosen, file))
            assert ours == pytest.approx(theirs, abs=1e-6)


def test_the_spine_test_thins_nothing(row, tmp_path):
    """It does not know what is seen before it draws, and what is hidden must not crowd what is seen."""
    elision = own_style(row).elision
    row.fovea.visibility, lines_of(row).pen.spacing = "SPINE", 120
    elision.enabled = False
    whole = drawn(row, tmp_path / "whole.png")
    elision.enabled = True
    np.testing.assert_array_equal(drawn(row, tmp_path / "spine.png"), whole)
    row.fovea.visibility = "EXACT"
    assert ink(drawn(row, tmp_path / "exact.png")).sum() < 0.95 * ink(whole).sum()
