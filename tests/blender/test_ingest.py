# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading Blender's evaluated scene: every type of object, instances, visibility and usage."""

import itertools
import math

import bpy
import numpy as np
import pytest
from snapshots import ARRAYS, NATIVE, capture_engine, fresh_scene, in_render, in_viewport, new_cache, scene, usage_of
from the_addon import add_camera, box_mesh, new_mesh, new_object, shader_material

pytestmark = pytest.mark.usefixtures(capture_engine.__name__, fresh_scene.__name__)


def bevelled_curve():
    bpy.ops.curve.primitive_bezier_circle_add()
    bpy.context.object.data.bevel_depth = 0.1


def extruded_text():
    bpy.ops.object.text_add()
    bpy.context.object.data.extrude = 0.1


OBJECTS = {
    "mesh": bpy.ops.mesh.primitive_monkey_add,
    "curve": bevelled_curve,
    "text": extruded_text,
    "surface": bpy.ops.surface.primitive_nurbs_surface_sphere_add,
    "metaball": bpy.ops.object.metaball_add,
}


@pytest.mark.parametrize("kind", OBJECTS)
def test_every_type_of_object_comes_once(kind):
    OBJECTS[kind]()
    obj = bpy.context.object
    obj.location = (1, 2, 3)
    for snapshot in (in_viewport(new_cache(NATIVE)), in_render()["ViewLayer"]):
        assert snapshot.objects == [obj.name]
        assert snapshot.usage.tolist() == [scene.DRAW | scene.OCCLUDE]
        assert np.allclose(snapshot.object_to_world[0], np.array(obj.matrix_world))
    assert len(in_viewport(new_cache(NATIVE)).surfaces[0].triangles) > 10


def test_modifiers_are_applied():
    obj = new_object(box_mesh())
    obj.modifiers.new("Subdivision", "SUBSURF").render_levels = 2
    obj.modifiers["Subdivision"].levels = 1
    assert in_viewport().surfaces[0].polygon_count == 24
    assert in_render()["ViewLayer"].surfaces[0].polygon_count == 96


def test_arrays_are_blenders():
    mesh = new_mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0)], [], [(0, 1, 2, 3), (1, 4, 2)])
    new_object(mesh)
    (surface,) = in_viewport().surfaces
    assert surface.positions.tolist() == [list(v.co) for v in mesh.vertices]
    assert surface.edge_verts.tolist() == [list(e.vertices) for e in mesh.edges]
    assert surface.corner_verts.tolist() == [0, 1, 2, 3, 1, 4, 2]
    assert surface.corner_edges.tolist() == [loop.edge_index for loop in mesh.loops]
    assert surface.polygon_offsets.tolist() == [0, 4, 7]
    for name in ARRAYS[5:]:
        assert getattr(surface, name) is None, name


@pytest.mark.parametrize(
    "sizes", [(4, 4, 4), (3, 3, 3), (4, 3, 5), (3, 5), (3, 5, 4), (5, 3), (5, 5), (4, 4, 3)], ids=str
)
def test_where_polygons_begin_is_what_blender_says(sizes):
    """Also of a fan, whose polygons all begin at the same vertex, where as many corners could be cut otherwise."""
    rim = itertools.count(1)
    fan = [(0, *itertools.islice(rim, size - 1)) for size in sizes]
    mesh = new_mesh([(math.cos(i), math.sin(i), i) for i in range(next(rim))], [], fan)
    new_object(mesh)
    (surface,) = in_viewport().surfaces
    assert surface.polygon_offsets.tolist() == [polygon.loop_start for polygon in mesh.polygons] + [sum(sizes)]


def test_polygons_with_many_corners_bring_blenders_triangles():
    ring = [(math.cos(a), math.sin(a), 0) for a in np.linspace(0, 2 * math.pi, 6, endpoint=False)]
    ring[2] = (0.1, 0.1, 0)  # a dent, so that a fan would be wrong
    new_object(new_mesh([*ring, (5, 5, 0), (6, 5, 0), (5, 6, 0)], [], [(6, 7, 8), range(6)]))
    (surface,) = in_viewport().surfaces
    assert surface.ngon_polygon.tolist() == [1, 1, 1, 1]
    x, y = surface.positions[surface.ngon_triangles][..., :2].transpose(2, 0, 1)
    areas = ((x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])) / 2
    outline = np.array(ring)
    next_x, next_y = np.roll(outline[:, 0], -1), np.roll(outline[:, 1], -1)
    assert (areas >= 0).all()
    assert np.isclose(areas.sum(), (outline[:, 0] * next_y - next_x * outline[:, 1]).sum() / 2)


def test_meshes_without_faces_or_edges():
    new_object(new_mesh([(0, 0, 0), (1, 0, 0)], [(0, 1)], [], "Wire"), "Wire")
    new_object(new_mesh([(0, 0, 0)], [], [], "Point"), "Point")
    new_object(bpy.data.meshes.new("Nothing"), "Nothing")
    assert in_viewport(new_cache(NATIVE)).objects == ["Wire"]


def test_what_is_no_surface_is_left_out():
    add_camera()
    new_object(bpy.data.lights.new("Light", "SUN"), "Light")
    new_object(None, "Empty")
    assert in_viewport().objects == []


def test_objects_share_the_surface_of_their_mesh():
    mesh = box_mesh()
    for x in range(3):
        new_object(mesh, f"Box {x}", (x, 0, 0))
    snapshot = in_viewport()
    assert len(snapshot.surfaces) == 1
    assert snapshot.surface_of_placement.tolist() == [0, 0, 0]
    assert len(set(snapshot.persistent_id.tolist())) == 3


def test_collection_instances():
    collection = bpy.data.collections.new("Furniture")
    mesh = box_mesh()
    for x in range(2):
        new_object(mesh, f"Box {x}", (x, 0, 0), collection)
    for y in range(3):
        instancer = new_object(None, f"Instancer {y}", (0, y, 0))
        instancer.instance_type, instancer.instance_collection = "COLLECTION", collection
    snapshot = in_viewport()
    assert len(snapshot.surfaces) == 1
    places = {tuple(matrix[:2, 3].tolist()) for matrix in snapshot.object_to_world}
    assert places == {(float(x), float(y)) for x in range(2) for y in range(3)}
    assert len(set(snapshot.persistent_id.tolist())) == 6


def points_instancer(count):
    """An object whose geometry nodes put a cube on every point of a grid."""
    obj = new_object(box_mesh(), "Points")
    tree = bpy.data.node_groups.new("Instances", "GeometryNodeTree")
    tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    names = ("GeometryNodeMeshGrid", "GeometryNodeMeshCube", "GeometryNodeInstanceOnPoints", "NodeGroupOutput")
    grid, cube, place, output = (tree.nodes.new(name) for name in names)
    grid.inputs["Vertices X"].default_value = grid.inputs["Vertices Y"].default_value = count
    tree.links.new(grid.outputs["Mesh"], place.inputs["Points"])
    tree.links.new(cube.outputs["Mesh"], place.inputs["Instance"])
    tree.links.new(place.outputs["Instances"], output.inputs[0])
    obj.modifiers.new("Nodes", "NODES").node_group = tree
    return obj


def test_instances_of_geometry_nodes():
    obj = points_instancer(3)
    snapshot = in_viewport()
    assert len(snapshot.surfaces) == 1 and len(snapshot.usage) == 9
    assert len(set(snapshot.persistent_id.tolist())) == 9
    obj.fovea.usage = "OCCLUDE"
    assert set(in_viewport().usage.tolist()) == {scene.OCCLUDE}


def test_ids_stay_from_frame_to_frame():
    points_instancer(3)
    new_object(box_mesh(), "Box")
    first = in_viewport().persistent_id.tolist()
    bpy.context.scene.frame_set(7)
    new_object(box_mesh(), "Another")
    assert set(first) < set(in_viewport().persistent_id.tolist())


def test_visibility_in_renders_and_viewports():
    hidden_collection = bpy.data.collections.new("Hidden")
    bpy.context.scene.collection.children.link(hidden_collection)
    hidden_collection.hide_render = True
    new_object(box_mesh(), "In hidden collection", collection=hidden_collection)
    new_object(box_mesh(), "Hidden in renders").hide_render = True
    new_object(box_mesh(), "Hidden in viewports").hide_viewport = True
    new_object(box_mesh(), "Not for cameras").visible_camera = False
    assert in_render()["ViewLayer"].objects == ["Hidden in viewports"]
    assert set(in_viewport().objects) == {"Hidden in renders", "In hidden collection"}


def test_view_layers():
    bpy.ops.scene.view_layer_add()
    names = [layer.name for layer in bpy.context.scene.view_layers]
    for name in ("Left", "Right"):
        collection = bpy.data.collections.new(name)
        bpy.context.scene.collection.children.link(collection)
        new_object(box_mesh(), name, collection=collection)
    first, second = bpy.context.scene.view_layers
    first.layer_collection.children["Right"].exclude = True
    second.layer_collection.children["Left"].holdout = True
    taken = in_render()
    both = scene.DRAW | scene.OCCLUDE
    assert usage_of(taken[names[0]]) == {"Left": both}
    assert usage_of(taken[names[1]]) == {"Left": scene.OCCLUDE | scene.HOLDOUT, "Right": both}


def test_holdout_of_object_and_material():
    new_object(box_mesh(), "Object").is_holdout = True
    mesh = box_mesh()
    mesh.materials.append(shader_material("Hole", "ShaderNodeHoldout"))
    new_object(mesh, "Material")
    assert usage_of(in_viewport()) == dict.fromkeys(("Object", "Material"), scene.OCCLUDE | scene.HOLDOUT)


def test_indirect_only_is_not_drawn():
    collection = bpy.data.collections.new("Indirect")
    bpy.context.scene.collection.children.link(collection)
    new_object(box_mesh(), collection=collection)
    bpy.context.view_layer.layer_collection.children["Indirect"].indirect_only = True
    assert in_viewport().objects == []


def test_usage():
    for usage in scene.USAGE:
        new_object(box_mesh(), usage).fovea.usage = usage
    expected = {"BOTH": scene.DRAW | scene.OCCLUDE, "OCCLUDE": scene.OCCLUDE, "DRAW": scene.DRAW}
    assert usage_of(in_viewport()) == expected
    assert usage_of(in_render()["ViewLayer"]) == expected
