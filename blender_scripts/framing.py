# SPDX-License-Identifier: GPL-3.0-or-later
"""Adds a camera that frames all that is drawn of a scene."""

import math

import bpy
import numpy as np
from bl_ext.user_default.fovea.scene import bare_shapes
from command import obj

AZIMUTH, ELEVATION, LENS = 35.0, 25.0, 50.0  # degrees left of the front and above it, millimetres


def frame(scene, azimuth, elevation, lens, margin, *, orthographic=False):
    """Aims a new camera at what is drawn, from `azimuth` and `elevation` (degrees), as near as `margin` (a share
    of the picture on each side) allows. `lens`: mm; of an orthographic camera it has no effect. ValueError if there is
    nothing to frame."""
    points = visible_points(bpy.context.evaluated_depsgraph_get())
    if not len(points):
        raise ValueError("the scene shows nothing to frame: no faces, edges, curves, hair or points")
    camera = bpy.data.objects.new("Fovea Camera", bpy.data.cameras.new("Fovea Camera"))
    scene.collection.objects.link(camera)
    scene.camera = camera
    camera.data.lens = lens
    camera.rotation_euler = (math.radians(90 - elevation), 0, math.radians(-azimuth))
    axes = np.array(camera.rotation_euler.to_matrix())  # columns: right, up and backwards, in the world
    local, share = points @ axes, 1 - 2 * margin
    half_width, half_height = _half_frame(camera.data, scene)
    if orthographic:
        camera.data.type = "ORTHO"
        place, times = place_and_size(local, half_width * share, half_height * share)
        camera.data.ortho_scale = times * 2 * max(half_width, half_height)
    else:
        place = nearest_place(local, half_width * share, half_height * share)
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


def place_and_size(points, half_width, half_height):
    """(position (3,) of a camera looking along -z without perspective, and how many times the given half sizes its
    frame must have to hold all points (n, 3))."""
    low, high = points.min(axis=0), points.max(axis=0)
    across, up, depth = high - low
    times = max(across / (2 * half_width), up / (2 * half_height))
    return np.array([*(low + high)[:2] / 2, high[2] + max(depth, times)]), times


def visible_points(depsgraph):
    """World positions (n, 3) of what is drawn of everything that is rendered, including instances: of the vertices of
    meshes and curves, and of both ends of a diagonal of the box around each point of hair and of point clouds."""
    found, guides = [np.empty((0, 3))], bare_shapes.guides(depsgraph.scene.objects)
    for instance in depsgraph.object_instances:
        owner = instance.parent or instance.object
        if owner.original.hide_render or "IGNORE" in (instance.object.original.fovea.usage, owner.original.fovea.usage):
            continue
        matrix = np.array(instance.matrix_world)
        own = _of_data(instance.object, depsgraph.scene, guides) if instance.show_self else []
        hair = bare_shapes.of_particles(instance.object, depsgraph) if instance.show_particles else []
        for points in (*own, *map(_of_shape, hair)):
            found.append(points @ matrix[:3, :3].T + matrix[:3, 3])
    points = np.concatenate(found)
    return points[np.isfinite(points).all(axis=1)]


def _of_data(source, scene, guides):
    """A list of the positions (n, 3) that are drawn of an instance's own data. `guides`: curves that are not drawn."""
    if isinstance(source.data, bpy.types.Mesh):
        return [_drawn_positions(source.data)]
    if source.type in bare_shapes.CURVES:  # its faces, if it has some, are an instance of their own
        mesh = None if source.original in guides else source.to_mesh()
        wire = [_drawn_positions(mesh)] if mesh and not len(mesh.polygons) else []
        source.to_mesh_clear()
        return wire
    shape = bare_shapes.of_data(source, scene)
    return [_of_shape(shape)] if shape else []


def _of_shape(shape):
    """(2 n, 3) of a Shape of n points, none of them if there is nothing of it."""
    read = shape.read()
    if read is None:
        return np.empty((0, 3))
    radii = read.radii[:, None]
    return np.concatenate([read.points - radii, read.points + radii])


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
