# SPDX-License-Identifier: GPL-3.0-or-later
"""grove:N, a hill with N trees and stones: instances of four meshes, which geometry nodes put on points."""

import bpy
import numpy as np

from . import plants, shapes, stage

SIZE = 24.0


def build(argument: int, shared):
    stage.clear()
    stage.frame()
    kinds = bpy.data.collections.get("Kinds") or bpy.data.collections.new("Kinds")
    for name, made in (("Round", deciduous()), ("Pointed", conifer()), ("Young", conifer(0.5)), ("Stone", stone())):
        kinds.objects.link(bpy.data.objects.new(name, made))
    grid = np.linspace(-SIZE / 2, SIZE / 2, 49)
    x, y = np.meshgrid(grid, grid, indexing="ij")
    hill = shapes.sheet("Hill", np.stack([x, y, height(x, y)], axis=2))
    hill.materials.append(stage.material("Meadow", (0.5, 0.55, 0.3)))
    stage.link("Hill", hill)
    draw = np.random.RandomState(2)
    at = draw.uniform(-SIZE / 2, SIZE / 2, (argument, 2))
    points = np.column_stack([at, height(at[:, 0], at[:, 1])])
    grove = stage.link("Grove", shapes.mesh("Grove", points, []))
    grove.modifiers.new("Instances", "NODES").node_group = on_points(kinds)
    stage.camera((3.0, -17.5, 7.5), (0, 0, 0.8))
    stage.sun(-60, 50)


def height(x, y):
    return 1.2 * np.exp(-(x**2 + y**2) / 60) + 0.25 * np.sin(0.5 * x) * np.cos(0.4 * y)


def deciduous():
    trunk = shapes.sweep("Trunk", [(0, 0, 0), (0, 0, 0.5), (0, 0, 1.0)], 0.07, 16)
    return shapes.joined("Round", [trunk, shapes.moved(plants.crown("Crown", 0.55, 14, 0.4, 1, 18), (0, 0, 1.35))])


def conifer(size: float = 1.0):
    skirts = [(0.0, 0.05), (0.06, 0.05), (0.06, 0.3)]
    for i in range(3):
        skirts += [(0.5 - 0.12 * i, 0.3 + 0.4 * i), (0.22 - 0.06 * i, 0.72 + 0.4 * i)]
    return shapes.moved(shapes.revolve("Pointed", [*skirts, (0, 1.8)], 20), scale=(size, size, size))


def stone():
    return shapes.moved(shapes.ball("Stone", 0.25, 16), (0, 0, 0.05), scale=(1.3, 1.0, 0.7))


def on_points(collection):
    """A node group that puts one object of a collection on each vertex, turned about z and scaled."""
    tree = bpy.data.node_groups.new("On Points", "GeometryNodeTree")
    for way in ("INPUT", "OUTPUT"):
        tree.interface.new_socket("Geometry", in_out=way, socket_type="NodeSocketGeometry")
    new, link = tree.nodes.new, tree.links.new
    into, out, instances = new("NodeGroupInput"), new("NodeGroupOutput"), new("GeometryNodeInstanceOnPoints")
    kinds, turn, size = (
        new("GeometryNodeCollectionInfo"),
        new("FunctionNodeRandomValue"),
        new("FunctionNodeRandomValue"),
    )
    kinds.inputs["Collection"].default_value = collection
    kinds.inputs["Separate Children"].default_value = True
    instances.inputs["Pick Instance"].default_value = True
    turn.data_type, size.data_type = "FLOAT_VECTOR", "FLOAT"
    for socket, value in zip([s for s in turn.inputs if s.type == "VECTOR"][:2], ((0, 0, 0), (0, 0, 6.28))):
        socket.default_value = value
    for socket, value in zip([s for s in size.inputs if s.type == "VALUE"][:2], (0.7, 1.3)):
        socket.default_value = value
    link(into.outputs[0], instances.inputs["Points"])
    link(kinds.outputs[0], instances.inputs["Instance"])
    link(next(s for s in turn.outputs if s.enabled), instances.inputs["Rotation"])
    link(next(s for s in size.outputs if s.enabled), instances.inputs["Scale"])
    link(instances.outputs[0], out.inputs[0])
    return tree
