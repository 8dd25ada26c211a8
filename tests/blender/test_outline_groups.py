# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects with one outline: by the name of a group, by their collection, by each instance of it."""

import bpy
import numpy as np
import pytest
from pictures import box_scene, drawn, ink
from the_addon import box_mesh, new_object, only_lines, part

gather, SurfaceCache = part("scene.scene").gather, part("scene.surfaces").SurfaceCache


@pytest.fixture
def scene():
    """A small box before the large one."""
    scene = box_scene()
    scene.objects["Box"].name = "Large"
    small = new_object(box_mesh(0.4), "Small", (0.9, -1.3, 0.75))
    for line_set in scene.fovea.style.fovea.line_sets:
        line_set.pen.width = 30.0
    assert small.fovea.outline_group == ""
    return scene


def groups():
    """{object: number of its group}; instances by the name of what they are of."""
    snapshot = gather(bpy.context.evaluated_depsgraph_get(), SurfaceCache(part("native").load()))
    found = {}
    for name, group in zip(snapshot.objects, snapshot.of_origins("group", np.uint64).tolist()):
        found.setdefault(name, []).append(group)
    return found


@pytest.mark.parametrize("kind", ["silhouette", "contour"])
def test_what_lies_between_objects_of_a_group_is_not_drawn(scene, tmp_path, kind):
    only_lines(scene, kind)
    apart = ink(drawn(scene, tmp_path / "apart.png"))
    for obj in scene.objects:
        obj.fovea.outline_group = "Both" if obj.type == "MESH" else ""
    together = ink(drawn(scene, tmp_path / "together.png"))
    gone = (apart - together) > 0.5
    assert gone.sum() > 40 and ((together - apart) > 0.5).sum() == 0
    scene.objects["Small"].hide_render = True
    alone = ink(drawn(scene, tmp_path / "alone.png"))
    assert np.abs(alone - together).max() < 0.3, "the small one lies within the outline of the large one"


def test_a_collection_with_one_outline_is_a_group_and_a_name_comes_first(scene):
    assert set(groups()) == {"Large", "Small"} and sum(groups().values(), []) == [0, 0]
    collection = bpy.data.collections.new("Pair")
    scene.collection.children.link(collection)
    for name in ("Large", "Small"):
        collection.objects.link(scene.objects[name])
    collection.fovea.one_outline = True
    (large,), (small,) = groups()["Large"], groups()["Small"]
    assert large == small != 0
    scene.objects["Small"].fovea.outline_group = "Own"
    assert groups()["Small"] != [large] and groups()["Large"] == [large]


def test_each_instance_of_a_collection_has_its_own_outline(scene):
    collection = bpy.data.collections.new("Tree")
    for name in ("Trunk", "Crown"):
        new_object(box_mesh(), name, collection=collection)
    collection.fovea.one_outline = True
    for name in ("One", "Two"):
        empty = new_object(None, name)
        empty.instance_type, empty.instance_collection = "COLLECTION", collection
    found = groups()
    assert found["Trunk"] == found["Crown"] and len(set(found["Trunk"])) == 2 and 0 not in found["Trunk"]
