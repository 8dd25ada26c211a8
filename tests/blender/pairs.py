# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene of two objects beside each other, for tests of which lines each has."""

import math

import bpy
import pytest
from pictures import box_scene, drawn, ink
from the_addon import box_mesh, lines_of, new_mesh, new_object, only_lines


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


def instanced(scene, source):
    """An object of a collection that is not in the scene, instanced at the right by `Maker`."""
    new_object(box_mesh(0.5), "Instanced", (0, 0, 0), source)
    maker = new_object(None, "Maker", (4, 3, 0))
    maker.instance_type, maker.instance_collection = "COLLECTION", source
    bpy.data.objects.remove(bpy.data.objects["Right"])


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
