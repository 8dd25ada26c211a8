# SPDX-License-Identifier: GPL-3.0-or-later
"""The scenes of `fovea bench scale`, by name and count; run inside Blender."""

import math

import bpy
import numpy as np
import scenes
from scenes import stage

HALF = 0.4  # half the width of a cube; the cubes' middles are 1 apart
CORNERS = [(x, y, z) for x in (-HALF, HALF) for y in (-HALF, HALF) for z in (-HALF, HALF)]
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def build(name, count, size):
    """Builds a scene in the open file, of so many triangles, instances, objects or pixels. `size`: of the picture, in
    pixels; those that are counted have the same ratio."""
    stage.clear()
    stage.frame()
    globals()[name](count)
    render, share = bpy.context.scene.render, math.sqrt(count / math.prod(size)) if name == "picture" else 1
    render.resolution_x, render.resolution_y = (round(share * side) for side in size)


def grid(count):
    """A wavy surface of quads, shaded smooth."""
    side = max(1, round(math.sqrt(count / 2)))
    number = np.arange(side + 1, dtype=np.float32) * (10 / side) - 5
    points = np.zeros((side + 1, side + 1, 3), np.float32)
    points[..., 0], points[..., 1] = number, number[:, None]
    points[..., 2] = 0.3 * np.sin(3 * points[..., 0]) * np.cos(2 * points[..., 1])
    first = (np.arange(side)[:, None] * (side + 1) + np.arange(side)).ravel()
    corners = (first[:, None] + (0, 1, side + 2, side + 1)).astype(np.int32).ravel()
    made = bpy.data.meshes.new("Grid")
    made.vertices.add(points.size // 3)
    made.vertices.foreach_set("co", points.ravel())
    made.loops.add(len(corners))
    made.loops.foreach_set("vertex_index", corners)
    made.polygons.add(len(first))
    made.polygons.foreach_set("loop_start", np.arange(0, len(corners), 4, dtype=np.int32))
    made.update(calc_edges=True)
    made.shade_smooth()
    stage.link("Grid", made)
    stage.camera((0, -12, 8), (0, 0, 0))


def instances(count):
    """A collection with a cube, on the points of a mesh, by geometry nodes."""
    held = bpy.data.collections.new("Held")
    held.objects.link(bpy.data.objects.new("Cube", cube()))
    points = bpy.data.meshes.new("Points")
    points.vertices.add(count)
    points.vertices.foreach_set("co", places(count).ravel())
    points.update()
    modifier = stage.link("Points", points).modifiers.new("Instances", "NODES")
    modifier.node_group = tree = bpy.data.node_groups.new("Instances", "GeometryNodeTree")
    for side in ("INPUT", "OUTPUT"):
        tree.interface.new_socket("Geometry", in_out=side, socket_type="NodeSocketGeometry")
    kinds = ("NodeGroupInput", "GeometryNodeCollectionInfo", "GeometryNodeInstanceOnPoints", "NodeGroupOutput")
    given, info, placed, result = (tree.nodes.new(kind) for kind in kinds)
    info.inputs["Collection"].default_value = held
    tree.links.new(given.outputs["Geometry"], placed.inputs["Points"])
    tree.links.new(info.outputs["Instances"], placed.inputs["Instance"])
    tree.links.new(placed.outputs["Instances"], result.inputs["Geometry"])
    look(count)


def objects(count):
    """Objects that share a mesh."""
    mesh, linked = cube(), bpy.context.scene.collection.objects
    for number, place in enumerate(places(count)):
        made = bpy.data.objects.new(f"Cube {number}", mesh)
        made.location = place
        linked.link(made)
    look(count)


def picture(_count):
    scenes.build("boxes:100")


def cube():
    made = bpy.data.meshes.new("Cube")
    made.from_pydata(CORNERS, [], QUADS)
    return made


def places(count):
    """(count, 3) on a square lattice."""
    number = np.arange(count)
    side = width(count)
    return np.stack([number % side, number // side, np.zeros(count)], axis=1).astype(np.float32)


def look(count):
    """A camera on all of the places."""
    side = width(count)
    middle = side / 2
    made = stage.camera((middle, middle - 1.2 * side, 0.8 * side), (middle, middle, 0))
    made.data.clip_end = 10 * side


def width(count):
    return math.ceil(math.sqrt(count))
