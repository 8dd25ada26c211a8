# SPDX-License-Identifier: GPL-3.0-or-later
"""hair:N, what has no faces: hair curves (N strands of 8 points) on a ball, a brush of particle hair, a point cloud, a
bare curve, text with and without a fill, metaballs, and a ring of Grease Pencil."""

import math

import bpy
import numpy as np

from . import shapes, stage

POINTS = 8  # per strand
GOLDEN = math.pi * (3 - math.sqrt(5))


def build(argument: int, shared):
    stage.clear()
    stage.frame()
    clay, dark = stage.material("Clay", (0.75, 0.55, 0.42)), stage.material("Dark", (0.16, 0.09, 0.05))
    head = stage.link("Head", shapes.ball("Head", 0.97, 64))
    head.location = (0, 0, 1)
    head.data.materials.append(clay)
    hair = stage.link("Hair", strands(argument))
    hair.location = head.location
    hair.data.materials.append(dark)
    brush((-2.2, 0.2, 0), clay, dark)
    pebbles((2.0, -0.5, 0.25), clay)
    curve = stage.link("Curve", helix())
    curve.location = (-2.6, 1.6, 0)
    for name, fill, at in (("Filled", "BOTH", (-1.9, -1.9, 0)), ("Outlined", "NONE", (0.2, -1.9, 0))):
        text(name, fill, at)
    for at in ((3.1, 0.9, 0.55), (3.6, 1.4, 0.75)):
        ball = bpy.data.metaballs.new("Drops")
        ball.render_resolution = ball.resolution = 0.07
        ball.elements.new().radius = 0.8
        drop = stage.link("Drops", ball)
        drop.location = at
    ring((0, 0, 1.1))
    floor = stage.link("Floor", shapes.sheet("Floor", [[(-4, -3, 0), (-4, 3, 0)], [(5, -3, 0), (5, 3, 0)]]))
    floor.location = (0, 0, -0.02)
    stage.camera((2.2, -10.5, 4.4), (0.45, 0, 0.7))
    stage.sun(-60, 50)


def strands(count: int):
    """Hair curves on the upper part of a unit ball, which fall outwards."""
    i = (np.arange(count) + 0.5) / count
    height, angle = 1 - 0.9 * i, GOLDEN * np.arange(count)
    root = np.stack([*(np.sqrt(1 - height**2) * f(angle) for f in (np.cos, np.sin)), height], axis=1)
    along = np.linspace(0, 1, POINTS)[None, :, None]
    points = root[:, None] * (0.95 + 0.5 * along) - np.array([0, 0, 0.75]) * along**2
    points[..., 0] += (0.06 * np.sin(5 * along[..., 0] + 7 * angle[:, None])).astype(points.dtype)
    stage.need((4, 3), "hair of curves that a script makes")
    data = bpy.data.hair_curves.new("Hair")
    data.add_curves([POINTS] * count)
    data.position_data.foreach_set("vector", points.astype(np.float32).ravel())
    radius = np.broadcast_to(0.012 * (1 - 0.9 * along[..., 0]), (count, POINTS))
    data.attributes.new("radius", "FLOAT", "POINT").data.foreach_set("value", radius.astype(np.float32).ravel())
    return data


def brush(at, wood, bristle):
    """A dome whose particles are hair."""
    angle = np.linspace(0, math.pi / 2, 9)
    dome = shapes.revolve("Brush", np.stack([0.4 * np.sin(angle), 0.4 * np.cos(angle)], axis=1), 24)
    made = stage.link("Brush", dome)
    made.location = at
    for material in (wood, bristle):
        dome.materials.append(material)
    settings = made.modifiers.new("Bristles", "PARTICLE_SYSTEM").particle_system.settings
    settings.type, settings.count, settings.hair_length, settings.material = "HAIR", 300, 0.7, 2
    settings.root_radius, settings.tip_radius, settings.radius_scale = 1.0, 0.2, 0.05


def pebbles(at, material):
    """A spiral of points, which geometry nodes make of vertices."""
    i = np.arange(60)
    points = np.stack([*(0.09 * np.sqrt(i) * f(GOLDEN * i) for f in (np.cos, np.sin)), 0.02 * i], axis=1)
    made = stage.link("Pebbles", shapes.mesh("Pebbles", points, []))
    made.location = at
    nodes = bpy.data.node_groups.new("Points", "GeometryNodeTree")
    for way in ("INPUT", "OUTPUT"):
        nodes.interface.new_socket("Geometry", in_out=way, socket_type="NodeSocketGeometry")
    of_mesh = nodes.nodes.new("GeometryNodeMeshToPoints")
    of_mesh.inputs["Radius"].default_value = 0.11
    colored = nodes.nodes.new("GeometryNodeSetMaterial")
    colored.inputs["Material"].default_value = material
    chain = [nodes.nodes.new("NodeGroupInput"), of_mesh, colored, nodes.nodes.new("NodeGroupOutput")]
    for node, following in zip(chain, chain[1:]):
        nodes.links.new(node.outputs[0], following.inputs[0])
    made.modifiers.new("Points", "NODES").node_group = nodes


def helix():
    """A curve without a bevel."""
    data = bpy.data.curves.new("Curve", "CURVE")
    data.dimensions = "3D"
    t = np.linspace(0, 1, 60)
    turns = 3 * 2 * math.pi * t
    points = np.stack([0.35 * np.cos(turns), 0.35 * np.sin(turns), 1.8 * t, np.ones_like(t)], axis=1)
    spline = data.splines.new("POLY")
    spline.points.add(len(points) - 1)
    spline.points.foreach_set("co", points.ravel())
    return data


def text(body, fill, at):
    data = bpy.data.curves.new(body, "FONT")
    data.body, data.size, data.fill_mode = body, 0.6, fill
    made = stage.link(body, data)
    made.location, made.rotation_euler = at, (math.radians(60), 0, 0)


def ring(at):
    """A circle around the head, drawn in Grease Pencil."""
    stage.need((4, 3), "a ring of Grease Pencil")
    kept = bpy.data.grease_pencils_v3 if hasattr(bpy.data, "grease_pencils_v3") else bpy.data.grease_pencils
    data = kept.new("Ring")
    red = bpy.data.materials.get("Red") or bpy.data.materials.new("Red")
    bpy.data.materials.create_gpencil_data(red)
    red.grease_pencil.color = (0.8, 0.05, 0.05, 1)
    data.materials.append(red)
    layer = data.layers.new("Ring")
    layer.use_lights = False
    drawing = layer.frames.new(1).drawing
    angle = np.linspace(0, 2 * math.pi, 97)
    drawing.add_strokes([len(angle)])
    points = np.stack([1.7 * np.cos(angle), 1.7 * np.sin(angle), 0 * angle], axis=1).astype(np.float32)
    drawing.attributes["position"].data.foreach_set("vector", points.ravel())
    radius = drawing.attributes.get("radius") or drawing.attributes.new("radius", "FLOAT", "POINT")
    radius.data.foreach_set("value", np.full(len(angle), 0.02, np.float32))
    stage.link("Ring", data).location = at
