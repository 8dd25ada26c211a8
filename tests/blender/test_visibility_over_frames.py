# SPDX-License-Identifier: GPL-3.0-or-later
"""Visibility over frames: lines come and go by how long they are seen, and each frame is a function of the scene and
its number."""

import random

import bpy
import numpy as np
import pytest
from pictures import drawn_at, drawn_at_once, exact_stills, frames_looked_at, ink
from the_addon import add_camera, box_mesh, empty_scene, new_object, only_lines, own_style, part, use_style

near_frames = part("render.near_frames")
FRAMES = range(1, 6)


def over(scene, frames, vanish="FADE"):
    animation = own_style(scene).animation
    animation.visibility_frames, animation.vanish = frames, vanish


@pytest.fixture
def passing():
    """A pole that passes before a row of posts, which the camera passes, too."""
    scene = empty_scene()
    exact_stills(scene, 240, 160)
    mesh = box_mesh(0.5)
    for k in range(6):
        new_object(mesh, f"Post{k}", (1.4 * k - 3.5, 2, 0)).scale.z = 5
    pole = new_object(box_mesh(0.3, "Pole"), "Pole", (0, -2, 0))
    pole.scale.z = 20
    camera = add_camera((0, -14, 2), (0, 0, 0))
    for obj, axis, by in ((pole, 0, 0.3), (camera, 0, 0.04)):
        for frame in (-10, 20):
            obj.location[axis] = by * frame
            obj.keyframe_insert("location", index=axis, frame=frame)
    scene.frame_start, scene.frame_end = FRAMES[0], FRAMES[-1]
    scene.fovea.backend, scene.fovea.visibility = "CPU", "EXACT"
    use_style(scene, "plain")
    only_lines(scene, "crease", "contour")
    over(scene, 2)
    return scene


@pytest.mark.parametrize("vanish, thinned", [("FADE", 1), ("BREAK_UP", 0)])
def test_a_frame_is_the_same_alone_in_order_backwards_and_shuffled(passing, tmp_path, vanish, thinned):
    own_style(passing).elision.enabled, own_style(passing).elision.frames = thinned > 0, thinned
    over(passing, 2, vanish)
    alone = {frame: drawn_at(passing, frame, tmp_path) for frame in FRAMES}
    together = drawn_at_once(passing, FRAMES, tmp_path)
    for frame in (*FRAMES, *reversed(FRAMES), *random.Random(4).sample(FRAMES, len(FRAMES))):
        np.testing.assert_array_equal(drawn_at(passing, frame, tmp_path), alone[frame])
    for frame in FRAMES:
        np.testing.assert_array_equal(together[frame], alone[frame])
    over(passing, 0)
    assert np.abs(drawn_at(passing, 3, tmp_path) - alone[3]).max() > 0.05


def test_without_it_no_other_frame_is_asked(passing, tmp_path, monkeypatch):
    def asked(*_arguments):
        raise AssertionError("another frame was asked")

    monkeypatch.setattr(near_frames, "near", asked)
    over(passing, 0)
    drawn_at(passing, 3, tmp_path)
    over(passing, 2)
    passing.fovea.visibility = "SPINE"
    drawn_at(passing, 3, tmp_path)


def test_the_lines_of_a_frame_are_found_once_in_an_animation(passing, tmp_path, monkeypatch):
    frames = frames_looked_at(monkeypatch)
    drawn_at_once(passing, FRAMES, tmp_path)
    assert sorted(frames) == sorted(set(range(FRAMES[0] - 2, FRAMES[-1] + 3)) - {FRAMES[0]})


def test_a_cut_to_another_camera_ends_the_window(passing, tmp_path):
    first = passing.camera
    other = add_camera((3, -13, 3), (0, 0, 0))
    for frame, camera in ((-10, first), (4, other)):
        passing.timeline_markers.new(f"at {frame}", frame=frame).camera = camera
    cut = drawn_at(passing, 4, tmp_path)
    first.animation_data_clear()
    first.location.x += 2.0  # seen by no frame from 4 on
    np.testing.assert_array_equal(drawn_at(passing, 4, tmp_path), cut)


def test_an_object_that_hides_for_a_single_frame_does_not_blink(passing, tmp_path):
    pole = bpy.data.objects["Pole"]
    for each in (pole, passing.camera):
        each.animation_data_clear()
    passing.camera.location.x, pole.location.x = 0.0, 0.3
    pole.fovea.usage = "OCCLUDE"
    for frame, hidden in ((-10, True), (3, False), (4, True)):
        pole.hide_render = hidden
        pole.keyframe_insert("hide_render", frame=frame)
    over(passing, 0)
    at_once = {frame: ink(drawn_at(passing, frame, tmp_path)).sum() for frame in (2, 3, 4)}
    assert at_once[2] == at_once[4] > 1.02 * at_once[3]
    over(passing, 2)
    blurred = {frame: ink(drawn_at(passing, frame, tmp_path)).sum() for frame in (-1, 1, 2, 3, 4, 5, 7)}
    missing = {frame: (at_once[2] - amount) / (at_once[2] - at_once[3]) for frame, amount in blurred.items()}
    assert missing[-1] == missing[7] == 0
    for frame in (2, 3, 4):
        assert missing[frame] == pytest.approx(1 / 4, abs=0.06)
    for frame in (1, 5):
        assert missing[frame] == pytest.approx(1 / 8, abs=0.06)


def test_a_change_of_topology_ends_the_match(passing, tmp_path):
    """A post whose mesh is another one from frame 4 on has no past there."""
    post = bpy.data.objects["Post3"]
    builds = post.modifiers.new("Finer", "SUBSURF")
    builds.subdivision_type, builds.levels, builds.render_levels = "SIMPLE", 1, 1
    for frame, on in ((-10, False), (4, True)):
        builds.show_render = builds.show_viewport = on
        builds.keyframe_insert("show_render", frame=frame)
        builds.keyframe_insert("show_viewport", frame=frame)
    pictures = {frame: drawn_at(passing, frame, tmp_path) for frame in (3, 4)}
    assert all(ink(picture).sum() > 0 for picture in pictures.values())
    bpy.data.objects["Pole"].animation_data_clear()
    passing.camera.animation_data_clear()
    still = drawn_at(passing, 4, tmp_path)
    over(passing, 0)
    np.testing.assert_array_equal(drawn_at(passing, 4, tmp_path), still)


@pytest.mark.parametrize("vanish", ["FADE", "SHRINK", "BREAK_UP", "RETRACT"])
def test_the_gpu_draws_the_same(passing, tmp_path, vanish):
    if part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    over(passing, 2, vanish)
    by_cpu = drawn_at(passing, 3, tmp_path)
    passing.fovea.backend = "GPU"
    off = np.abs(drawn_at(passing, 3, tmp_path) - by_cpu)
    assert off.mean() < 1e-3 and (off > 0.05).mean() < 1e-3
