# SPDX-License-Identifier: GPL-3.0-or-later
"""Adds a camera that frames all visible meshes of a scene."""

import math

import bpy
import numpy as np
from command import obj

AZIMUTH, ELEVATION, LENS = 35.0, 25.0, 50.0  # degrees left of the front and above it, millimetres


def frame(scene, azimuth, elevation, lens, margin):
    """Aims a new camera at the visible meshes, from `azimuth` and `elevation` (degrees), as near as `margin` (a share
    of the picture on each side) allows. `lens`: mm. ValueError if there is nothing to frame."""
    points = visible_points(bpy.context.evaluated_depsgraph_get())
    if not len(points):
        raise ValueError("the scene shows no mesh to frame")
    camera = bpy.data.objects.new("Fovea Camera", bpy.data.cameras.new("Fovea Camera"))
    scene.collection.objects.link(camera)
    scene.camera = camera
    camera.data.lens = lens
    camera.rotation_euler = (math.radians(90 - elevation), 0, math.radians(-azimuth))
    axes = np.array(camera.rotation_euler.to_matrix())  # columns: right, up and backwards, in the world
    half_width, half_height = _half_frame(camera.data, scene)
    local = points @ axes
    place = nearest_place(local, half_width * (1 - 2 * margin), half_height * (1 - 2 * margin))
    camera.location = axes @ place
    depths = place[2] - local[:, 2]
    if not depths.max() > 0:
        raise ValueError("what the scene shows has no size to frame")
    camera.data.clip_start = max(depths.min() * 0.5, depths.max() * 1e-4)
    camera.data.clip_end = depths.max() * 2


def nearest_place(points, half_width, half_height):
    """Nearest position (3,) of a camera looking along -z, with the given half sizes of its frame at distance 1, from
    which it sees all points (n, 3), centered between those that touch opposite borders."""
    place = np.empty(3)
    distance = []
    for axis, half in ((0, half_width), (1, half_height)):
        above = (points[:, axis] + half * points[:, 2]).max()
        below = (half * points[:, 2] - points[:, axis]).max()
        place[axis] = (above - below) / 2
        distance.append((above + below) / (2 * half))
    place[2] = max(distance)
    return place


def visible_points(depsgraph):
    """World positions (n, 3) of the vertices that are drawn of every mesh that is rendered, including instances."""
    found = [np.empty((0, 3))]
    for instance in depsgraph.object_instances:
        mesh = instance.object.data
        hidden = not instance.show_self or (instance.parent or instance.object).original.hide_render
        if hidden or not isinstance(mesh, bpy.types.Mesh) or not len(mesh.vertices):
            continue
        matrix = np.array(instance.matrix_world)
        found.append(_drawn_positions(mesh) @ matrix[:3, :3].T + matrix[:3, 3])
    points = np.concatenate(found)
    return points[np.isfinite(points).all(axis=1)]


def _drawn_positions(mesh):
    """(n, 3) of the vertices of faces and loose edges without broken vertices; of all where a mesh has neither."""
    positions = _read(mesh.vertices, "co", np.float32, 3)
    if not len(mesh.edges):
        return positions
    finite = np.isfinite(positions).all(axis=1)
    ends, loose = _read(mesh.edges, "vertices", np.int32, 2), _read(mesh.edges, "is_loose", bool, 1)[:, 0]
    corners = _read(mesh.loops, "vertex_index", np.int32, 1)[:, 0]
    starts = _read(mesh.polygons, "loop_start", np.int32, 1)[:, 0]
    of_faces = obj.whole_corners(finite, corners, starts)
    return positions[np.union1d(of_faces, ends[loose & finite[ends].all(axis=1)])]


def _read(elements, name, kind, count):
    """(n, count) of an attribute of a mesh's elements."""
    found = np.empty((len(elements), count), kind)
    elements.foreach_get(name, found.ravel())
    return found


def _half_frame(camera, scene):
    """Half width and half height of the frame at distance 1 before a perspective camera."""
    corners = np.array(camera.view_frame(scene=scene))
    return np.abs(corners[0, :2] / corners[0, 2])
