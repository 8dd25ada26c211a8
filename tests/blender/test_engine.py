# SPDX-License-Identifier: GPL-3.0-or-later
"""The render engine end to end: the pictures that renders write."""

import bpy
import numpy as np
import pytest
from pictures import SIZE, box_scene, box_scene_of_one_set, drawn, ink, layered, pixels_of
from the_addon import add_camera, box_mesh, new_object, own_style, part

session = part("render.session")


@pytest.fixture
def scene():
    return box_scene()


def test_a_still_shows_the_box(scene, tmp_path):
    picture = drawn(scene, tmp_path / "still.png")
    assert picture.shape == (SIZE[1], SIZE[0], 4)
    assert (picture[..., 3] == 1).all()
    # White paper stays white, and a box seen from a corner has nine visible edges of solid ink.
    assert (picture[0] == 1).all() and (picture[-1] == 1).all()
    assert 0.01 < (ink(picture) > 0.9).mean() < 0.2
    statistics = session.last_statistics()
    assert statistics["triangles"] == 12 and statistics["strokes"] > 0 and statistics["backend"] == "cpu"
    assert statistics["lines_s"] > 0 and "visibility" in statistics["stages"]


def test_an_animation_writes_every_frame(scene, tmp_path):
    box = bpy.data.objects["Box"]
    box.keyframe_insert("location", frame=1)
    box.location.x = 1
    box.keyframe_insert("location", frame=3)
    scene.frame_start, scene.frame_end = 1, 3
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = str(tmp_path / "frame_")
    bpy.ops.render.render(animation=True)
    frames = [pixels_of(tmp_path / f"frame_{number:04}.png") for number in (1, 2, 3)]
    assert all(ink(frame).max() > 0.9 for frame in frames)
    assert not np.array_equal(frames[0], frames[1]) and not np.array_equal(frames[1], frames[2])
    # The box moved, its mesh did not.
    assert session.readers["RENDER"].surfaces.rebuilt == []


def test_markers_switch_the_camera(scene, tmp_path):
    near = scene.camera
    far = add_camera((20, -28, 16))
    for frame, camera in ((1, near), (2, far)):
        scene.timeline_markers.new("cut", frame=frame).camera = camera
    scene.frame_set(1)
    close = ink(drawn(scene, tmp_path / "near.png")).sum()
    scene.frame_set(2)
    assert ink(drawn(scene, tmp_path / "far.png")).sum() < 0.6 * close


def test_film_transparent(scene, tmp_path):
    opaque = drawn(scene, tmp_path / "opaque.png")
    scene.render.film_transparent = True
    clear = drawn(scene, tmp_path / "clear.png")
    assert (clear[0, :, 3] == 0).all()
    assert np.allclose(clear[..., 3], ink(opaque), atol=0.3)
    assert (clear[..., 3][ink(opaque) > 0.99] > 0.99).all()


@pytest.mark.parametrize("crop", [True, False])
def test_a_border_draws_a_part_of_the_full_frame(scene, tmp_path, crop):
    full = drawn(scene, tmp_path / "full.png")
    render = scene.render
    render.use_border, render.use_crop_to_border = True, crop
    render.border_min_x, render.border_max_x = 0.25, 0.75
    render.border_min_y, render.border_max_y = 0.3, 0.9
    part_drawn = drawn(scene, tmp_path / "part.png")
    rows, columns = slice(27, 81), slice(40, 120)
    if not crop:
        assert (part_drawn[0] == 0).all()
        part_drawn = part_drawn[rows, columns]
    assert part_drawn.shape == (54, 80, 4)
    assert np.abs(part_drawn - full[rows, columns]).max() < 0.05


def test_orthographic(tmp_path):
    scene = box_scene_of_one_set()
    camera = scene.camera
    camera.data.type, camera.data.ortho_scale = "ORTHO", 4.0
    camera.location, camera.rotation_euler = (0, 0, 10), (0, 0, 0)
    picture = ink(drawn(scene, tmp_path / "above.png"))
    # A square two units wide, 4 units across the frame, seen from above: only its four sides.
    inside = picture[11:79, 46:114]
    assert picture[45, 40] > 0.9 and picture[45, 119] > 0.9 and picture[5, 80] > 0.9 and picture[84, 80] > 0.9
    assert inside.max() == 0


def test_half_the_percentage_is_half_the_size_of_the_same_drawing(scene, tmp_path):
    full = ink(drawn(scene, tmp_path / "full.png"))
    scene.render.resolution_percentage = 50
    half = ink(drawn(scene, tmp_path / "half.png"))
    assert half.shape == (45, 80)
    shrunk = full.reshape(45, 2, 80, 2).mean(axis=(1, 3))
    assert np.abs(half - shrunk).mean() < 0.03


def test_passes_in_a_multilayer_exr(tmp_path):
    scene = box_scene_of_one_set()
    scene.view_layers[0].use_pass_z = True
    scene.camera.data.type = "ORTHO"
    scene.camera.location, scene.camera.rotation_euler = (0, 0, 10), (0, 0, 0)
    own_style(scene).paper.color = (0.5, 0.25, 0.75)
    channels = layered(scene, tmp_path / "passes.exr")
    named = {name.partition(".")[2]: values for name, values in channels.items()}
    assert {f"{p}.{c}" for p in ("Combined", "Lines") for c in "RGBA"} | {"Depth.Z"} == set(named)
    assert named["Depth.Z"][45, 80] == pytest.approx(9.0, rel=1e-5)
    assert named["Depth.Z"][0, 0] > 1e9
    assert named["Combined.G"][45, 80] == pytest.approx(0.25)
    lines = named["Lines.A"]
    assert lines[0, 0] == 0 and lines.max() > 0.99
    assert np.allclose(named["Combined.R"], 0.5 * (1 - lines) + named["Lines.R"], atol=1e-3)


@pytest.mark.parametrize(
    "visibility, told",
    [
        ("AUTO", "exact"),
        ("EXACT", "exact"),
        ("ATLAS", "sampled, 4 samples x 3"),
        ("SPINE", "spine test, 4 samples x 3"),
        ("ITEM_BUFFER", "item buffer, 2 layers x 3"),
    ],
)
def test_every_method_draws_much_the_same_and_says_which_it_was(scene, tmp_path, visibility, told):
    exact = drawn(scene, tmp_path / "exact.png")
    scene.fovea.visibility, scene.fovea.probes, scene.fovea.depth_scale, scene.fovea.layers = visibility, "4", 3, 2
    other = drawn(scene, tmp_path / "other.png")
    assert session.last_statistics()["visibility"] == told
    assert np.abs(other - exact).mean() < 0.003
    assert np.array_equal(other, exact) or visibility not in ("AUTO", "EXACT")


@pytest.mark.parametrize("visibility", ["EXACT", "ATLAS", "SPINE", "ITEM_BUFFER"])
def test_a_scene_that_wants_the_gpu_gets_it(scene, tmp_path, visibility):
    if part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    scene.fovea.visibility = visibility
    by_cpu = drawn(scene, tmp_path / "cpu.png")
    scene.fovea.backend = "GPU"
    by_gpu = drawn(scene, tmp_path / "gpu.png")
    assert session.last_statistics()["backend"] == "gpu"
    assert np.abs(by_gpu - by_cpu).mean() < 0.005
    scene.frame_start, scene.frame_end, scene.render.filepath = 1, 2, str(tmp_path / "frame_")
    bpy.ops.render.render(animation=True)
    assert np.abs(pixels_of(tmp_path / "frame_0002.png") - by_gpu).max() < 0.01


def test_what_the_depth_pass_takes_is_told_by_its_name_where_the_pass_is_on(scene, tmp_path):
    names = {}
    for wanted in (False, True):
        scene.view_layers[0].use_pass_z = wanted
        drawn(scene, tmp_path / "box.png")
        names[wanted] = set(session.last_statistics()["stages"])
    assert names[True] - names[False] == {"depth"} and names[False] <= names[True]
    assert names[True] <= part("render.stage_labels").STAGES.keys()


def test_both_views_of_a_stereo_pair_are_drawn(scene, tmp_path):
    scene.render.use_multiview = True
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = str(tmp_path / "pair.png")
    bpy.ops.render.render(write_still=True)
    left, right = (ink(pixels_of(tmp_path / f"pair_{side}.png")) for side in "LR")
    assert left.max() > 0.9 and right.sum() == pytest.approx(left.sum(), rel=0.1)
    columns = [np.average(np.arange(picture.shape[1]), weights=picture.sum(axis=0)) for picture in (left, right)]
    assert 0.1 < abs(columns[1] - columns[0]) < 20, "each eye sees it from its side"


def test_every_view_layer_is_drawn(scene, tmp_path):
    bpy.ops.scene.view_layer_add()
    collection = bpy.data.collections.new("Second")
    scene.collection.children.link(collection)
    new_object(box_mesh(0.5), "Small", (1, -2, 1), collection)
    scene.view_layers[0].layer_collection.children["Second"].exclude = True
    channels = layered(scene, tmp_path / "layers.exr")
    first, second = (channels[f"{layer.name}.Lines.A"] for layer in scene.view_layers)
    assert first.max() > 0.9 and second.max() > 0.9 and not np.array_equal(first, second)


def test_a_holdout_hides_and_cuts_a_hole(scene, tmp_path):
    front = new_object(box_mesh(0.2), "Front", scene.camera.location * 0.5)
    front.is_holdout = True
    picture = drawn(scene, tmp_path / "hole.png")
    assert picture[45, 80, 3] == 0
    assert picture[0, 0, 3] == 1
    assert ink(picture)[picture[..., 3] == 1].max() > 0.9
