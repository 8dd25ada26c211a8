"""Line sets that draw the lines of some objects or materials alone, and what objects and materials say of their lines
themselves."""

import math

import bpy
import numpy as np
import pytest
from pictures import box_scene, drawn, ink
from the_addon import box_mesh, lines_of, new_mesh, new_object, only_lines, own_style, part

style, properties = part("style"), part("blender.properties")


@pytest.fixture
def pair():
    """A box at the left in the collection Left, and one at the right."""
    scene = box_scene()
    bpy.data.objects.remove(bpy.data.objects["Box"])
    left = bpy.data.collections.new("Left, or not.001")
    scene.collection.children.link(left)
    camera = scene.camera
    camera.location, camera.rotation_euler, camera.data.type = (0, 0, 10), (0, 0, 0), "ORTHO"
    camera.data.ortho_scale = 16
    new_object(box_mesh(), "Left", (-4, 0, 0), left)
    new_object(box_mesh(), "Right", (4, 0, 0))
    only_lines(scene, "crease")
    return scene, left


def sides(scene, tmp_path):
    """Whether there is ink at the left, and at the right; not in the middle, where strokes may end."""
    picture = ink(drawn(scene, tmp_path / "pair.png"))
    width = picture.shape[1]
    return tuple(bool(side.max() > 0.5) for side in (picture[:, : width * 2 // 5], picture[:, width * 3 // 5 :]))


def test_a_collection_has_its_lines_and_what_is_outside_has_its_own(pair, tmp_path):
    scene, left = pair
    assert sides(scene, tmp_path) == (True, True)
    lines_of(scene).collection = left.name
    assert sides(scene, tmp_path) == (True, False)
    lines_of(scene).outside = True
    assert sides(scene, tmp_path) == (False, True)
    lines_of(scene).collection = "There is none"
    assert sides(scene, tmp_path) == (True, True)
    lines_of(scene).outside = False
    assert sides(scene, tmp_path) == (False, False)


def test_instances_are_where_what_makes_them_is(pair, tmp_path):
    scene, left = pair
    source = bpy.data.collections.new("Source")
    new_object(box_mesh(0.5), "Instanced", (0, 0, 0), source)
    maker = new_object(None, "Maker", (4, 3, 0), left)
    maker.instance_type, maker.instance_collection = "COLLECTION", source
    lines_of(scene).collection = left.name
    assert sides(scene, tmp_path) == (True, True)
    lines_of(scene).collection = source.name
    assert sides(scene, tmp_path) == (False, True)


def test_two_line_sets_share_a_scene(pair, tmp_path):
    scene, left = pair
    bpy.ops.fovea.line_set_duplicate()
    held = own_style(scene)
    first, second = held.line_sets[-2:]
    first.collection, first.pen.color = left.name, (1, 0, 0)
    picture = drawn(scene, tmp_path / "two.png")
    half = picture.shape[1] // 2
    red = picture[..., 0] - picture[..., 2] > 0.5
    black = ink(picture) > 0.9
    assert red[:, :half].any() and not red[:, half:].any()
    assert black[:, half:].any() and not black[:, :half].any()
    assert np.array_equal(picture, drawn(scene, tmp_path / "again.png"))


def test_the_filter_is_in_the_file(pair):
    scene, left = pair
    lines_of(scene).collection, lines_of(scene).outside = left.name, True
    chosen = properties.style_of(scene)
    read = style.parse(style.dump(chosen))
    assert read.line_sets == chosen.line_sets and read.line_sets[-1].collection == left.name
    with pytest.raises(style.StyleError, match=r"line_sets\[0\].collection must be text"):
        style.parse('{"schema": 1, "line_sets": [{"collection": 3}]}')
    with pytest.raises(style.StyleError, match=r"line_sets\[0\].outside must be true or false"):
        style.parse('{"schema": 1, "line_sets": [{"outside": "no"}]}')


def test_an_object_has_its_lines_and_the_others_have_theirs(pair, tmp_path):
    scene, left = pair
    lines_of(scene).object = "Left"
    assert sides(scene, tmp_path) == (True, False)
    lines_of(scene).other_objects = True
    assert sides(scene, tmp_path) == (False, True)
    lines_of(scene).object = "There is none"
    assert sides(scene, tmp_path) == (True, True)
    lines_of(scene).other_objects = False
    assert sides(scene, tmp_path) == (False, False)
    lines_of(scene).object, lines_of(scene).collection = "Right", left.name
    assert sides(scene, tmp_path) == (False, False), "what both filters let through: nothing"
    lines_of(scene).outside = True
    assert sides(scene, tmp_path) == (False, True)


def instanced(scene, source):
    """An object of a collection that is not in the scene, instanced at the right by `Maker`."""
    new_object(box_mesh(0.5), "Instanced", (0, 0, 0), source)
    maker = new_object(None, "Maker", (4, 3, 0))
    maker.instance_type, maker.instance_collection = "COLLECTION", source
    bpy.data.objects.remove(bpy.data.objects["Right"])


def test_instances_are_of_what_makes_them_and_of_what_they_are_copies_of(pair, tmp_path):
    scene, _left = pair
    instanced(scene, bpy.data.collections.new("Source"))
    for name in ("Maker", "Instanced"):
        lines_of(scene).object = name
        assert sides(scene, tmp_path) == (False, True)
        lines_of(scene).other_objects = True
        assert sides(scene, tmp_path) == (True, False)
        lines_of(scene).other_objects = False


@pytest.fixture
def striped(pair):
    """The pair, with a ridge across it of material Red at the left and of Blue at the right; the boxes are gone."""
    scene, _left = pair
    for name in ("Left", "Right"):
        bpy.data.objects.remove(bpy.data.objects[name])
    corners = [(x, y, 1.0 if y == 0 else 0.0) for y in (-3, 0, 3) for x in (-6, 0, 6)]
    quads = [(0, 1, 4, 3), (1, 2, 5, 4), (3, 4, 7, 6), (4, 5, 8, 7)]
    mesh = new_mesh(corners, [], quads, "Roof")
    for name in ("Red", "Blue"):
        mesh.materials.append(bpy.data.materials.new(name))
    mesh.polygons.foreach_set("material_index", [0, 1, 0, 1])
    new_object(mesh, "Roof")
    lines_of(scene).kinds.crease_angle = math.radians(10)
    return scene


def test_a_material_has_the_lines_on_its_faces(striped, tmp_path):
    scene = striped
    assert sides(scene, tmp_path) == (True, True)
    lines_of(scene).material = "Red"
    assert sides(scene, tmp_path) == (True, False)
    lines_of(scene).other_materials = True
    assert sides(scene, tmp_path) == (False, True)
    lines_of(scene).material = "There is none"
    assert sides(scene, tmp_path) == (True, True)
    lines_of(scene).other_materials = False
    assert sides(scene, tmp_path) == (False, False)


def test_materials_of_the_object_count_where_it_brings_its_own(striped, tmp_path):
    scene, roof = striped, bpy.data.objects["Roof"]
    roof.material_slots[1].link = "OBJECT"
    roof.material_slots[1].material = bpy.data.materials.new("Green")
    lines_of(scene).material = "Blue"
    assert sides(scene, tmp_path) == (False, False)
    lines_of(scene).material = "Green"
    assert sides(scene, tmp_path) == (False, True)


def test_where_materials_meet_the_first_set_of_either_has_the_line(striped, tmp_path):
    scene = striped
    only_lines(scene, "material_boundary")
    bpy.ops.fovea.line_set_duplicate()
    held = own_style(scene)
    held.line_sets[-2].pen.color, held.line_sets[-1].pen.color = (1, 0, 0), (0, 0, 1)
    for first, second in (("Red", "Blue"), ("Blue", "Red")):
        held.line_sets[-2].material, held.line_sets[-1].material = first, second
        picture = drawn(scene, tmp_path / "meet.png")
        assert (picture[..., 0] - picture[..., 2] > 0.5).any(), "the first set's red"
        assert not (picture[..., 2] - picture[..., 0] > 0.5).any()


def test_a_material_without_lines_keeps_those_it_shares(striped, tmp_path):
    scene = striped
    bpy.data.materials["Blue"].fovea.lines = False
    assert sides(scene, tmp_path) == (True, False)
    lines_of(scene).material = "Blue"
    assert sides(scene, tmp_path) == (False, False)
    lines_of(scene).material = ""
    only_lines(scene, "material_boundary")
    assert ink(drawn(scene, tmp_path / "shared.png")).max() > 0.5
    bpy.data.materials["Red"].fovea.lines = False
    assert ink(drawn(scene, tmp_path / "none.png")).max() < 0.1


@pytest.mark.parametrize("backend", ["CPU", "GPU"])
def test_filters_hold_on_both_devices(striped, tmp_path, backend):
    scene = striped
    scene.fovea.backend = backend
    lines_of(scene).material = "Red"
    assert sides(scene, tmp_path) == (True, False)


def test_an_object_has_its_own_kinds(pair, tmp_path):
    scene, _left = pair
    bpy.data.objects["Left"].rotation_euler = (0.3, 0.4, 0.0)  # what is seen edge on has no clear contour
    mine = bpy.data.objects["Left"].fovea
    whole = drawn(scene, tmp_path / "whole.png")
    mine.kinds.crease = False
    assert np.array_equal(drawn(scene, tmp_path / "off.png"), whole), "the switch is off"
    mine.own_kinds = True
    assert sides(scene, tmp_path) == (False, True)
    mine.kinds.crease, mine.kinds.contour = True, False
    assert np.array_equal(drawn(scene, tmp_path / "crease.png"), whole), "contours are not drawn anyway"
    part("blender.style_data").choose_lines(own_style(scene), ("crease", "contour"))
    mine.kinds.crease, mine.kinds.contour = False, True
    assert sides(scene, tmp_path) == (True, True), "its contours are creases, too: they stay"


def test_an_object_has_its_own_crease_angle(pair, tmp_path):
    scene, _left = pair
    mine = bpy.data.objects["Left"].fovea
    mine.crease_angle = math.radians(100)
    assert sides(scene, tmp_path) == (True, True)
    mine.own_crease_angle = True
    assert sides(scene, tmp_path) == (False, True)
    lines_of(scene).kinds.crease_angle = math.radians(100)
    mine.crease_angle = math.radians(80)
    assert sides(scene, tmp_path) == (True, False)


def test_instances_have_the_lines_of_what_they_are_copies_of(pair, tmp_path):
    scene, _left = pair
    instanced(scene, bpy.data.collections.new("Source"))
    bpy.data.objects["Maker"].fovea.own_kinds = True
    bpy.data.objects["Maker"].fovea.kinds.crease = False
    assert sides(scene, tmp_path) == (True, True)
    mine = bpy.data.objects["Instanced"].fovea
    mine.own_kinds, mine.kinds.crease = True, False
    assert sides(scene, tmp_path) == (True, False)
    mine.own_kinds, mine.own_crease_angle, mine.crease_angle = False, True, math.radians(100)
    assert sides(scene, tmp_path) == (True, False)


def test_viewports_hear_of_each_change(striped):
    """What a viewport asks for is another where filters or materials are others; what was read is not kept then."""
    scene, notes, changes = striped, part("blender.notes"), part("blender.changes")
    asked = [notes.asked(properties.style_of(scene), None)]
    for name, value in (("object", "Roof"), ("other_objects", True), ("material", "Red"), ("other_materials", True)):
        setattr(lines_of(scene), name, value)
        asked.append(notes.asked(properties.style_of(scene), None))
    assert all(a != b for i, a in enumerate(asked) for b in asked[:i])
    told = []

    def note(_scene, depsgraph):
        told.append(list(depsgraph.updates) and not changes._are_harmless(list(depsgraph.updates)))

    bpy.context.view_layer.update()
    bpy.app.handlers.depsgraph_update_post.append(note)
    settings = bpy.data.objects["Roof"].fovea
    try:
        for group, name, value in (
            (settings, "own_kinds", True),
            (settings.kinds, "crease", False),
            (settings, "own_crease_angle", True),
            (settings, "crease_angle", 1.0),
            (bpy.data.materials["Red"].fovea, "lines", False),
        ):
            told.clear()
            setattr(group, name, value)
            bpy.context.view_layer.update()
            assert any(told), name
    finally:
        bpy.app.handlers.depsgraph_update_post.remove(note)


def test_all_filters_are_in_the_file(pair):
    scene, left = pair
    lines = lines_of(scene)
    lines.object, lines.other_objects, lines.material, lines.other_materials = "Left", True, "Glass", True
    chosen = properties.style_of(scene)
    assert style.parse(style.dump(chosen)).line_sets == chosen.line_sets
    assert chosen.line_sets[-1].material == "Glass" and chosen.line_sets[-1].other_objects
