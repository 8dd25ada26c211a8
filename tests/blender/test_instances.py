# SPDX-License-Identifier: GPL-3.0-or-later
"""Instances are read by what they have in common: once for each object and instancer, their places as arrays."""

import math
from pathlib import Path

import bpy
import numpy as np
import pytest
from snapshots import fresh_scene, in_viewport, new_cache
from test_ingest import points_instancer
from the_addon import add_camera, box_mesh, new_object, part

pytestmark = pytest.mark.usefixtures(fresh_scene.__name__)
instances, scene = part("scene.instances"), part("scene.scene")


def test_instances_have_one_origin_for_each_object_and_instancer():
    """And objects one of their own."""
    collection = bpy.data.collections.new("Furniture")
    new_object(box_mesh(), "Box", (1, 0, 0), collection)
    for name in "AB":
        instancer = new_object(None, name)
        instancer.instance_type, instancer.instance_collection = "COLLECTION", collection
    points_instancer(3)
    new_object(box_mesh(), "Single", (0, 0, 7))
    snapshot = in_viewport()
    owners = sorted(origin.owners for origin in snapshot.origins)
    assert owners == [("Box", "A"), ("Box", "B"), ("Points", "Points"), ("Single",)]
    assert sorted(np.bincount(snapshot.origin_of_placement).tolist()) == [1, 1, 1, 9]
    single = snapshot.objects.index("Single")
    assert snapshot.object_to_world[single][2, 3] == 7


def test_geometries_that_one_object_instances_have_surfaces_of_their_own():
    obj = points_instancer(2)
    tree = obj.modifiers[0].node_group
    placed, output = (next(n for n in tree.nodes if n.type == kind) for kind in ("INSTANCE_ON_POINTS", "GROUP_OUTPUT"))
    join, cone = tree.nodes.new("GeometryNodeJoinGeometry"), tree.nodes.new("GeometryNodeMeshCone")
    again = tree.nodes.new("GeometryNodeInstanceOnPoints")
    tree.links.new(placed.inputs["Points"].links[0].from_socket, again.inputs["Points"])
    tree.links.new(cone.outputs["Mesh"], again.inputs["Instance"])
    for node in (placed, again):
        tree.links.new(node.outputs["Instances"], join.inputs[0])
    tree.links.new(join.outputs[0], output.inputs[0])
    snapshot = in_viewport()
    assert len(snapshot.surfaces) == len(snapshot.origins) == 2
    assert np.bincount(snapshot.surface_of_placement).tolist() == [4, 4]
    assert len(set(snapshot.persistent_id.tolist())) == 8


def test_hidden_instancers_are_told_from_those_shown():
    """Though they instance the same object."""
    collection = bpy.data.collections.new("Furniture")
    new_object(box_mesh(), "Box", (0, 0, 0), collection)
    for name, usage in (("A", "DRAW"), ("B", "IGNORE"), ("C", "OCCLUDE")):
        instancer = new_object(None, name)
        instancer.instance_type, instancer.instance_collection = "COLLECTION", collection
        instancer.fovea.usage = usage
    snapshot = in_viewport()
    told = {origin.owners[1]: origin.usage for origin in snapshot.origins}
    assert told == {"A": scene.DRAW, "C": scene.OCCLUDE}
    assert sorted(snapshot.usage.tolist()) == [scene.DRAW, scene.OCCLUDE]


def test_arrays_are_what_each_instance_says():
    """And of each kind of them, one is looked at."""
    points_instancer(3)
    new_object(box_mesh(), "Single", (1, 2, 3))
    found, met = bpy.context.evaluated_depsgraph_get().object_instances, []
    matrices, persistent, kinds = instances.read(found, lambda one: met.append(one.object.name))
    for instance, matrix, numbers, kind in zip(found, matrices, persistent, kinds, strict=True):
        assert np.array_equal(matrix, instance.matrix_world) and numbers.tolist() == [*instance.persistent_id]
        assert met[kind] == instance.object.name
    assert met.count("Single") == 1 and sorted(np.bincount(kinds).tolist()) == [1] * (len(met) - 1) + [9]


def test_placements_in_a_viewport_differ_where_anything_that_is_shown_does():
    obj = points_instancer(2)
    single = new_object(box_mesh(), "Single")
    camera = add_camera()
    before = placements()
    assert placements() == before
    camera.location.x += 1
    assert placements() == before  # cameras are no part of what is shown
    changes = {
        "moved": lambda: setattr(single, "location", (0, 0, 1)),
        "hidden": lambda: single.hide_set(True),
        "material": lambda: obj.data.materials.append(bpy.data.materials.new("Paint")),
        "more": lambda: new_object(box_mesh(), "Other"),
        "swapped": lambda: swap(single, bpy.data.objects["Other"]),
    }
    for name, change in changes.items():
        change()
        after = placements()
        assert after != before, name
        before = after


def placements():
    bpy.context.view_layer.update()
    view = next(area for screen in bpy.data.screens for area in screen.areas if area.type == "VIEW_3D")
    return instances.placements(bpy.context.evaluated_depsgraph_get(), view.spaces.active)


def swap(one, other):
    one.location, other.location = other.location.copy(), one.location.copy()


class CancelAt:
    """A Cancel that is requested the n-th time that it is looked at."""

    def __init__(self, number):
        self.left = number

    @property
    def requested(self):
        self.left -= 1
        assert self.left >= 0, "it was looked at again after it was requested"
        return self.left == 0


def read_until_cancelled(number):
    """Reads all instances, which ends at the n-th look at a Cancel."""
    found = bpy.context.evaluated_depsgraph_get().object_instances
    with pytest.raises(part("native").load().Cancelled):
        instances.read(found, lambda instance: None, CancelAt(number))


@pytest.mark.parametrize("number", [1, 2, 4])
def test_reading_ends_where_it_is_cancelled(number):
    points_instancer(math.isqrt(3 * instances.POLLED) + 1)
    read_until_cancelled(number)


def test_a_render_reads_instances_with_its_cancel(monkeypatch):
    points_instancer(2)
    add_camera()
    asked = []

    def read(found, meet, cancel=None):
        asked.append(cancel)
        raise part("native").load().Cancelled("cancelled")

    monkeypatch.setattr(instances, "read", read)
    bpy.context.scene.render.engine = "FOVEA"
    bpy.ops.render.render()
    assert [type(cancel) for cancel in asked] == [part("native").load().Cancel]


@pytest.mark.parametrize("read", [lambda cache: in_viewport(cache), lambda cache: read_until_cancelled(3)])
def test_reading_instances_again_takes_no_more_memory(read):
    points_instancer(150)
    cache, sizes = new_cache(), [resident()]
    for _ in range(4):
        for _ in range(10):
            read(cache)
        sizes.append(resident())
    # Each instance that a traversal leaves behind takes 250 bytes: 56 MB. Other memory grows now and then.
    assert np.diff(sizes).min() < 25 << 20


def resident():
    """Bytes of memory that this process has."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096
