# SPDX-License-Identifier: GPL-3.0-or-later
"""The focus tools from scripts: picking, dragging gizmos, the overlay's colors."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from mathutils import Matrix, Vector
from panel_layouts import RecordingLayout
from the_addon import a_box_to_look_at, box_mesh, fovea, new_object, part

KINDS = part("focus.focus_kinds").KINDS
places, gizmos, overlay = part("focus.focus_places"), part("focus.focus_gizmos"), part("ui.focus_overlay")
operators, registration = part("focus.focus_operators"), part("scene.registration")
camera, reading, style = part("scene.camera"), part("render.reading"), part("style")


@pytest.fixture
def scene():
    return a_box_to_look_at()


def look(projection=None, location=(0, 0, -10), frame=(0, 0, 400, 200)):
    """A Look through a viewport of 400 x 200 pixels that sees the scene from above."""
    projection = projection or Matrix(((1, 0, 0, 0), (0, 2, 0, 0), (0, 0, -1.002, -0.2002), (0, 0, -1, 0)))
    view_matrix = Matrix.Translation(location)
    view = SimpleNamespace(
        view_matrix=view_matrix,
        perspective_matrix=projection @ view_matrix,
        is_perspective=projection[3][3] == 0,
        view_perspective="PERSP",
    )
    return places.Look(SimpleNamespace(width=400, height=200), view, frame)


def at(x, y):
    return SimpleNamespace(mouse_region_x=x, mouse_region_y=y)


def test_a_picked_location_is_marked_by_an_empty(scene):
    assert bpy.ops.fovea.pick_focus(location=(1, 2, 3)) == {"FINISHED"}
    settings, mark = scene.fovea, scene.fovea.focus_object
    assert settings.focus_model == "SCENE" and mark.type == "EMPTY" and mark.name in scene.objects
    assert places.location(settings) == mark.location == Vector((1, 2, 3))


def test_the_next_pick_moves_the_empty(scene):
    bpy.ops.fovea.pick_focus(location=(1, 2, 3))
    mark, count = scene.fovea.focus_object, len(scene.objects)
    bpy.ops.fovea.pick_focus(location=(4, 5, 6))
    assert scene.fovea.focus_object == mark and len(scene.objects) == count
    assert mark.location == Vector((4, 5, 6))


def test_an_empty_with_a_parent_comes_to_the_place(scene):
    bpy.ops.fovea.pick_focus(location=(1, 2, 3))
    mark, parent = scene.fovea.focus_object, scene.objects["Box"]
    mark.parent, parent.rotation_euler.z, parent.scale = parent, 1.0, (2, 2, 2)
    bpy.context.view_layer.update()
    bpy.ops.fovea.pick_focus(location=(4, 5, 6))
    bpy.context.view_layer.update()
    assert (mark.matrix_world.translation - Vector((4, 5, 6))).length < 1e-5


def test_objects_that_are_no_empties_stay_where_they_are(scene):
    box = scene.objects["Box"]
    scene.fovea.focus_model, scene.fovea.focus_object = "SCENE", box
    bpy.ops.fovea.pick_focus(location=(4, 5, 6))
    assert box.location == Vector((1, 2, 0)) and scene.fovea.focus_object.type == "EMPTY"


def test_adding_keeps_the_places_there_are(scene):
    bpy.ops.fovea.pick_focus(location=(1, 2, 3))
    scene.fovea.focus_far_distance = 7
    bpy.ops.fovea.pick_focus(location=(4, 5, 6), add=True)
    first, second = places.places(scene.fovea)
    assert places.location(first) == Vector((1, 2, 3)) and places.location(second) == Vector((4, 5, 6))
    assert first.focus_object != second.focus_object and second.focus_far_distance == 7


def test_there_is_a_most_of_places(scene):
    for step in range(style.MOST_PLACES):
        bpy.ops.fovea.pick_focus(location=(step, 0, 0), add=True)
    assert len(places.places(scene.fovea)) == style.MOST_PLACES
    assert bpy.ops.fovea.pick_focus(location=(9, 9, 9), add=True) == {"CANCELLED"}
    assert len(places.places(scene.fovea)) == style.MOST_PLACES


def keyed(scene):
    """Paths of the scene's F-curves."""
    return [curve.data_path for curves in part("scene.animation").curves(scene) for curve in curves]


def test_places_are_removed_with_what_animates_them(scene):
    for x in range(4):
        bpy.ops.fovea.pick_focus(location=(x, 0, 0), add=x > 0)
    points = scene.fovea.focus_points
    points[0].focus_far_distance, points[2].focus_far_distance = 7, 9
    points[0].keyframe_insert("focus_far_distance", frame=1), points[2].keyframe_insert("focus_far_distance", frame=1)
    assert bpy.ops.fovea.focus_place_remove(index=0) == {"FINISHED"}
    assert [places.location(place).x for place in places.places(scene.fovea)] == [0, 2, 3]
    assert keyed(scene) == ["fovea.focus_points[1].focus_far_distance"]
    assert bpy.ops.fovea.focus_place_remove() == {"FINISHED"} and not keyed(scene)
    assert bpy.ops.fovea.focus_place_remove(index=1) == {"CANCELLED"} and len(points) == 1
    assert bpy.ops.fovea.focus_place_remove() == {"FINISHED"} and not bpy.ops.fovea.focus_place_remove.poll()


def test_the_first_place_is_removed_alone_and_the_next_one_takes_its_part(scene):
    for x in range(3):
        bpy.ops.fovea.pick_focus(location=(x, 0, 0), add=x > 0)
    settings, points = scene.fovea, scene.fovea.focus_points
    marks = [place.focus_object for place in places.places(settings)]
    points[0].focus_far_distance, points[1].focus_far_distance = 7, 9
    for owner in (settings, *points):
        owner.keyframe_insert("focus_far_distance", frame=1)
    assert bpy.ops.fovea.focus_place_remove(first=True) == {"FINISHED"}
    assert [place.focus_object for place in places.places(settings)] == marks[1:]
    assert [place.focus_far_distance for place in places.places(settings)] == [7, 9]
    curves = {c.data_path: c.evaluate(1) for bag in part("scene.animation").curves(scene) for c in bag}
    assert curves == {"fovea.focus_far_distance": 7, "fovea.focus_points[0].focus_far_distance": 9}
    assert bpy.ops.fovea.focus_place_remove(first=True) == {"FINISHED"} and settings.focus_object == marks[2]
    assert not bpy.ops.fovea.focus_place_remove.poll() and marks[0].name in scene.objects


def test_the_location_of_the_empty_that_marks_a_place_is_in_the_panel_where_its_keys_are_seen(scene):
    bpy.ops.fovea.pick_focus(location=(1, 2, 3))
    layout = RecordingLayout()
    part("ui.focus").draw_focus(layout, scene.fovea)
    assert (scene.fovea.focus_object, "location") in layout.props and layout.use_property_decorate
    scene.fovea.focus_object = scene.objects["Box"]
    layout = RecordingLayout()
    part("ui.focus").draw_focus(layout, scene.fovea)
    assert "location" not in layout.shown, "an object's own place is not the focus's to change"


def test_the_active_object_is_one_more_place(scene):
    assert not bpy.ops.fovea.focus_place_add.poll()
    bpy.ops.fovea.pick_focus(location=(1, 2, 3))
    box = bpy.context.view_layer.objects.active = scene.objects["Box"]
    assert bpy.ops.fovea.focus_place_add() == {"FINISHED"}
    assert scene.fovea.focus_points[0].focus_object == box
    assert scene.fovea.focus_points[0].focus_far_distance == scene.fovea.focus_far_distance


def test_a_deleted_mark_comes_back(scene):
    bpy.ops.fovea.pick_focus(location=(1, 2, 3))
    scene.collection.objects.unlink(scene.fovea.focus_object)
    bpy.ops.fovea.pick_focus(location=(4, 5, 6))
    assert scene.fovea.focus_object.name in scene.objects


def context_of(seen):
    """A viewport's context, as far as picking asks for it."""
    return SimpleNamespace(
        region=seen.region,
        region_data=seen.view,
        scene=bpy.context.scene,
        evaluated_depsgraph_get=bpy.context.evaluated_depsgraph_get,
    )


def test_a_click_hits_what_the_pixel_shows(scene):
    seen = look(location=(-1, -2, -10))  # above the box, whose upper face is at 1
    assert operators.pick(context_of(seen), (200, 100), add=False) is None
    bpy.context.view_layer.update()
    assert (places.location(scene.fovea) - Vector((1, 2, 1))).length < 1e-4
    # The radii fit what is seen: 9 units to the face, of which the frame's height covers one in one.
    assert scene.fovea.focus_near_distance == pytest.approx(0.9, rel=1e-3)
    assert scene.fovea.focus_far_distance == pytest.approx(3.6, rel=1e-3)


def test_a_click_beside_everything_changes_nothing(scene):
    missed = operators.pick(context_of(look(location=(-1, -2, -10))), (390, 190), add=False)
    assert missed == operators.MISSED
    assert scene.fovea.focus_model == "NONE" and scene.fovea.focus_object is None


def test_a_click_goes_through_what_is_not_drawn(scene):
    scene.objects["Box"].fovea.usage = "IGNORE"
    new_object(box_mesh(), "Below", (1, 2, -5))
    bpy.context.view_layer.update()
    at_pixel, obj = operators.cast(context_of(look(location=(-1, -2, -10))), (200, 100))
    assert obj.name == "Below" and at_pixel.z == pytest.approx(-4, abs=1e-3)


def test_in_the_model_object_the_object_is_picked(scene):
    scene.fovea.focus_model = "OBJECT"
    assert operators.pick(context_of(look(location=(-1, -2, -10))), (200, 100), add=False) is None
    assert scene.fovea.focus_model == "OBJECT" and scene.fovea.focus_object == scene.objects["Box"]


def test_chosen_radii_stay(scene):
    scene.fovea.focus_near_distance = 0.25
    operators.pick(context_of(look(location=(-1, -2, -10))), (200, 100), add=False)
    assert scene.fovea.focus_near_distance == 0.25 and scene.fovea.focus_far_distance == 5.0


@pytest.mark.parametrize("model", ["SCENE", "IMAGE"])
def test_a_dragged_ring_goes_through_the_pointer(scene, model):
    seen, settings = look(frame=(40, 20, 300, 150)), scene.fovea
    settings.focus_model, settings.focus_location = model, (1, 0.5, 2)
    kind = KINDS[model]
    middle = seen.center(settings, kind)
    for name, name_of in zip(("near", "far"), kind.radii):
        gizmos.drag(seen, settings, kind, name, middle, at(middle.x + 30, middle.y + 40))
        assert getattr(settings, name_of) * seen.unit(settings, kind) == pytest.approx(50, abs=1e-3)


def test_radii_stay_in_order(scene):
    seen, settings = look(), scene.fovea
    settings.focus_model, kind = "SCENE", KINDS["SCENE"]
    middle = seen.center(settings, kind)
    gizmos.drag(seen, settings, kind, "far", middle, at(middle.x + 10, middle.y))
    assert settings.focus_near_distance == settings.focus_far_distance
    gizmos.drag(seen, settings, kind, "near", middle, at(middle.x + 80, middle.y))
    assert settings.focus_near_distance == settings.focus_far_distance


def test_a_dragged_middle_is_under_the_pointer(scene):
    seen, settings = look(frame=(40, 20, 300, 150)), scene.fovea
    settings.focus_location = (1, 0.5, 2)
    for kind in (KINDS["SCENE"], KINDS["IMAGE"]):
        gizmos.drag(seen, settings, kind, "middle", None, at(130, 90))
        assert (seen.center(settings, kind) - Vector((130, 90))).length < 1e-2
    assert settings.focus_location.z == pytest.approx(2, abs=1e-5), "it moves across the view"
    assert settings.focus_place[0] == pytest.approx(90 / 300) and settings.focus_place[1] == pytest.approx(1 - 70 / 150)


@pytest.mark.parametrize("model", ["IMAGE", "SCENE", "OBJECT", "PAINTED"])
def test_the_overlay_evaluates_the_focus_of_a_view(scene, model):
    settings, box = scene.fovea, scene.objects["Box"]
    settings.focus_model, settings.focus_object, settings.focus_attribute = model, box, "painted"
    settings.focus_near_distance, settings.focus_far_distance = 1.8, 1.9
    painted = box.data.attributes.new("painted", "FLOAT", "POINT")
    painted.data.foreach_set("value", np.ones(8, np.float32))
    depsgraph = bpy.context.evaluated_depsgraph_get()
    chosen = part("render.properties").style_of(depsgraph.scene)
    view = camera.of_scene(depsgraph)
    read = None if model == "IMAGE" else reading.Reader().read(depsgraph, chosen)
    found = reading.focus_of_pixels(read, view, chosen.focus, 0.25)
    assert found.shape == (50, 100)
    seen = np.array(view.view_to_clip @ view.world_to_view @ (*box.location, 1))
    x, y = (int(size * (0.5 + 0.5 * v / seen[3])) for size, v in zip((100, 50), seen))
    if model == "IMAGE":
        assert found[25, 50] == 0 and found[0, 0] > 0.5
    else:
        assert found[y, x] == 0 and found[-1, 0] == 1


def test_the_overlay_is_warm_in_focus():
    found = overlay.colors(np.array([[0.0, 1.0]], np.float32))[0]
    assert found[0, 0] > 2 * found[0, 2] and found[1, 2] > 2 * found[1, 0]
    assert (found[:, 3] == np.float32(overlay.OPACITY)).all()


def test_the_overlay_is_as_fine_as_is_done_in_the_time_for_a_draw():
    assert overlay.affordable(overlay.SCALE, 20, 33) == overlay.affordable(overlay.LEAST, 0, 33) == overlay.SCALE
    assert overlay.affordable(overlay.SCALE, 132, 33) == overlay.SCALE / 2
    assert overlay.affordable(overlay.SCALE / 2, 33, 33) == overlay.SCALE / 2
    assert overlay.affordable(overlay.SCALE, 5000, 33) == overlay.LEAST


def leftovers():
    """What the tools put into Blender, apart from their operators."""
    kept = {name: getattr(bpy.app.handlers, name) for name in dir(bpy.app.handlers)}
    handlers = {name: len(functions) for name, functions in kept.items() if isinstance(functions, list)}
    menus = [bpy.types.TOPBAR_MT_render, bpy.types.VIEW3D_PT_overlay]
    drawn = [len(menu._dyn_ui_initialize()) for menu in menus]
    return handlers, drawn, hasattr(bpy.types.WindowManager, "fovea_show_focus"), overlay.handle is None


def test_registered_and_unregistered_again_and_again_they_leave_nothing(scene):
    tools = [part(name) for name in fovea.TOOLS]
    before = leftovers()
    for _ in range(20):
        for module in reversed(tools):
            registration.unregister(module)
        without = leftovers()
        for module in tools:
            registration.register(module)
    assert leftovers() == before
    assert without != before and without[2:] == (False, True)
    assert bpy.ops.fovea.pick_focus(location=(1, 2, 3)) == {"FINISHED"}
