# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks over frames: dashes of contours move with their surfaces, and each frame is a function of the scene and its
number."""

import random

import bpy
import numpy as np
import pytest
from pictures import drawn_at, drawn_at_once, exact_stills, frames_looked_at, ink
from the_addon import add_camera, empty_scene, only_lines, own_style, part, use_style

near_frames, session = part("render.near_frames"), part("render.session")
FRAMES = range(1, 8)
APART = 3  # frames between keys, the first of which is frame 1


@pytest.fixture
def turning():
    """A monkey that turns and bends before a camera, in dashes."""
    scene = empty_scene()
    exact_stills(scene, 240, 160)
    bpy.ops.mesh.primitive_monkey_add()
    monkey = bpy.context.object
    bend = monkey.modifiers.new("Bend", "SIMPLE_DEFORM")
    bend.deform_method, bend.deform_axis = "TWIST", "Z"
    monkey.modifiers.new("Subdivision", "SUBSURF").render_levels = 2
    for frame in (-10, 20):
        monkey.rotation_euler.z = 0.03 * frame
        monkey.keyframe_insert("rotation_euler", index=2, frame=frame)
        bend.angle = 0.05 * frame
        bend.keyframe_insert("angle", frame=frame)
    add_camera((0, -6, 0.4), (0, 0, 0))
    scene.frame_start, scene.frame_end = FRAMES[0], FRAMES[-1]
    scene.fovea.backend, scene.fovea.visibility = "CPU", "EXACT"
    use_style(scene, "plain")
    only_lines(scene, "contour", "suggestive_contour")
    style = own_style(scene)
    style.elision.enabled = False
    for line_set in style.line_sets:
        pen = line_set.pen
        pen.width, pen.texture, pen.texture_anchor = 14.0, "dashes", "PATH"
        pen.wobble, pen.wobble_length = 8.0, 60.0
    style.animation.marks_frames = APART
    return scene


def test_a_frame_is_the_same_alone_in_order_backwards_and_shuffled(turning, tmp_path):
    alone = {frame: drawn_at(turning, frame, tmp_path) for frame in FRAMES}
    together = drawn_at_once(turning, FRAMES, tmp_path)
    for frame in (*reversed(FRAMES), *random.Random(4).sample(FRAMES, len(FRAMES))):
        np.testing.assert_array_equal(drawn_at(turning, frame, tmp_path), alone[frame])
    for frame in FRAMES:
        np.testing.assert_array_equal(together[frame], alone[frame])
    own_style(turning).animation.marks_frames = 0
    assert np.abs(drawn_at(turning, 3, tmp_path) - alone[3]).max() > 0.05


def test_frames_from_a_key_to_the_next_one_are_asked_and_each_is_found_once(turning, tmp_path, monkeypatch):
    frames = frames_looked_at(monkeypatch)
    drawn_at(turning, 4, tmp_path)
    assert frames == []  # a key
    drawn_at(turning, 5, tmp_path)
    assert sorted(frames) == [4, 6, 7]
    frames.clear()
    drawn_at_once(turning, FRAMES, tmp_path)
    assert len(frames) == len(set(frames)) and set(frames) <= set(range(1, 8))


def test_marks_of_the_mesh_and_of_the_screen_need_no_other_frame(turning, tmp_path, monkeypatch):
    frames = frames_looked_at(monkeypatch)
    pens = [line_set.pen for line_set in own_style(turning).line_sets]
    for pen in pens:
        pen.texture_anchor = "SCREEN"
    over = drawn_at(turning, 5, tmp_path)
    assert frames == []
    own_style(turning).animation.marks_frames = 0
    np.testing.assert_array_equal(drawn_at(turning, 5, tmp_path), over)
    only_lines(turning, "crease", "border")
    for pen in pens:
        pen.texture_anchor = "PATH"
    still = drawn_at(turning, 5, tmp_path)
    own_style(turning).animation.marks_frames = APART
    np.testing.assert_array_equal(drawn_at(turning, 5, tmp_path), still)


def test_what_is_beyond_a_cut_does_not_count(turning, tmp_path):
    first = turning.camera
    other = add_camera((3, -5, 1), (0, 0, 0))
    for frame, camera in ((-10, first), (5, other)):
        turning.timeline_markers.new(f"at {frame}", frame=frame).camera = camera
    cut = {frame: drawn_at(turning, frame, tmp_path) for frame in (4, 5, 6)}
    first.location.x += 1.0  # seen by no frame from 5 on
    for frame in (5, 6):
        np.testing.assert_array_equal(drawn_at(turning, frame, tmp_path), cut[frame])
    assert np.abs(drawn_at(turning, 4, tmp_path) - cut[4]).max() > 0.05


def test_held_drawings_have_the_marks_of_their_frame(turning, tmp_path):
    at_five = drawn_at(turning, 5, tmp_path)
    own_style(turning).animation.hold = 2
    np.testing.assert_array_equal(drawn_at(turning, 6, tmp_path), at_five)


def test_moments_of_a_shutter_have_the_marks_of_their_frame(turning, tmp_path):
    def apart(marks_frames):
        style = own_style(turning)
        style.animation.marks_frames, style.animation.motion_blur = marks_frames, False
        sharp = ink(drawn_at(turning, 5, tmp_path))
        style.animation.motion_blur = True
        return np.abs(ink(drawn_at(turning, 5, tmp_path)) - sharp).sum() / sharp.sum()

    turning.render.use_motion_blur, turning.render.motion_blur_shutter = True, 0.02
    assert apart(APART) < 0.7 * apart(0)


def test_the_gpu_draws_the_same(turning, tmp_path):
    if part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    by_cpu = ink(drawn_at(turning, 5, tmp_path))
    turning.fovea.backend = "GPU"
    by_gpu = ink(drawn_at(turning, 5, tmp_path))
    assert np.abs(by_gpu - by_cpu).mean() < 0.004


def test_frames_around_it_are_asked_for_vectors_too(turning, tmp_path):
    """The frames around it are asked for them, too."""
    asked, near = [], near_frames.near

    def asking(engine, depsgraph, offsets, *others):
        asked.append(offsets)
        return near(engine, depsgraph, offsets, *others)

    near_frames.near = asking
    try:
        turning.frame_set(5)
        path = tmp_path / "strokes.svg"
        assert bpy.ops.fovea.export_vectors(filepath=str(path), kind="svg") == {"FINISHED"}
    finally:
        near_frames.near = near
    assert asked == [(-1, 1, 2)] and path.is_file()


@pytest.fixture
def baked(turning, tmp_path):
    """The same, with marks baked to a file beside it."""
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "turning.blend"))
    scene = bpy.context.scene
    own_style(scene).animation.marks_baked = True
    assert bpy.ops.fovea.bake_marks() == {"FINISHED"}
    return scene


def test_baked_marks_ask_for_no_other_frame_and_are_the_same_in_any_order(baked, tmp_path, monkeypatch):
    frames = frames_looked_at(monkeypatch)
    alone = {frame: drawn_at(baked, frame, tmp_path) for frame in FRAMES}
    assert frames == list(FRAMES)
    together = drawn_at_once(baked, FRAMES, tmp_path)
    for frame in FRAMES:
        np.testing.assert_array_equal(together[frame], alone[frame])
    own_style(baked).animation.marks_baked = False
    np.testing.assert_array_equal(drawn_at(baked, 1, tmp_path), alone[1])  # the first frame is a key of both
    assert np.abs(drawn_at(baked, 6, tmp_path) - alone[6]).max() > 0.05


def test_baked_marks_of_other_lines_are_handed_on_instead_and_it_is_told_once(baked, tmp_path, capfd):
    told = []
    session._remarked.clear()
    baked.camera.location.x += 0.5
    own_style(baked).animation.marks_baked = False
    handed_on = {frame: drawn_at(baked, frame, tmp_path) for frame in (5, 9)}
    own_style(baked).animation.marks_baked = True
    for frame in (5, 9):  # one that has changed, and one that was not baked
        np.testing.assert_array_equal(drawn_at(baked, frame, tmp_path), handed_on[frame])
        told.append(capfd.readouterr().out.count(session.NOT_BAKED))
    assert told == [1, 0]


BROKEN = ("cut off", "no zip", "of objects", "numbers", "shifted", "not finite", "huge", "flipped", "gone")


@pytest.mark.parametrize("broken", BROKEN)
def test_a_broken_file_of_marks_is_as_none(baked, tmp_path, broken):
    own_style(baked).animation.marks_baked = False
    handed_on = drawn_at(baked, 5, tmp_path)
    own_style(baked).animation.marks_baked = True
    (path,) = (tmp_path / "turning.fovea").iterdir()
    whole = path.read_bytes()
    with np.load(path) as file:
        columns = dict(file)
    if broken == "cut off":
        path.write_bytes(whole[: len(whole) // 2])
    elif broken == "no zip":
        path.write_bytes(b"marks")
    elif broken == "of objects":
        np.savez(path, **(columns | {"marks": np.array([print], object)}))
    elif broken == "numbers":
        np.savez(path, **(columns | {"offsets": columns["offsets"] + 7}))
    elif broken == "shifted":
        columns["offsets"][4] += 1  # between the fourth frame and the fifth
        np.savez(path, **columns)
    elif broken == "huge":
        np.savez(path, **(columns | {"marks": np.full_like(columns["marks"], 1e300)}))
    elif broken == "flipped":
        part = slice(len(whole) - 3000, len(whole) - 2800)
        path.write_bytes(whole[: part.start] + bytes(255 - byte for byte in whole[part]) + whole[part.stop :])
    elif broken == "not finite":
        np.savez(path, **(columns | {"marks": np.full_like(columns["marks"], np.nan)}))
    else:
        path.unlink()
    np.testing.assert_array_equal(drawn_at(baked, 5, tmp_path), handed_on)


def test_marks_are_baked_for_a_saved_file_whose_lines_have_some(turning, tmp_path):
    own_style(turning).animation.marks_frames = 0
    with pytest.raises(RuntimeError, match="Save the Blender file first"):
        bpy.ops.fovea.bake_marks()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "turning.blend"))
    with pytest.raises(RuntimeError, match="No line of the view has marks"):
        bpy.ops.fovea.bake_marks()
    assert not (tmp_path / "turning.fovea").exists()


def test_baked_marks_begin_anew_at_another_camera(turning, tmp_path):
    first, other = turning.camera, add_camera((3, -5, 1), (0, 0, 0))
    for frame, camera in ((-10, first), (5, other)):
        turning.timeline_markers.new(f"at {frame}", frame=frame).camera = camera
    own_style(turning).animation.marks_frames = 0
    own = drawn_at(turning, 5, tmp_path)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "cut.blend"))
    scene = bpy.context.scene
    own_style(scene).animation.marks_baked = True
    bpy.ops.fovea.bake_marks()
    began = drawn_at(scene, 5, tmp_path)
    own_style(scene).animation.marks_baked, own_style(scene).animation.marks_frames = False, 4  # frame 5 is a key
    np.testing.assert_array_equal(began, drawn_at(scene, 5, tmp_path))
    assert np.abs(began - own).max() > 0.05
