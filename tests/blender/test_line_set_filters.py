# SPDX-License-Identifier: GPL-3.0-or-later
"""Line sets filtered by a collection, an object or a material, or by its inverse."""

import bpy
import numpy as np
import pytest
from pairs import instanced, pair, sides, striped  # noqa: F401 (fixtures)
from pictures import drawn, ink
from the_addon import box_mesh, lines_of, new_object, only_lines, own_style, part

style, properties = part("style"), part("render.properties")


def check_filter(scene, tmp_path, name, chosen, others):
    """Of a filter by name that chooses what is on the left, of its opposite, and of names that nothing has."""
    line_set = lines_of(scene)
    assert sides(scene, tmp_path) == (True, True)
    setattr(line_set, name, chosen)
    assert sides(scene, tmp_path) == (True, False)
    setattr(line_set, others, True)
    assert sides(scene, tmp_path) == (False, True)
    setattr(line_set, name, "There is none")
    assert sides(scene, tmp_path) == (True, True)
    setattr(line_set, others, False)
    assert sides(scene, tmp_path) == (False, False)


def test_a_collection_has_its_lines_and_what_is_outside_has_its_own(pair, tmp_path):
    scene, left = pair
    check_filter(scene, tmp_path, "collection", left.name, "outside")


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


def test_a_new_line_set_draws_at_once_and_its_filter_gives_the_others_their_lines_back(pair, tmp_path):
    scene, left = pair
    before = drawn(scene, tmp_path / "before.png")
    bpy.ops.fovea.line_set_add()
    held = own_style(scene)
    made = held.line_sets[held.line_set_index]
    assert np.array_equal(drawn(scene, tmp_path / "added.png"), before), "the same lines in the same pen"
    made.pen.color = (1, 0, 0)
    assert reds(drawn(scene, tmp_path / "red.png")) == (True, True)
    made.collection = left.name
    picture = drawn(scene, tmp_path / "left.png")
    assert reds(picture) == (True, False) and ink(picture)[:, picture.shape[1] // 2 :].max() > 0.9


def reds(picture):
    """Whether there is red ink at the left, and at the right."""
    red, half = picture[..., 0] - picture[..., 2] > 0.5, picture.shape[1] // 2
    return bool(red[:, :half].any()), bool(red[:, half:].any())


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


def test_instances_are_of_what_makes_them_and_of_what_they_are_copies_of(pair, tmp_path):
    scene, _left = pair
    instanced(scene, bpy.data.collections.new("Source"))
    for name in ("Maker", "Instanced"):
        lines_of(scene).object = name
        assert sides(scene, tmp_path) == (False, True)
        lines_of(scene).other_objects = True
        assert sides(scene, tmp_path) == (True, False)
        lines_of(scene).other_objects = False


def test_a_material_has_the_lines_on_its_faces(striped, tmp_path):
    check_filter(striped, tmp_path, "material", "Red", "other_materials")


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


@pytest.mark.parametrize("backend", ["CPU", "GPU"])
def test_filters_hold_on_both_devices(striped, tmp_path, backend):
    scene = striped
    scene.fovea.backend = backend
    lines_of(scene).material = "Red"
    assert sides(scene, tmp_path) == (True, False)


def test_viewports_hear_of_each_change(striped):
    """What a viewport asks for is another where filters or materials are others; what was read is not kept then."""
    scene, notes, changes = striped, part("scene.notes"), part("render.changes")
    asked = [notes.asked(properties.style_of(scene), None)]
    for name, value in (("object", "Roof"), ("other_objects", True), ("material", "Red"), ("other_materials", True)):
        setattr(lines_of(scene), name, value)
        asked.append(notes.asked(properties.style_of(scene), None))
    assert all(a != b for i, a in enumerate(asked) for b in asked[:i])
    told = []

    def note(_scene, depsgraph):
        told.append(list(depsgraph.updates) and not changes.are_harmless(list(depsgraph.updates)))

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
