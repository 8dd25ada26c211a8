# SPDX-License-Identifier: GPL-3.0-or-later
"""What the polygons of an object stand for, which decides the lines that suit it: as its settings say, or decided by
the core (native/fovea/field/shape.h) from its rest shape, so that it stays the same through an animation."""

import bpy

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
LABELS = {name.lower(): label.lower() for name, label, _ in SHAPES}

# Modifiers whose result says nothing about the mesh before them.
GENERATING = {"BOOLEAN", "EXPLODE", "FLUID", "MESH_SEQUENCE_CACHE", "MULTIRES", "NODES", "OCEAN", "REMESH", "SCREW",
              "SKIN", "VOLUME_TO_MESH"}  # fmt: skip


def rest(obj, mesh, depsgraph):
    """The mesh of an object before its modifiers and shape keys, if these deform or multiply it; None if the evaluated
    mesh shows what the object is."""
    real = obj.original.evaluated_get(depsgraph)  # instances are temporary copies
    base = obj.original.data
    if not isinstance(base, bpy.types.Mesh) or real.data != mesh or is_edited(real) or not len(base.polygons):
        return None
    kinds = {modifier.type for modifier in real.modifiers}
    if not kinds and not base.shape_keys:
        return None
    same = len(base.vertices) == len(mesh.vertices)
    return base if same or kinds.isdisjoint(GENERATING) else None
