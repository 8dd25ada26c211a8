# SPDX-License-Identifier: GPL-3.0-or-later
"""What the polygons of an object stand for, which decides the lines that suit it: as its settings say, or decided by
the core (native/fovea/field/shape.h) from its rest shape, so that it stays the same through an animation."""

import bpy

from . import mesh_arrays
from .mesh_arrays import is_edited

AUTOMATIC, HARD = "automatic", "hard"
SHAPES = [
    ("AUTOMATIC", "Automatic", "Decided by shading and by how the faces bend, at rest"),
    ("HARD", "Hard", "Its faces are meant as they are: contours of the mesh, and creases at all sharp angles"),
    ("ROUNDED", "Rounded", "Its faces are a coarse form of a rounded shape: contours of the mesh, and creases only "
     "where it is folded"),
    ("SMOOTH", "Smooth", "Its faces are a fine form of a smooth shape: also lines of curvature, as smooth contours, "
     "suggestive contours, ridges and valleys"),
]  # fmt: skip
REST = "rest_position"  # Blender's attribute of vertices
RINGS = 4  # of MeshArrays, after the positions: what joins the vertices
LABELS = {name.lower(): label.lower() for name, label, _ in SHAPES}

# Modifiers whose result says nothing about the mesh before them.
GENERATING = {"BOOLEAN", "EXPLODE", "FLUID", "MESH_SEQUENCE_CACHE", "MULTIRES", "NODES", "OCEAN", "REMESH", "SCREW",
              "SKIN", "VOLUME_TO_MESH"}  # fmt: skip


def rest(real, mesh):
    """The mesh of an object before its modifiers and shape keys, if these deform or multiply it; None if the evaluated
    mesh shows what the object is. `real`: its evaluated original."""
    base = real.original.data
    if not isinstance(base, bpy.types.Mesh) or real.data != mesh or is_edited(real):
        return None
    if base.is_editmode or not len(base.polygons):  # while it is edited, its arrays may be missing
        return None
    kinds = {modifier.type for modifier in real.modifiers}
    if not kinds and not base.shape_keys:
        return None
    same = len(base.vertices) == len(mesh.vertices)
    return base if same or kinds.isdisjoint(GENERATING) else None


class AtRest:
    """What meshes at rest say of surfaces that are deformed: where vertices were, and shapes, which the core decides
    once for each mesh. Content hashes say whether that still holds."""

    def __init__(self, core, buffers):
        self._core, self._buffers = core, buffers
        self._known = {}  # full name of a mesh -> (content hashes, (shape, reason))
        self._contents = {}  # full name of a mesh that has been read in this pass -> content hashes of its MeshArrays
        self.decided = {}  # id of a surface used in this pass -> (shape, reason)

    def begin(self):
        """Starts a pass over a depsgraph, in which meshes at rest stay as they are."""
        self._contents.clear()
        self.decided.clear()

    def set_shape(self, entry, shape, mesh, changed):
        """Sets what the polygons of the surface of a SurfaceCache's entry stand for: as asked for by `shape` or, if it
        is automatic, as decided of the mesh at rest; without one (None), the core decides by the surface itself.
        `changed`: whether the entry is new or its surface has moved. Takes the arrays of `buffers`."""
        if shape != AUTOMATIC or mesh is None:
            entry.rest = None
        elif changed or entry.rest is None:
            entry.rest = self._of(mesh)
        if entry.rest:
            shape, _ = self.decided[id(entry.surface)] = entry.rest
        entry.surface.set_shape(shape)

    def positions(self, mesh, base, topology):
        """(V, 3) float32 positions of an evaluated mesh's vertices at rest: its attribute rest_position, else those of
        `base`, the mesh at rest or None, if that has the `topology` of a SurfaceCache's entry; None: nobody knows."""
        found = mesh_arrays.vectors(mesh, REST, self._buffers)
        if found is None and base is not None and len(base.vertices) == topology[0]:
            _, *rings = self._content(base)
            if tuple(rings[:RINGS]) == topology[1 : 1 + RINGS]:
                found = mesh_arrays.vectors(base, "position", self._buffers)
        return found

    def _of(self, mesh):
        """(shape, reason in one sentence) of a mesh at rest."""
        name, content = mesh.name_full, self._content(mesh)
        if name not in self._known or self._known[name][0] != content:
            self._known[name] = content, self._decide(mesh)
        return self._known[name][1]

    def _content(self, mesh):
        """Content hashes of the MeshArrays of a mesh at rest, which is read once in a pass."""
        name = mesh.name_full
        if name not in self._contents:
            arrays = mesh_arrays.read(self._core, mesh, self._buffers, with_marks=False)
            hashes = [None if array is None else self._core.content_hash(array) for array in vars(arrays).values()]
            self._contents[name] = hashes
        return self._contents[name]

    def _decide(self, mesh):
        arrays = mesh_arrays.read(self._core, mesh, self._buffers, with_marks=False)
        triangles = mesh_arrays.ngon_triangles(mesh, arrays.polygon_offsets, self._buffers)
        surface = self._core.Surface(mesh.name, self._core.Mesh(**vars(arrays), **triangles))
        return surface.shape, f"at rest, {surface.known_shape[1]}"
