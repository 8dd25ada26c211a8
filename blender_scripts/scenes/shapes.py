# SPDX-License-Identifier: GPL-3.0-or-later
"""Modeling functions that return meshes; in meters, z up, standing on z = 0 unless stated otherwise.

Lines are drawn along creases of 30 degrees or more, so round parts have steps well below that, sharp rims are above it,
and intersecting parts are united by `combine`, which creates an edge where two surfaces meet."""

import math

import bmesh
import bpy
import numpy as np
from mathutils import Matrix

from . import stage

CREASE = math.radians(30)


def mesh(name: str, points, faces):
    """`faces`: an (F, k) array, or a list of index lists."""
    made = bpy.data.meshes.new(name)
    made.from_pydata(
        np.asarray(points, dtype=float).tolist(),
        [],
        np.asarray(faces).tolist() if isinstance(faces, np.ndarray) else faces,
    )
    return made


def finished(shape, merge: float = 1e-5):
    """Merges vertices by distance, dissolves degenerate faces, orients normals outwards, shades smooth except
    creases."""
    work = bmesh.new()
    work.from_mesh(shape)
    bmesh.ops.remove_doubles(work, verts=work.verts, dist=merge)
    bmesh.ops.dissolve_degenerate(work, edges=work.edges, dist=merge)
    bmesh.ops.recalc_face_normals(work, faces=work.faces)
    work.to_mesh(shape)
    work.free()
    shape.shade_smooth()
    shape.set_sharp_from_angle(angle=CREASE)
    return shape


def quads(rows: int, columns: int, wrap_rows: bool = False, wrap_columns: bool = False) -> np.ndarray:
    """(F, 4) faces of a grid of points in row order."""
    r, c = np.meshgrid(np.arange(rows - (not wrap_rows)), np.arange(columns - (not wrap_columns)), indexing="ij")
    r1, c1 = (r + 1) % rows, (c + 1) % columns
    return np.stack([r * columns + c, r * columns + c1, r1 * columns + c1, r1 * columns + c], axis=-1).reshape(-1, 4)


def sheet(name: str, points, wrap_columns: bool = False):
    """An open surface through an (n, m, 3) grid of points."""
    points = np.asarray(points, dtype=float)
    rows, columns = points.shape[:2]
    return finished(mesh(name, points.reshape(-1, 3), quads(rows, columns, wrap_columns=wrap_columns)))


def smooth(points, per: int = 8, closed: bool = False) -> np.ndarray:
    """A Catmull-Rom spline through the points, `per` steps per interval."""
    points = np.asarray(points, dtype=float)
    around = np.roll(points, 1, axis=0), points, np.roll(points, -1, axis=0), np.roll(points, -2, axis=0)
    if not closed:
        padded = np.concatenate([2 * points[:1] - points[1:2], points, 2 * points[-1:] - points[-2:-1]])
        around = padded[:-3], padded[1:-2], padded[2:-1], padded[3:]
    a, b, c, d = (array[:, None] for array in around)
    t = np.linspace(0, 1, per, endpoint=False)[None, :, None]
    curve = b + t * ((c - a) + t * ((2 * a - 5 * b + 4 * c - d) + t * (3 * (b - c) + d - a))) / 2
    curve = curve.reshape(-1, points.shape[1])
    return curve if closed else np.concatenate([curve, points[-1:]])


def revolve(name: str, profile, segments: int = 96, start: float = 0.0, turn: float = 2 * math.pi):
    """Surface of revolution of (radius, z) points around z. Closed if the profile is closed or starts and ends on the
    axis."""
    profile = np.asarray(profile, dtype=float)
    whole = turn >= 2 * math.pi - 1e-9
    angle = start + np.linspace(0, turn, segments + (not whole), endpoint=not whole)
    points = np.stack(
        [profile[:, :1] * np.cos(angle), profile[:, :1] * np.sin(angle), np.repeat(profile[:, 1:], len(angle), axis=1)],
        axis=-1,
    )
    return sheet(name, points, wrap_columns=whole)


def ball(name: str, radius: float, segments: int):
    angle = np.linspace(-math.pi / 2, math.pi / 2, segments // 2 + 1)
    return revolve(name, np.stack([radius * np.cos(angle).clip(0), radius * np.sin(angle)], axis=1), segments)


def sweep(name: str, path, radius, sides: int = 16, closed: bool = False):
    """A round tube along a path; `radius` is one number or one per point. Open ends are capped."""
    path = np.asarray(path, dtype=float)
    radius = np.broadcast_to(radius, len(path))
    tangent = np.roll(path, -1, axis=0) - np.roll(path, 1, axis=0) if closed else np.gradient(path, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    side = np.cross(tangent[0], np.eye(3)[np.abs(tangent[0]).argmin()])
    rings, angle = [], np.linspace(0, 2 * math.pi, sides, endpoint=False)
    for center, along, r in zip(path, tangent, radius):  # transports the frame along the path, so that it does not flip
        side = side - along * (side @ along)
        side /= np.linalg.norm(side)
        rings.append(center + r * (np.cos(angle)[:, None] * side + np.sin(angle)[:, None] * np.cross(along, side)))
    faces = quads(len(path), sides, wrap_rows=closed, wrap_columns=True).tolist()
    if not closed:
        faces += [list(range(sides)), list(range((len(path) - 1) * sides, len(path) * sides))]
    return finished(mesh(name, np.concatenate(rings), faces))


def prism(name: str, outline, low: float, high: float):
    """A polygon in x, y extruded along z from `low` to `high`."""
    outline = np.asarray(outline, dtype=float)
    n = len(outline)
    points = np.concatenate([np.insert(outline, 2, z, axis=1) for z in (low, high)])
    return finished(
        mesh(name, points, quads(2, n, wrap_columns=True).tolist() + [list(range(n)), list(range(n, 2 * n))])
    )


def upright(name: str, outline, front: float, back: float):
    """A polygon in x, z extruded along y from `front` to `back`."""
    return moved(prism(name, outline, -back, -front), turn=(math.pi / 2, 0, 0))


def arch(width: float, base: float, spring: float, steps: int = 32) -> np.ndarray:
    """Outline (x, z) of an opening with a round head."""
    angle = np.linspace(0, math.pi, steps + 1)
    head = np.stack([np.cos(angle), np.sin(angle)], axis=1) * width / 2 + (0, spring)
    return np.concatenate([[(-width / 2, base), (width / 2, base)], head])


def box(name: str, size, base=(0, 0, 0), rounding: float = 0.0, segments: int = 4):
    """`base`: center of the bottom face. Edges rounded in four segments are not creases, so only outlines are drawn."""
    x, y, z = size
    shape = prism(name, [(-x / 2, -y / 2), (x / 2, -y / 2), (x / 2, y / 2), (-x / 2, y / 2)], 0, z)
    if rounding:
        work = bmesh.new()
        work.from_mesh(shape)
        bmesh.ops.bevel(work, geom=work.edges, offset=rounding, segments=segments, affect="EDGES", profile=0.5)
        work.to_mesh(shape)
        work.free()
        shape = finished(shape)
    return moved(shape, base)


def moved(shape, offset=(0, 0, 0), turn=(0, 0, 0), scale=(1, 1, 1)):
    """Transforms a mesh in place: scale, rotation about x, then y, then z (radians), translation."""
    x, y, z = (Matrix.Rotation(angle, 4, axis) for angle, axis in zip(turn, "XYZ"))
    shape.transform(Matrix.Translation(offset) @ z @ y @ x @ Matrix.Diagonal((*scale, 1)))
    return shape


def joined(name: str, shapes):
    """One mesh from several, whose surfaces are not connected; removes these."""
    work = bmesh.new()
    for shape in shapes:
        work.from_mesh(shape)
        bpy.data.meshes.remove(shape)
    made = bpy.data.meshes.new(name)
    work.to_mesh(made)
    work.free()
    return made


def combine(operation: str, first, *others):
    """UNION, DIFFERENCE or INTERSECT of closed meshes, applied in order; removes the meshes."""
    made = stage.link("Combine", first)
    tools = [stage.link("Tool", other) for other in others]
    for tool in tools:
        modifier = made.modifiers.new("Boolean", "BOOLEAN")
        modifier.operation, modifier.object, modifier.solver = operation, tool, "EXACT"
    result = bpy.data.meshes.new_from_object(made.evaluated_get(bpy.context.evaluated_depsgraph_get()))
    result.name = first.name
    if not any(result.materials):
        result.materials.clear()  # since Blender 5 there is an empty slot
    bpy.data.batch_remove([made, *tools, first, *others])
    return finished(result)
