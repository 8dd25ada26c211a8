"""The focus tools from scripts: picking, pulling, what gizmos drag, the overlay's colours, undo."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from mathutils import Matrix, Vector
from the_addon import add_camera, box_mesh, empty_scene, fovea, new_object, part

places, gizmos, overlay = part("blender.focus_places"), part("blender.focus_gizmos"), part("blender.focus_overlay")
operators, pulls = part("blender.focus_operators"), part("blender.focus_pull")
camera, reading, focus = part("blender.camera"), part("blender.reading"), part("focus")


@pytest.fixture
def scene():
    scene = empty_scene()
    scene.render.engine, scene.render.resolution_x, scene.render.resolution_y = "FOVEA", 400, 200
    new_object(box_mesh(), "Box", (1, 2, 0))
    add_camera((3, -16, 6), (0, 0, 0))
    bpy.context.view_layer.update()
    return scene


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
    for step in range(focus.MOST_POINTS):
        bpy.ops.fovea.pick_focus(location=(step, 0, 0), add=True)
    assert len(places.places(scene.fovea)) == focus.MOST_POINTS
    assert bpy.ops.fovea.pick_focus(location=(9, 9, 9), add=True) == {"CANCELLED"}
    assert len(places.places(scene.fovea)) == focus.MOST_POINTS


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
    middle = seen.centre(settings, model)
    for name, name_of in (("near", places.RADII[model][0]), ("far", places.RADII[model][1])):
        gizmos.drag(seen, settings, model, name, middle, at(middle.x + 30, middle.y + 40))
        assert getattr(settings, name_of) * seen.unit(settings, model) == pytest.approx(50, abs=1e-3)


def test_radii_stay_in_order(scene):
    seen, settings = look(), scene.fovea
    settings.focus_model = "SCENE"
    middle = seen.centre(settings, "SCENE")
    gizmos.drag(seen, settings, "SCENE", "far", middle, at(middle.x + 10, middle.y))
    assert settings.focus_near_distance == settings.focus_far_distance
    gizmos.drag(seen, settings, "SCENE", "near", middle, at(middle.x + 80, middle.y))
    assert settings.focus_near_distance == settings.focus_far_distance


def test_a_dragged_middle_is_under_the_pointer(scene):
    seen, settings = look(frame=(40, 20, 300, 150)), scene.fovea
    settings.focus_location = (1, 0.5, 2)
    for model in ("SCENE", "IMAGE"):
        gizmos.drag(seen, settings, model, "middle", None, at(130, 90))
        assert (seen.centre(settings, model) - Vector((130, 90))).length < 1e-2
    assert settings.focus_location.z == pytest.approx(2, abs=1e-5), "it moves across the view"
    assert settings.focus_place[0] == pytest.approx(90 / 300) and settings.focus_place[1] == pytest.approx(1 - 70 / 150)


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


@pytest.mark.parametrize("model", ["IMAGE", "SCENE", "OBJECT", "PAINTED"])
def test_the_overlay_evaluates_the_focus_of_a_view(scene, model):
    settings, box = scene.fovea, scene.objects["Box"]
    settings.focus_model, settings.focus_object, settings.focus_attribute = model, box, "painted"
    settings.focus_near_distance, settings.focus_far_distance = 1.8, 1.9
    painted = box.data.attributes.new("painted", "FLOAT", "POINT")
    painted.data.foreach_set("value", np.ones(8, np.float32))
    depsgraph = bpy.context.evaluated_depsgraph_get()
    chosen = part("blender.properties").style_of(depsgraph.scene)
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


def leftovers():
    """What the tools put into Blender, apart from their operators."""
    kept = {name: getattr(bpy.app.handlers, name) for name in dir(bpy.app.handlers)}
    handlers = {name: len(functions) for name, functions in kept.items() if isinstance(functions, list)}
    menus = [bpy.types.TOPBAR_MT_render, bpy.types.VIEW3D_PT_overlay]
    drawn = [len(menu._dyn_ui_initialize()) for menu in menus]
    return handlers, drawn, hasattr(bpy.types.WindowManager, "fovea_show_focus"), overlay._handle is None


def test_registered_and_unregistered_again_and_again_they_leave_nothing(scene):
    tools = [part(f"blender.{name}") for name in fovea.TOOLS]
    before = leftovers()
    for _ in range(20):
        for module in reversed(tools):
            module.unregister()
        without = leftovers()
        for module in tools:
            module.register()
    assert leftovers() == before
    assert without != before and without[2:] == (False, True)
    assert bpy.ops.fovea.pick_focus(location=(1, 2, 3)) == {"FINISHED"}
