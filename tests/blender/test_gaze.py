# SPDX-License-Identifier: GPL-3.0-or-later
"""Check Focus and Strengthen Focus on a row of boxes, one of them in focus; and the gain of effects in the office."""

import sys
from pathlib import Path

import bpy
import numpy as np
import pytest
from the_addon import add_camera, box_mesh, empty_scene, new_object, part, use_style

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import scenes
from bench.focus import salience, world
from command.target import SHARED

gaze, gaze_check, style_data = part("gaze"), part("render.gaze_check"), part("style.style_data")
BOXES = "Left", "Middle", "Right"


@pytest.fixture
def scene():
    """Three boxes in a row, the right one in focus, in a style whose lines fade out of focus, but weakly."""
    scene = empty_scene()
    for name, x in zip(BOXES, (-5, 0, 5), strict=True):
        new_object(box_mesh(), name, (x, 0, 0))
    add_camera((0, -24, 3), (0, 0, 0))
    scene.render.engine, scene.render.resolution_x, scene.render.resolution_y = "FOVEA", 480, 270
    scene.fovea.backend = "CPU"
    held = use_style(scene, "pen_and_ink")
    for line_set in held.line_sets:
        line_set.away, line_set.pen_away.opacity = True, 0.0
    scene.fovea.focus_model, scene.fovea.focus_object = "OBJECT", bpy.data.objects["Right"]
    scene.fovea.focus_near_distance, scene.fovea.focus_far_distance = 0.5, 12.0
    bpy.context.view_layer.update()
    return scene


def set_emphasis(scene, emphasis):
    style_data.own(scene).effects.emphasis = emphasis


def test_the_eye_goes_to_the_box_that_alone_is_whole(scene):
    set_emphasis(scene, 10.0)
    checked = gaze_check.check(bpy.context)
    assert checked.names[0] == "Right" and checked.judged.wins
    assert "'Right' first, in focus" in checked.sentence
    assert scene.render.resolution_x == 480, "the scene itself is as it was"


def test_where_focus_changes_nothing_it_draws_nothing_to_itself(scene):
    effects = style_data.own(scene).effects
    effects.lines, effects.colors = "UNIFORM", "UNIFORM"
    judged = gaze_check.check(bpy.context).judged
    assert judged.gain == pytest.approx(1.0, abs=1e-6) and not judged.wins


def test_check_focus_shows_a_heat_map_and_changes_nothing(scene):
    before = style_data.fingerprint(style_data.of(scene))
    assert bpy.ops.fovea.check_focus() == {"FINISHED"}
    image = bpy.data.images["Gaze"]
    assert tuple(image.size) == (480, 270) and image.packed_file
    pixels = np.array(image.pixels[:]).reshape(270, 480, 4)
    assert np.ptp(pixels[..., :3], axis=2).max() > 0.2, "there are colors"
    assert style_data.fingerprint(style_data.of(scene)) == before


def test_strengthen_focus_sets_the_emphasis_at_which_the_focus_wins(scene):
    effects = style_data.own(scene).effects
    effects.emphasis = 0.1
    assert not gaze_check.check(bpy.context).judged.wins
    assert bpy.ops.fovea.strengthen_focus() == {"FINISHED"}
    assert 0.1 < effects.emphasis <= 10.0
    assert gaze_check.check(bpy.context).judged.wins
    emphasis = effects.emphasis
    assert bpy.ops.fovea.strengthen_focus() == {"FINISHED"}
    assert effects.emphasis == emphasis, "it is enough already"


def test_an_emphasis_that_is_keyed_is_keyed_at_this_frame(scene):
    effects = style_data.own(scene).effects
    effects.emphasis = 0.1
    effects.keyframe_insert("emphasis", frame=1)
    scene.frame_set(10)
    assert bpy.ops.fovea.strengthen_focus() == {"FINISHED"}
    strong = effects.emphasis
    scene.frame_set(1)
    assert effects.emphasis == pytest.approx(0.1)
    scene.frame_set(10)
    assert effects.emphasis == pytest.approx(strong) and strong > 0.1


def test_over_time_the_emphasis_is_keyed_where_it_is_looked_for_and_never_beyond_two_keys(scene):
    effects = style_data.own(scene).effects
    for frame, emphasis in ((0, 0.2), (5, 3.0), (30, 0.2)):
        effects.emphasis = emphasis
        effects.keyframe_insert("emphasis", frame=frame)
    focused = scene.fovea.focus_object
    for frame, x in ((1, 5), (21, 6)):
        focused.location.x = x
        focused.keyframe_insert("location", frame=frame)
    scene.frame_set(7)
    assert bpy.ops.fovea.strengthen_focus_over_time(frame_start=1, frame_end=21, step=8) == {"FINISHED"}
    assert scene.frame_current == 7
    (curve,) = part("scene.animation").channels(effects, "emphasis")
    assert [point.co.x for point in curve.keyframe_points] == [0, 1, 9, 17, 21, 30]
    keyed = {int(point.co.x): point.co.y for point in curve.keyframe_points}
    for frame in (1, 9, 17, 21):
        scene.frame_set(frame)
        assert effects.emphasis == pytest.approx(keyed[frame], rel=1e-5)
        assert gaze_check.check(bpy.context).judged.wins
    for first, last in ((1, 9), (9, 17), (17, 21)):
        low, high = sorted((keyed[first], keyed[last]))
        between = [curve.evaluate(frame) for frame in range(first, last)]
        assert low - 1e-5 <= min(between) and max(between) <= high + 1e-5


def test_over_time_it_says_where_the_focus_never_wins(scene):
    for line_set in style_data.own(scene).line_sets:
        line_set.away = False
    with pytest.raises(RuntimeError, match="Frame 5: The eye goes .*even with the most emphasis"):
        bpy.ops.fovea.strengthen_focus_over_time(frame_start=1, frame_end=5, step=2)
    assert not part("scene.animation").is_keyed(style_data.own(scene).effects, "emphasis")
    with pytest.raises(RuntimeError, match="ends before it starts"):
        bpy.ops.fovea.strengthen_focus_over_time(frame_start=9, frame_end=5)


def test_where_nothing_answers_to_focus_it_says_what_the_eye_goes_to(scene):
    for line_set in style_data.own(scene).line_sets:
        line_set.away = False
    with pytest.raises(RuntimeError, match="The eye goes .* first.*even with the most emphasis"):
        bpy.ops.fovea.strengthen_focus()
    assert style_data.own(scene).effects.emphasis == 1.0


def test_without_a_focus_both_say_so(scene):
    scene.fovea.focus_model = "NONE"
    for operator in (bpy.ops.fovea.check_focus, bpy.ops.fovea.strengthen_focus):
        with pytest.raises(RuntimeError, match="no focus yet"):
            operator()
    assert gaze_check.check(bpy.context).judged is None


def test_in_the_office_focus_draws_the_gaze_by_color_more_than_by_lines_and_most_by_both():
    bpy.ops.wm.read_homefile()
    scenes.build("office", SHARED if SHARED.is_dir() else None)

    def gains(world):
        stage = salience.Stage(world, salience.COLORFUL, salience.PLACES[1])
        return [stage.at(**effects).judged.gain for effects in salience.CONDITIONS.values()]

    both, color, lines = world.measure(gains, gaze.frame_size(1920, 1080))
    assert both > color > lines > 1
