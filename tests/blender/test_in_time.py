# SPDX-License-Identifier: GPL-3.0-or-later
"""Elision smoothed in time: a frame rendered alone equals that of an animation, and lines appear and disappear more
slowly."""

import math
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest
from pictures import drawn_at, drawn_at_once, exact_stills, frames_looked_at, ink
from the_addon import add_camera, box_mesh, empty_scene, grows, lines_of, new_object, own_style, part, use_style

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

from bench.focus import coherence, world

near_frames, session = part("render.near_frames"), part("render.session")
FRAMES = range(1, 6)


def set_elision(scene, name, value):
    setattr(own_style(scene).elision, name, value)


def key_spacing(scene, frame, value):
    pen = lines_of(scene).pen
    pen.spacing = value
    pen.keyframe_insert("spacing", frame=frame)


@pytest.fixture
def fence():
    """Posts in a row and a camera that goes along them, whose lines crowd each other more and more."""
    scene = empty_scene()
    exact_stills(scene, 320, 180)
    mesh = box_mesh(0.3)
    for k in range(14):
        new_object(mesh, f"Post{k:02}", (0.9 * k - 6, 0.5 * k, 0)).scale.z = 6
    camera = add_camera((-3, -16, 3), (0, 0, 0))
    for frame, x in ((-4, -4.5), (10, 4.5)):
        camera.location.x = x
        camera.keyframe_insert("location", index=0, frame=frame)
    scene.frame_start, scene.frame_end = FRAMES[0], FRAMES[-1]
    fovea = scene.fovea
    fovea.backend, fovea.visibility = "CPU", "EXACT"
    pen = use_style(scene, "plain").line_sets[-1].pen
    pen.spacing, pen.width = 90, 4
    set_elision(scene, "enabled", True)
    set_elision(scene, "frames", 2)
    return scene


def test_a_frame_alone_is_that_of_the_animation_either_way(fence, tmp_path):
    """Also where meshes change their shape, and so their surfaces, from frame to frame."""
    grown = new_object(box_mesh(0.3, "Grown"), "Grown", (0, -3, 0))
    grows(grown, 9, -4, 10)
    alone = drawn_at(fence, 3, tmp_path)
    forwards = drawn_at_once(fence, FRAMES, tmp_path)
    backwards = {frame: drawn_at(fence, frame, tmp_path) for frame in reversed(FRAMES)}
    np.testing.assert_array_equal(alone, forwards[3])
    for frame in FRAMES:
        np.testing.assert_array_equal(backwards[frame], forwards[frame])
    assert np.abs(forwards[3] - forwards[4]).max() > 0.3
    set_elision(fence, "frames", 0)
    assert np.abs(drawn_at(fence, 3, tmp_path) - alone).max() > 0.05


@pytest.fixture
def looked(monkeypatch):
    """Frames whose lines are found, in order."""
    return frames_looked_at(monkeypatch)


def test_the_lines_of_a_frame_are_found_once_in_an_animation(fence, tmp_path, looked):
    drawn_at_once(fence, FRAMES, tmp_path)
    others = set(range(FRAMES[0] - 2, FRAMES[-1] + 3)) - {FRAMES[0]}  # whose lines are found as it is drawn
    assert sorted(looked) == sorted(others)
    assert not near_frames._frames.looked, "nothing is kept beyond it"


def test_the_lines_of_each_view_layer_are_found_once(fence, tmp_path, looked):
    fence.view_layers.new("Other")
    drawn_at_once(fence, FRAMES, tmp_path)
    assert len(looked) == 2 * (len(FRAMES) + 4 - 1)


def test_a_cut_and_one_back_again_are_cuts_in_an_animation(fence, tmp_path):
    other = add_camera((6, -14, 9), (0, 0, 0))
    for frame, camera in ((-10, fence.camera), (3, other), (4, fence.camera)):
        fence.timeline_markers.new(f"at {frame}", frame=frame).camera = camera
    found = drawn_at_once(fence, FRAMES, tmp_path)
    for frame in FRAMES:
        np.testing.assert_array_equal(drawn_at(fence, frame, tmp_path), found[frame])


def test_a_memory_limit_changes_no_picture(fence, tmp_path, looked):
    kept = part("scene.kept")
    whole = drawn_at_once(fence, FRAMES, tmp_path)
    often = len(looked)
    kept.limit = 1
    try:
        small = drawn_at_once(fence, FRAMES, tmp_path)
    finally:
        kept.limit = 0
    assert len(looked) - often > often, "lines are let go"
    for frame in FRAMES:
        np.testing.assert_array_equal(small[frame], whole[frame])


def test_what_changes_between_the_frames_of_an_animation_counts(fence, tmp_path):
    """As a script that answers to a frame may do."""
    post = bpy.data.objects["Post06"]

    def move(scene, *_):
        if scene.frame_current == 2:
            post.location.x += 0.4

    bpy.app.handlers.render_post.append(move)
    try:
        found = drawn_at_once(fence, FRAMES, tmp_path)
    finally:
        bpy.app.handlers.render_post.remove(move)
    for frame in (3, 4, 5):
        np.testing.assert_array_equal(drawn_at(fence, frame, tmp_path), found[frame])


def test_frames_beyond_the_range_count_as_well(fence, tmp_path):
    alone = drawn_at(fence, 1, tmp_path)
    fence.frame_start = -10
    np.testing.assert_array_equal(drawn_at(fence, 1, tmp_path), alone)


def test_the_scene_is_left_at_its_frame(fence, tmp_path, monkeypatch):
    drawn_at(fence, 3, tmp_path)
    assert fence.frame_current == 3 and fence.frame_subframe == 0
    assert session.last_statistics()["stages"]["near_frames"] > 0
    asked = []

    def broken(*_arguments, **_options):
        asked.append(fence.frame_current)
        raise ValueError("ink ran out")

    monkeypatch.setattr(session.pipeline, "frame", broken)
    with pytest.raises(RuntimeError, match="ink ran out"):
        drawn_at(fence, 3, tmp_path)
    assert asked == [1] and fence.frame_current == 3 and fence.frame_subframe == 0


def test_what_is_keyed_has_its_own_value_at_every_frame(fence, tmp_path):
    """Spacing changes in a jump: the frames before it, as they were, count for those after it."""
    fence.camera.animation_data_clear()
    for frame, spacing in ((3, 0), (4, 160)):
        key_spacing(fence, frame, spacing)
    amounts = [ink(drawn_at(fence, frame, tmp_path)).sum() for frame in range(8)]
    assert amounts[0] == pytest.approx(amounts[1]) and amounts[6] == pytest.approx(amounts[7])
    steps = -np.diff(amounts[1:7])
    assert (steps > 0).all() and steps.max() < 0.5 * (amounts[0] - amounts[7])
    set_elision(fence, "frames", 0)
    assert ink(drawn_at(fence, 3, tmp_path)).sum() == pytest.approx(amounts[0])
    assert ink(drawn_at(fence, 4, tmp_path)).sum() == pytest.approx(amounts[7])


def test_where_nothing_moves_nothing_changes(fence, tmp_path):
    fence.camera.animation_data_clear()
    smooth = drawn_at(fence, 3, tmp_path)
    set_elision(fence, "frames", 0)
    np.testing.assert_array_equal(drawn_at(fence, 3, tmp_path), smooth)


def test_a_cut_to_another_camera_is_one(fence, tmp_path):
    first = fence.camera
    other = add_camera((6, -14, 9), (0, 0, 0))
    for frame, camera in ((-10, first), (4, other)):
        fence.timeline_markers.new(f"at {frame}", frame=frame).camera = camera
    cut = drawn_at(fence, 4, tmp_path)
    first.animation_data_clear()
    first.location.x += 2.0  # seen by no frame from 4 on
    np.testing.assert_array_equal(drawn_at(fence, 4, tmp_path), cut)


@pytest.mark.parametrize("name, value", [("visibility", "SPINE"), ("enabled", False), ("frames", 0)])
def test_other_frames_are_asked_only_where_they_count(fence, tmp_path, monkeypatch, name, value):
    def asked(*_arguments):
        raise AssertionError("another frame was asked")

    monkeypatch.setattr(near_frames, "near", asked)
    if name == "visibility":
        fence.fovea.visibility = value
    else:
        set_elision(fence, name, value)
    drawn_at(fence, 3, tmp_path)
    assert "near_frames" not in session.last_statistics()["stages"]


@pytest.mark.parametrize("backend", ["CPU", "GPU"])
def test_lines_come_and_go_more_slowly(fence, tmp_path, backend):
    if backend == "GPU" and part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    fence.fovea.backend = backend
    kept, pipeline = [], part("pipeline")

    def drawn_lines(frame):
        """Places on the lines of a picture, of which the pipeline made the last Frame."""
        made = []
        with world.kept_results(pipeline, "frame", made):
            drawn_at(fence, frame, tmp_path)
        return coherence.on_paths(world.Drawn(None, made[-1].view, None, made[-1], made[-1].shown))

    largest = {}
    for frames in (0, 1, 3):
        set_elision(fence, "frames", frames)
        kept.clear()
        for frame in FRAMES:
            kept.append(drawn_lines(frame))
        changes = [coherence.changes(a, b, math.inf)[0] for a, b in zip(kept, kept[1:])]
        largest[frames] = max(found.max() for found in changes)
        assert min(len(found) for found in changes) > 500
    assert largest[0] > 0.3
    assert largest[3] < largest[1] < largest[0] and largest[3] < 0.6 * largest[0]
