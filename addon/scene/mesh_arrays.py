# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads Blender's mesh attributes into NumPy arrays: where Blender has them, or in buffers that are reused for every
mesh."""

import ctypes
import math
from dataclasses import dataclass

import bpy
import numpy as np

LEAST_IN_PLACE = 1 << 20  # bytes of an attribute: fewer are copied sooner than they are found


@dataclass(frozen=True)
class MeshArrays:
    """V vertices, E edges, C corners, F polygons. Views into shared buffers or into the mesh: valid until the next mesh
    is read, and as long as this one."""

    positions: np.ndarray  # (V, 3) float32, object space
    edge_verts: np.ndarray  # (E, 2) int32
    corner_verts: np.ndarray  # (C,) int32
    corner_edges: np.ndarray  # (C,) int32, the edge to the polygon's next corner
    polygon_offsets: np.ndarray  # (F + 1,) int32, first corner of each polygon
    material: np.ndarray | None  # (F,) int32 index of the material slot; None: all in the first
    sharp_edges: np.ndarray | None  # (E,) bool; None: none
    seams: np.ndarray | None  # (E,) bool; None: none
    edge_marks: np.ndarray | None  # (E,) bool, Freestyle's edge marks; None: none, or not read
    smooth_edges: np.ndarray | None  # (E,) bool, shading is continuous across them; None: nowhere


class Buffers:
    """Named arrays that only grow, because allocating new memory is slower than reading the mesh."""

    MOST_BESIDE_SURFACES = 64 << 20  # bytes

    def __init__(self):
        self._arrays = {}

    @property
    def nbytes(self):
        return sum(array.nbytes for array in self._arrays.values())

    def make_room(self):
        """Gives large buffers back, for what is computed of surfaces that were just built."""
        if self.nbytes > self.MOST_BESIDE_SURFACES:
            self._arrays.clear()

    def take(self, name, shape, dtype):
        """An uninitialized array of that shape; invalidates the array taken before under the name."""
        size = math.prod(shape)
        array = self._arrays.get(name)
        if array is None or array.size < size:
            array = self._arrays[name] = np.empty(size + size // 8, dtype)
        return array[:size].reshape(shape)


def is_edited(obj):
    """Whether an evaluated object's mesh is in edit mode, possibly through another object that shares it. Then its
    arrays may be missing, and `to_mesh` creates them."""
    return obj.mode == "EDIT" or obj.data.is_editmode


def read(core, mesh, buffers, *, with_marks):
    """The arrays of an evaluated mesh. `with_marks`: also Freestyle's edge marks, slow to read before Blender 5.0."""
    vertices, edges, corners = len(mesh.vertices), len(mesh.edges), len(mesh.loops)
    polygons, flag = len(mesh.polygons), (edges,)
    sharp = _optional(mesh, "sharp_edge", buffers, flag, np.bool_)
    rings = {
        "edge_verts": _required(mesh, ".edge_verts", buffers, (edges, 2), np.int32),
        "corner_verts": _required(mesh, ".corner_vert", buffers, (corners,), np.int32),
        "corner_edges": _required(mesh, ".corner_edge", buffers, (corners,), np.int32),
    }
    offsets = _offsets(core, mesh, rings, buffers.take("offsets", (polygons + 1,), np.int32))
    return MeshArrays(
        positions=_required(mesh, "position", buffers, (vertices, 3), np.float32),
        **rings,
        polygon_offsets=offsets,
        material=_optional(mesh, "material_index", buffers, (polygons,), np.int32),
        # With custom normals, Blender marks the edges at which these split: that says how they are shaded, not drawn.
        sharp_edges=None if mesh.has_custom_normals else sharp,
        # The seams' attribute lost its dot in Blender 5.0.
        seams=_optional(mesh, ".uv_seam" if ".uv_seam" in mesh.attributes else "uv_seam", buffers, flag, np.bool_),
        edge_marks=_freestyle_marks(mesh, buffers) if with_marks else None,
        smooth_edges=_smooth_edges(mesh, rings["corner_edges"], offsets, sharp, buffers),
    )


def _smooth_edges(mesh, corner_edges, offsets, sharp, buffers):
    """(E,) bool: not sharp, and all faces at the edge are shaded smooth; None if there are none."""
    flat = _optional(mesh, "sharp_face", buffers, (len(mesh.polygons),), np.bool_)
    if flat is not None and flat.all():
        return None
    smooth = buffers.take("smooth_edges", (len(mesh.edges),), np.bool_)
    smooth[:] = True if sharp is None else ~sharp
    if flat is not None and flat.any():
        smooth[corner_edges[np.repeat(flat, np.diff(offsets))]] = False
    return smooth


def vectors(mesh, name, buffers):
    """(V, 3) float32 of a vector attribute of the vertices; None if the mesh has no such one."""
    found = mesh.attributes.get(name)
    if found is None or (found.domain, found.data_type) != ("POINT", "FLOAT_VECTOR"):
        return None
    values = buffers.take("vectors", (len(mesh.vertices), 3), np.float32)
    found.data.foreach_get("vector", values.ravel())
    return values


def creases(mesh, buffers):
    """Crease weights in [0, 1] of edges (E,) and vertices (V,), float32; each None if there are none."""
    of_edges = _optional(mesh, "crease_edge", buffers, (len(mesh.edges),), np.float32)
    return of_edges, _optional(mesh, "crease_vert", buffers, (len(mesh.vertices),), np.float32)


def ngon_triangles(mesh, polygon_offsets, buffers):
    """Blender's triangulation of polygons with more than four corners, as keyword arguments of a native Mesh: (T, 3)
    int32 vertices, and (T,) int32 polygon of each, ascending; {} if there are no such polygons.
    """
    is_ngon = np.diff(polygon_offsets) > 4
    if not is_ngon.any():
        return {}
    mesh.calc_loop_triangles()
    count = len(mesh.loop_triangles)
    polygon = buffers.take("triangle_polygon", (count,), np.int32)
    mesh.loop_triangles.foreach_get("polygon_index", polygon)
    vertices = buffers.take("triangle_vertices", (count, 3), np.int32)
    mesh.loop_triangles.foreach_get("vertices", vertices.ravel())
    of_ngon = is_ngon[polygon]
    return {"ngon_triangles": vertices[of_ngon], "ngon_polygon": polygon[of_ngon]}


def _offsets(core, mesh, rings, offsets):
    """Fills `offsets` with the first corner of each polygon and the number of corners. Blender makes up those of each
    polygon one by one, which takes as long as all else that is read: where all have 3 or 4 corners they are known."""
    polygons, corners = len(offsets) - 1, len(rings["corner_verts"])
    each = corners // polygons if polygons else 0
    if each in (3, 4) and corners == each * polygons and core.all_polygons_have(each, **rings):
        offsets[:] = np.arange(0, corners + 1, each, dtype=np.int32)
        return offsets
    return read_offsets(mesh, offsets)


def read_offsets(mesh, offsets):
    """Fills `offsets` (F + 1,) with the first corner of each polygon and the number of corners, as Blender has them."""
    mesh.polygons.foreach_get("loop_start", offsets[:-1])
    offsets[-1] = len(mesh.loops)
    return offsets


def _required(mesh, name, buffers, shape, dtype):
    """An attribute that exists whenever its domain has elements."""
    if not math.prod(shape):
        return buffers.take(name, shape, dtype)
    values = mesh.attributes[name].data
    found = _in_place(values, shape, dtype) if mesh.is_runtime_data else None
    if found is None:
        found = buffers.take(name, shape, dtype)
        values.foreach_get("vector" if name == "position" else "value", found.ravel())
    return found


def _in_place(values, shape, dtype):
    """The values of an attribute where an evaluated mesh has them, which nobody else changes: read-only, valid as long
    as the mesh. None where they are few, or do not lie in memory as those of such an array do."""
    length = math.prod(shape) * np.dtype(dtype).itemsize
    if length < LEAST_IN_PLACE or len(values) != shape[0]:
        return None
    first, last = values[0].as_pointer(), values[shape[0] - 1].as_pointer()
    if (last - first) * shape[0] != length * (shape[0] - 1):
        return None
    found = np.frombuffer((ctypes.c_byte * length).from_address(first), dtype).reshape(shape)
    found.flags.writeable = False
    return found


def _optional(mesh, name, buffers, shape, dtype):
    attribute = mesh.attributes.get(name)
    if attribute is None or shape[0] == 0:
        return None
    array = buffers.take(name, shape, dtype)
    attribute.data.foreach_get("value", array)
    return array


def _freestyle_marks(mesh, buffers):
    """(E,) bool Freestyle edge marks or None; an edge property up to Blender 4.5, an attribute from 5.0."""
    if "use_freestyle_mark" not in bpy.types.MeshEdge.bl_rna.properties:
        return _optional(mesh, "freestyle_edge", buffers, (len(mesh.edges),), np.bool_)
    array = buffers.take("freestyle_edge", (len(mesh.edges),), np.bool_)
    mesh.edges.foreach_get("use_freestyle_mark", array)
    return array if array.any() else None
