# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings on twos, the hand's boil, lines that write themselves: which frames are the same to the last bit, and that
each is a function of the scene and its number."""

import random

import bpy
import numpy as np
import pytest
from photographs import parts, photograph
from pictures import box_scene_of_one_set, drawn, drawn_at_once, ink
from test_vectors import SVG, ElementTree, exported, points
from the_addon import add_camera, own_style, part

FRAMES = range(1, 7)


def animated(scene, **settings):
    """Sets members of a scene's style's Animation."""
    for name, value in settings.items():
        setattr(own_style(scene).animation, name, value)
    return scene


def still_scene(wobble=60.0, **settings):
    """A box drawn by a hand that strays by 5 pixels."""
    scene = box_scene_of_one_set()
    for line_set in own_style(scene).line_sets:
        line_set.pen.wobble, line_set.pen.wobble_length = wobble, 300.0
    return animated(scene, **settings)


def moving_scene(wobble=0.0, **settings):
    """The same box on its way, which a camera passes by."""
    scene = still_scene(wobble, **settings)
    for obj, by in ((scene.objects["Box"], 0.6), (scene.camera, 0.3)):
        for frame, share in ((FRAMES[0], 0.0), (FRAMES[-1], 1.0)):
            obj.location.x += share * by
            obj.keyframe_insert("location", frame=frame)
    return scene


@pytest.fixture
def at(tmp_path):
    """at(scene, frame): its picture, rendered alone."""

    def render(scene, frame):
        scene.frame_set(frame)
        return drawn(scene, tmp_path / f"{frame}.png")

    return render


def equal(pictures, one, other):
    return (pictures[one] == pictures[other]).all()


@pytest.mark.parametrize("hold", [2, 3])
def test_a_drawing_stands_for_as_many_frames_and_is_that_of_the_first(at, hold):
    scene = moving_scene()
    ones = {frame: at(scene, frame) for frame in FRAMES}
    assert not any(equal(ones, frame, frame + 1) for frame in FRAMES[:-1])
    animated(scene, hold=hold)
    for frame in FRAMES:
        assert (at(scene, frame) == ones[1 + (frame - 1) // hold * hold]).all(), frame
        assert scene.frame_current == frame


def test_drawings_are_counted_from_the_same_frame_whichever_are_rendered(at):
    scene = moving_scene(hold=2)
    alone = at(scene, 4)
    scene.frame_start = 4  # as a task of a farm may
    assert (at(scene, 4) == alone).all()
    animated(scene, start_frame=4)
    assert (at(scene, 4) == at(scene, 5)).all() and (at(scene, 4) != alone).any()


def test_a_cut_to_another_camera_ends_a_hold(at):
    scene = moving_scene(hold=4)
    other = add_camera((-4, -7, 5), (0, 0, 0))
    for frame, camera in ((1, bpy.data.objects["Camera"]), (3, other)):
        scene.timeline_markers.new(str(frame), frame=frame).camera = camera
    held = {frame: at(scene, frame) for frame in FRAMES}
    assert equal(held, 1, 2) and not equal(held, 2, 3) and equal(held, 3, 4)
    assert equal(held, 5, 6) and not equal(held, 4, 5)
    animated(scene, hold=1)
    for frame in (1, 3, 5):
        assert (at(scene, frame) == held[frame]).all(), frame


def test_a_still_scene_boils_in_a_cycle_whose_first_drawing_is_that_without_boil(at):
    scene = still_scene()
    still = at(scene, 1)
    animated(scene, boil=1.0, boil_hold=1, boil_cycle=3)
    boiled = {frame: at(scene, frame) for frame in range(1, 8)}
    assert (boiled[1] == still).all()
    for frame in range(1, 5):
        assert equal(boiled, frame, frame + 3), frame
    for frame in range(1, 7):
        assert np.abs(boiled[frame] - boiled[frame + 1]).max() > 0.5, frame
    animated(scene, boil_hold=2)
    assert all((at(scene, 2 * k + 1 + extra) == boiled[k + 1]).all() for k in range(3) for extra in (0, 1))


def test_nothing_but_the_hand_boils(at):
    scene = still_scene(wobble=0.0, boil=1.0, boil_hold=1)
    assert (at(scene, 1) == at(scene, 2)).all()


def test_a_held_drawing_boils_on(at):
    """A moving hold: the pose stands, the hand does not."""
    scene = moving_scene(wobble=60.0, hold=6, boil=1.0, boil_hold=1, boil_cycle=2)
    held = {frame: at(scene, frame) for frame in FRAMES}
    assert equal(held, 1, 3) and equal(held, 2, 4) and not equal(held, 1, 2)
    animated(scene, boil=0.0)
    assert (at(scene, 1) == held[1]).all() and (at(scene, 6) == held[1]).all()


def every_setting(smoothed):
    """A scene with all of them, line thinning over neighboring frames, and a pen that is keyed."""
    scene = moving_scene(wobble=60.0, hold=3, boil=0.5, boil_hold=1, boil_cycle=2)
    style, tree = own_style(scene), own_style(scene).id_data
    for frame, value in ((1, 0.3), (6, 0.9)):
        style.animation.written = value
        tree.keyframe_insert("fovea.animation.written", frame=frame)
    style.elision.enabled, style.elision.frames = smoothed > 0, smoothed
    return scene


@pytest.mark.parametrize("smoothed", [0, 1])
def test_a_frame_is_the_same_alone_in_order_backwards_and_shuffled(at, tmp_path, smoothed):
    alone = {frame: at(every_setting(smoothed), frame) for frame in FRAMES}
    assert not equal(alone, 1, 2) and equal(alone, 1, 3) and not equal(alone, 3, 4)
    scene = every_setting(smoothed)
    for frame in (*reversed(FRAMES), *random.Random(4).sample(FRAMES, len(FRAMES))):
        assert (at(scene, frame) == alone[frame]).all(), frame
    scene.frame_start, scene.frame_end = FRAMES[0], FRAMES[-1]
    for frame, picture in drawn_at_once(scene, FRAMES, tmp_path).items():
        assert (picture == alone[frame]).all(), frame


def test_written_lines_grow_from_nothing_to_all_of_them(at):
    scene = still_scene(wobble=0.0)
    whole = ink(at(scene, 1)).sum()
    amounts = []
    for share in (0.0, 0.25, 0.5, 0.75):
        animated(scene, written=share)
        amounts.append(ink(at(scene, 1)).sum() / whole)
    assert amounts[0] < 0.01 and np.abs(np.subtract(amounts, (0.0, 0.25, 0.5, 0.75))).max() < 0.1
    animated(scene, written=1.0)
    for line_set in own_style(scene).line_sets:
        line_set.pen.written = 0.5
    assert ink(at(scene, 1)).sum() == pytest.approx(amounts[2] * whole)


def lengths(path):
    """Length of all strokes in an SVG, which are straight."""
    paths = ElementTree.fromstring(exported(path, widths="center")).iter(f"{SVG}path")
    return sum(np.linalg.norm(np.diff(points(stroke), axis=0), axis=1).sum() for stroke in paths)


def test_vectors_have_the_strokes_of_the_picture(tmp_path):
    scene = still_scene(wobble=0.0)
    whole = lengths(tmp_path / "whole.svg")
    animated(scene, written=0.5)
    assert lengths(tmp_path / "half.svg") == pytest.approx(0.5 * whole, rel=0.02)
    scene = still_scene(boil=1.0, boil_hold=1, boil_cycle=2)
    files = []
    for frame in (1, 2, 3):
        scene.frame_set(frame)
        files.append(exported(tmp_path / f"{frame}.svg"))
    assert files[0] == files[2] != files[1]


def test_over_the_render_of_another_engine_only_the_lines_hold(at):
    scene = photograph("CYCLES")
    scene.cycles.samples = 1
    for frame, x in ((1, 0.0), (2, 0.3)):
        for obj in scene.objects:
            if obj.type == "MESH":
                obj.delta_location.x = x
                obj.keyframe_insert("delta_location", frame=frame)
    bpy.ops.fovea.lines_over()
    ones = {frame: parts(at(scene, frame)) for frame in (1, 2)}
    animated(scene, hold=2)
    held = {frame: parts(at(scene, frame)) for frame in (1, 2)}
    (photo, first), (moved, second), (below, lines) = ones[1], ones[2], held[2]
    assert (held[1][1] == first).all() and np.abs(second - first).max() > 0.5
    assert np.abs(lines - first).max() < 0.01, "the lines are those of the first frame"
    bare = (lines == 0) & (second == 0) & (first == 0)
    assert np.abs(below - moved)[bare].max() < 0.01, "the render is that of the second"
    assert np.abs(below - photo)[bare].max() > 0.5


def test_baked_strokes_hold_and_boil_as_renders_do():
    pencils = part("scene.pencils")
    if not pencils.are_there():
        pytest.skip("this Blender has no Grease Pencil of its third generation")
    scene = moving_scene(wobble=60.0, hold=2, boil=1.0, boil_hold=1, boil_cycle=2)
    assert bpy.ops.fovea.bake_strokes(frames="RANGE", frame_start=1, frame_end=4) == {"FINISHED"}
    baked = part("render.pencil_bake").found_in(scene)
    found = [baked.data.layers[0].get_frame_at(frame).drawing for frame in range(1, 5)]
    places = []
    for drawing in found:
        values = np.empty((len(drawing.attributes["position"].data), 3), np.float32)
        drawing.attributes["position"].data.foreach_get("vector", values.ravel())
        places.append(values)
    first = [values[0] for values in places]
    assert (first[0] == first[1]).all() and (first[2] == first[3]).all() and (first[0] != first[2]).any()
    assert places[0].shape != places[1].shape or np.abs(places[0] - places[1]).max() > 0
