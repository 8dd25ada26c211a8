"""Line sets that draw the lines of some objects alone: those of a collection, or those outside it."""

import bpy
import numpy as np
import pytest
from pictures import box_scene, drawn, ink
from the_addon import box_mesh, lines_of, new_object, only_lines, own_style, part

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
    """Whether there is ink at the left, and at the right."""
    picture = ink(drawn(scene, tmp_path / "pair.png"))
    half = picture.shape[1] // 2
    return picture[:, :half].max() > 0.5, picture[:, half:].max() > 0.5


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
