# SPDX-License-Identifier: GPL-3.0-or-later
"""Focus pulls from scripts: keyframes, motion, undo."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from mathutils import Vector
from panel_layouts import RecordingLayout
from the_addon import a_box_to_look_at, part

places, pull = part("focus.focus_places"), part("focus.focus_pull")


@pytest.fixture
def scene():
    return a_box_to_look_at()


def values(scene, name, owner=None):
    """Values of a keyed property at frames 1, 10 and 20."""
    owner = owner or scene.fovea
    found = []
    for frame in (1, 10, 20):
        scene.frame_set(frame)
        value = getattr(owner, name)
        found.append(tuple(value) if hasattr(value, "__len__") else value)
    return found


def test_a_pull_moves_the_empty_and_the_radii(scene):
    bpy.ops.fovea.pick_focus(location=(-4, 0, 0))
    scene.fovea.focus_near_distance, scene.fovea.focus_far_distance = 1, 2
    asked = {"target": "OBJECT", "object": "Box", "frame_start": 1, "frame_end": 20, "near": 2.0, "far": 6.0}
    assert bpy.ops.fovea.focus_pull(**asked, easing="LINEAR") == {"FINISHED"}
    mark = scene.fovea.focus_object
    first, middle, last = values(scene, "location", mark)
    assert first == pytest.approx((-4, 0, 0)) and last == pytest.approx((1, 2, 0))
    assert middle == pytest.approx(tuple(np.array(first) + (np.array(last) - first) * 9 / 19))
    assert values(scene, "focus_near_distance")[::2] == [1, 2] and values(scene, "focus_far_distance")[::2] == [2, 6]


def test_a_gentle_pull_sets_out_slowly(scene):
    bpy.ops.fovea.pick_focus(location=(0, 0, 0))
    asked = {"target": "LOCATION", "location": (10, 0, 0), "frame_start": 1, "frame_end": 21}
    bpy.ops.fovea.focus_pull(**asked, easing="CUBIC")
    mark = scene.fovea.focus_object
    scene.frame_set(3)
    assert 0 < mark.location.x < 0.2
    scene.frame_set(11)
    assert mark.location.x == pytest.approx(5, abs=1e-3)
    scene.frame_set(19)
    assert 9.8 < mark.location.x < 10


def test_a_pull_in_the_image(scene):
    scene.fovea.focus_model, scene.fovea.focus_place = "IMAGE", (0.1, 0.2)
    scene.objects["Box"].location = (0, 0, 0)  # where the camera looks
    bpy.context.view_layer.update()
    bpy.ops.fovea.focus_pull(target="OBJECT", object="Box", frame_start=1, frame_end=20)
    found = values(scene, "focus_place")
    assert found[0] == pytest.approx((0.1, 0.2)) and found[2] == pytest.approx((0.5, 0.5), abs=1e-4)


def test_the_dialog_asks_for_an_object_that_can_be_picked_and_leads_there(scene):
    bpy.ops.fovea.pick_focus(location=(-4, 0, 0))
    scene.fovea.pull_object = scene.objects["Box"]
    bpy.ops.fovea.focus_pull(asked=True, target="OBJECT", frame_start=1, frame_end=20)
    assert values(scene, "location", scene.fovea.focus_object)[2] == pytest.approx((1, 2, 0))
    assert scene.fovea.pull_object is None, "it is no setting of the scene"
    with pytest.raises(RuntimeError, match="Choose an object"):
        bpy.ops.fovea.focus_pull(asked=True, target="OBJECT", frame_start=1, frame_end=20)


@pytest.mark.parametrize("model, radii", [("SCENE", ["near", "far"]), ("IMAGE", ["near_heights", "far_heights"])])
def test_radii_of_the_dialog_have_the_units_of_the_place(scene, model, radii):
    scene.fovea.focus_model = model
    dialog, layout = pull.FOVEA_OT_focus_pull, RecordingLayout()
    known = bpy.ops.fovea.focus_pull.get_rna_type().properties
    dialog.draw(
        SimpleNamespace(layout=layout, target="LOCATION", bl_rna=SimpleNamespace(properties=known)), bpy.context
    )
    assert [name for name in layout.shown if name.startswith(("near", "far"))] == radii
    assert all((known[name].unit == "LENGTH") == (model == "SCENE") for name in radii)


def test_a_pull_of_a_location_without_a_mark(scene):
    scene.fovea.focus_model, scene.fovea.focus_location = "SCENE", (1, 1, 1)
    bpy.ops.fovea.focus_pull(target="LOCATION", location=(3, 1, 1), frame_start=1, frame_end=20)
    found = values(scene, "focus_location")
    assert found[0] == pytest.approx((1, 1, 1)) and found[2] == pytest.approx((3, 1, 1))


def test_a_pull_with_a_parent_arrives(scene):
    bpy.ops.fovea.pick_focus(location=(0, 0, 0))
    mark, parent = scene.fovea.focus_object, scene.camera
    mark.parent = parent
    bpy.context.view_layer.update()
    bpy.ops.fovea.focus_pull(target="LOCATION", location=(3, 1, 1), frame_start=1, frame_end=20)
    scene.frame_set(20)
    assert (mark.matrix_world.translation - Vector((3, 1, 1))).length < 1e-4


def test_a_pull_away_from_a_mesh_leaves_it_there(scene):
    box = scene.objects["Box"]
    scene.fovea.focus_model, scene.fovea.focus_object = "SCENE", box
    bpy.ops.fovea.focus_pull(target="LOCATION", location=(9, 9, 9), frame_start=1, frame_end=20)
    scene.frame_set(20)
    assert box.location == Vector((1, 2, 0))
    first, _, last = values(scene, "location", scene.fovea.focus_object)
    assert first == pytest.approx((1, 2, 0)) and last == pytest.approx((9, 9, 9))


def test_a_pull_widens_the_frames_of_the_scene_where_it_must_and_says_so(scene, capfd):
    scene.frame_start, scene.frame_end = 10, 20
    bpy.ops.fovea.pick_focus(location=(0, 0, 0))
    asked = {"target": "LOCATION", "location": (3, 1, 1)}
    bpy.ops.fovea.focus_pull(**asked, frame_start=12, frame_end=20)
    assert (scene.frame_start, scene.frame_end) == (10, 20) and "frames are" not in capfd.readouterr().out
    bpy.ops.fovea.focus_pull(**asked, frame_start=12, frame_end=60)
    assert (scene.frame_start, scene.frame_end) == (10, 60)
    assert "The scene's frames are 10 to 60 now" in capfd.readouterr().out
    bpy.ops.fovea.focus_pull(**asked, frame_start=1, frame_end=5)
    assert (scene.frame_start, scene.frame_end) == (1, 60)


def test_what_cannot_be_pulled_is_told(scene):
    for model in ("NONE", "OBJECT", "PAINTED"):
        scene.fovea.focus_model = model
        assert not bpy.ops.fovea.focus_pull.poll()
        with pytest.raises(RuntimeError, match="[Pp]ick"):
            bpy.ops.fovea.focus_pull()
    scene.fovea.focus_model = "SCENE"
    for asked, told in (
        ({"target": "OBJECT", "object": "Nobody"}, "no object 'Nobody'"),
        ({"target": "OBJECT"}, "Choose an object"),
        ({"target": "CURSOR", "frame_start": 5, "frame_end": 5}, "ends at frame 5"),
    ):
        with pytest.raises(RuntimeError, match=told):
            bpy.ops.fovea.focus_pull(**asked)


def test_picks_are_keyed_where_the_scene_keys_by_itself(scene):
    bpy.ops.fovea.pick_focus(location=(1, 2, 3))
    assert scene.fovea.focus_object.animation_data is None
    scene.tool_settings.use_keyframe_insert_auto = True
    try:
        for frame in (1, 20):
            scene.frame_set(frame)
            bpy.ops.fovea.pick_focus(location=(frame, 0, 0))
    finally:
        scene.tool_settings.use_keyframe_insert_auto = False
    first, _, last = values(scene, "location", scene.fovea.focus_object)
    assert first == pytest.approx((1, 0, 0)) and last == pytest.approx((20, 0, 0))


def test_pulls_and_picks_are_undone(scene):
    if not bpy.ops.ed.undo_push.poll():
        pytest.skip("this Blender has no undo without a window")
    bpy.ops.ed.undo_push(message="start")
    bpy.ops.fovea.pick_focus("EXEC_DEFAULT", True, location=(1, 2, 3))
    bpy.ops.fovea.focus_pull("EXEC_DEFAULT", True, target="LOCATION", location=(9, 9, 9))
    bpy.ops.ed.undo()
    scene = bpy.context.scene
    assert scene.fovea.focus_object.animation_data is None and places.location(scene.fovea) == Vector((1, 2, 3))
    bpy.ops.ed.undo()
    assert bpy.context.scene.fovea.focus_model == "NONE"


def test_a_still_is_offered_two_seconds(scene):
    scene.render.fps, scene.frame_start, scene.frame_end = 24, 5, 5
    assert part("focus.focus_pull").frames_of(scene) == (5, 53)
    scene.frame_end = 100
    assert part("focus.focus_pull").frames_of(scene) == (5, 100)
