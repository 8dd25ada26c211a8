# SPDX-License-Identifier: GPL-3.0-or-later
"""Small objects without faces, and how they are read."""

import bpy
import numpy as np
from snapshots import NATIVE, in_viewport, new_cache
from the_addon import new_mesh, new_object, part

line_kinds, report = part("scene.line_kinds"), part("render.report")

STRANDS = [[(0, 0, 0), (0, 0, 1), (0, 0.5, 2)], [(1, 0, 0), (1, 0, 1), (1, 0, 2)]]


def hair_curves(strands, radius=0.1, name="Hair"):
    """Hair curves with the same radius everywhere."""
    data = bpy.data.hair_curves.new(name)
    data.add_curves([len(strand) for strand in strands])
    points = np.array([point for strand in strands for point in strand], np.float32)
    data.position_data.foreach_set("vector", points.ravel())
    data.attributes.new("radius", "FLOAT", "POINT").data.foreach_set("value", np.full(len(points), radius, np.float32))
    return data


def node_modifier(obj, *names):
    """Geometry nodes in a row, from the object's geometry; the new nodes."""
    tree = bpy.data.node_groups.new("Nodes", "GeometryNodeTree")
    for way in ("INPUT", "OUTPUT"):
        tree.interface.new_socket("Geometry", in_out=way, socket_type="NodeSocketGeometry")
    chain = [tree.nodes.new(name) for name in ("NodeGroupInput", *names, "NodeGroupOutput")]
    for node, following in zip(chain, chain[1:]):
        tree.links.new(node.outputs[0], following.inputs[0])
    obj.modifiers.new("Nodes", "NODES").node_group = tree
    return chain[1:-1]


def point_cloud(points, radius):
    """An object whose vertices geometry nodes turn into points."""
    obj = new_object(new_mesh(points, [], [], "Points"), "Points")
    (node,) = node_modifier(obj, "GeometryNodeMeshToPoints")
    node.inputs["Radius"].default_value = radius
    return obj


def bare_curve(points, name="Curve"):
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "3D"
    spline = data.splines.new("POLY")
    spline.points.add(len(points) - 1)
    spline.points.foreach_set("co", np.array([(*point, 1) for point in points], np.float32).ravel())
    return new_object(data, name)


def emitter(count=5, **settings):
    """A square whose particles are hair."""
    obj = new_object(new_mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [], [(0, 1, 2, 3)], "Skin"), "Skin")
    system = obj.modifiers.new("Fur", "PARTICLE_SYSTEM").particle_system
    system.settings.type, system.settings.count = "HAIR", count
    for name, value in settings.items():
        setattr(system.settings, name, value)
    return obj


def read(cache=None):
    return in_viewport(cache or new_cache(NATIVE))


def shown(snapshot):
    """Per placement, the names of the definitions that it has."""
    names = [definition["name"] for definition in line_kinds.definitions()]
    return [
        {name for bit, name in enumerate(names) if bits >> bit & 1}
        for bits in snapshot.of_origins("shown", np.uint32).tolist()
    ]


def told():
    bpy.context.view_layer.update()
    assert bpy.ops.fovea.report() == {"FINISHED"}
    lines = bpy.data.texts[report.TEXT].as_string().splitlines()
    return {line.split("'")[1]: line.split(": ", 1)[1] for line in lines if line.startswith("  '")}
