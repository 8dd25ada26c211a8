# SPDX-License-Identifier: GPL-3.0-or-later
"""Small models for the documentation, each with a feature that one line definition needs: borders, materials, marks,
crossings, inflections, folds."""

import math

import bpy
import numpy as np

from . import shapes, stage

SEGMENTS = 96  # segments around the axis of surfaces of revolution
MEANDER = "uuuuuuuuuu" + "rrr" + "dddddddddd" + "rrr"  # steps of a wave along edges: up, right, down


def build(name):
    """Builds a model, replacing everything in the open file."""
    stage.clear()
    stage.frame()
    MODELS[name]()


def cloth():
    """Open surfaces: a waving cloth, a bowl, and a tube."""
    s, t = np.meshgrid(np.linspace(-1, 1, 60), np.linspace(-1, 1, 60), indexing="ij")
    waves = 0.12 * np.sin(4 * s + 1.5 * t) + 0.1 * np.cos(3 * t)
    stage.link("Cloth", shapes.sheet("Cloth", np.stack([1.5 * s, t, waves], axis=-1)))
    angle = np.linspace(0, math.pi / 2, 24)
    bowl = shapes.revolve("Bowl", np.stack([0.75 * np.sin(angle), 0.75 - 0.75 * np.cos(angle)], axis=1), SEGMENTS)
    stage.link("Bowl", shapes.moved(bowl, (-0.55, 0.05, 0.25)))
    tube = shapes.revolve("Tube", [(0.3, z) for z in np.linspace(0, 0.9, 12)], SEGMENTS)
    stage.link("Tube", shapes.moved(tube, (0.8, 0.1, 0.25)))


def balls():
    """A ball in six segments with caps, and one with a band, of two materials each."""
    light, dark = stage.material("Light", (0.9, 0.9, 0.85)), stage.material("Dark", (0.2, 0.3, 0.5))
    sixth = math.pi / 3
    for name, radius, place, is_dark in (
        ("Segments", 1.0, (0, 0, 1), lambda x, y, z: (math.atan2(y, x) % (2 * sixth) < sixth) ^ (abs(z) > 0.93)),
        ("Band", 0.55, (1.45, -0.6, 0.55), lambda x, y, z: abs(z) < 0.4),
    ):
        ball = shapes.ball(name, radius, SEGMENTS)
        ball.materials.append(light)
        ball.materials.append(dark)
        for face in ball.polygons:
            face.material_index = int(is_dark(*(face.center / radius)))
        stage.link(name, shapes.moved(ball, place, (0.5, 0.35, 0.3)))


def vase_mesh():
    """A vase with continuous curvature: its radius is a mean plus a cosine of the height."""
    heights = np.linspace(0, 1.75, 80)
    profile = np.stack([0.5 + 0.2 * np.cos(4.6 * (heights - 0.5)), heights], axis=1)
    return shapes.revolve("Vase", [(0, 0), *profile, (0, heights[-1])], SEGMENTS)


def vase():
    """A surface of revolution with convex and saddle-shaped parts."""
    stage.link("Vase", vase_mesh())


def marked_vase():
    """The vase with rings and a square wave as marked edges."""
    mesh = vase_mesh()
    points = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", points)
    points = points.reshape(-1, 3)
    column = np.round(np.arctan2(points[:, 1], points[:, 0]) / (2 * math.pi) * SEGMENTS).astype(int) % SEGMENTS
    level = np.searchsorted(np.unique(np.round(points[:, 2], 4)), np.round(points[:, 2], 4) - 1e-4)
    wanted = _rings((12, 32)) | _meander(17) | _rings((70, 73))
    ends = np.empty(2 * len(mesh.edges), np.int32)
    mesh.edges.foreach_get("vertices", ends)
    a, b = ends.reshape(-1, 2).T
    marked = [
        frozenset(((column[i], level[i]), (column[j], level[j]))) in wanted for i, j in zip(a.tolist(), b.tolist())
    ]
    _mark(mesh, marked)
    stage.link("Vase", mesh)


def _rings(levels):
    return {frozenset(((c, at), ((c + 1) % SEGMENTS, at))) for at in levels for c in range(SEGMENTS)}


def _meander(base):
    """Sides of a square wave around the vase, above a level."""
    place, found = (0, base), set()
    for step in MEANDER * (SEGMENTS // MEANDER.count("r")):
        right, up = {"r": (1, 0), "u": (0, 1), "d": (0, -1)}[step]
        after = ((place[0] + right) % SEGMENTS, place[1] + up)
        found.add(frozenset((place, after)))
        place = after
    return found


def _mark(mesh, marked):
    """Sets Freestyle edge marks: an edge property or an attribute, depending on Blender's version."""
    if "use_freestyle_mark" in bpy.types.MeshEdge.bl_rna.properties:
        mesh.edges.foreach_set("use_freestyle_mark", marked)
    else:
        mesh.attributes.new("freestyle_edge", "BOOLEAN", "EDGE").data.foreach_set("value", marked)


def crossings():
    """A ring through a ball, with a bar through both, and a sheet that passes through itself."""
    bpy.ops.mesh.primitive_torus_add(major_radius=1, minor_radius=0.3, major_segments=96, minor_segments=48)
    bpy.context.object.rotation_euler = (math.radians(20), math.radians(15), 0)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=96, ring_count=48, radius=0.72, location=(-1.0, -0.3, 0.15))
    bpy.ops.mesh.primitive_cube_add(size=1)
    bpy.context.object.scale = (0.35, 2.9, 0.35)
    bpy.context.object.rotation_euler = (math.radians(10), 0, math.radians(25))
    bpy.context.object.location = (0.5, 0, -0.05)


def ring():
    """A coarse torus with visible faces."""
    bpy.ops.mesh.primitive_torus_add(major_radius=1, minor_radius=0.42, major_segments=36, minor_segments=18)
    bpy.context.object.data.shade_smooth()


def drapery():
    """A hanging cloth whose folds deepen towards the floor."""
    s, t = np.meshgrid(np.linspace(-1.6, 1.6, 240), np.linspace(0, 2, 120), indexing="ij")
    deep = 0.05 + 0.09 * (2 - t)
    folds = deep * np.sin(7.5 * s + 0.5 * np.sin(1.3 * t)) + 0.5 * deep * np.sin(3.1 * s + 1.0 + 0.7 * t)
    cloth = shapes.sheet("Drapery", np.stack([s, folds, t], axis=-1))
    cloth.flip_normals()  # towards the front
    stage.link("Drapery", cloth)


def pebble():
    """A round body with bulges and hollows, smooth all over."""
    ball = shapes.ball("Pebble", 1.0, 160)
    points = np.empty(3 * len(ball.vertices), np.float32)
    ball.vertices.foreach_get("co", points)
    x, y, z = points.reshape(-1, 3).T
    radius = 1 + 0.16 * np.sin(2.6 * x + 0.4) * np.cos(2.2 * z + 0.5) + 0.1 * np.sin(2.9 * y + 1.7 * z)
    moved = points.reshape(-1, 3) * radius[:, None] * (1.35, 1, 0.9)
    ball.vertices.foreach_set("co", moved.astype(np.float32).ravel())
    ball.update()
    stage.link("Pebble", ball)


def shadows():
    """A ball, a leaning bar and a ring above a floor with two steps, in the sun."""
    for place, size in (
        ((0, 0, -0.15), (5.2, 3.6, 0.3)),
        ((0, 1.2, 0.15), (5.2, 1.2, 0.3)),
        ((0, 1.5, 0.45), (5.2, 0.6, 0.3)),
    ):
        stage.link("Step", shapes.moved(shapes.box("Step", size), (place[0], place[1], place[2] - size[2] / 2)))
    stage.link("Ball", shapes.moved(shapes.ball("Ball", 0.45, SEGMENTS), (-1.5, -0.4, 0.8)))
    bpy.ops.mesh.primitive_torus_add(major_radius=0.5, minor_radius=0.12, major_segments=96, minor_segments=32)
    bpy.context.object.location, bpy.context.object.rotation_euler = (0.1, -0.4, 0.9), (math.radians(70), 0, 0.5)
    bpy.ops.mesh.primitive_cube_add(size=1, location=(1.6, -0.35, 0.88))
    bpy.context.object.scale, bpy.context.object.rotation_euler = (0.16, 0.16, 1.9), (math.radians(-25), 0, 0)
    stage.sun(-115, 48)


MODELS = {
    "cloth": cloth,
    "balls": balls,
    "vase": vase,
    "marked-vase": marked_vase,
    "crossings": crossings,
    "ring": ring,
    "drapery": drapery,
    "pebble": pebble,
    "shadows": shadows,
}
