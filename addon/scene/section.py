# SPDX-License-Identifier: GPL-3.0-or-later
"""The section plane of a scene: the local XY plane of an object, whose +Z side is cut away."""

import bpy
import numpy as np

from . import followed
from .problem import CannotDraw
from .property_kinds import pointer


def annotations():
    """Property annotations for the scene's settings."""
    told = "An object, as an Empty, whose XY plane cuts the scene open: what is on its +Z side is cut away"
    return {"section": pointer("Section Plane", told, type=bpy.types.Object)}


def of(depsgraph):
    """The object whose plane cuts what an evaluated depsgraph's renders draw, or None."""
    return followed.evaluated(depsgraph).fovea.section


def plane_of(depsgraph):
    """The section plane (x, y, z, w) in world space of an evaluated depsgraph, with a unit normal: x, y and z times a
    point, plus w, is positive where all is cut away. None without one. CannotDraw if it has no direction."""
    chosen = of(depsgraph)
    if chosen is None:
        return None
    matrix = np.array(chosen.original.evaluated_get(depsgraph).matrix_world, np.float64)
    normal = np.cross(matrix[:3, 0], matrix[:3, 1])
    length = np.linalg.norm(normal)
    if not (np.isfinite(matrix).all() and length > 0.0):
        raise CannotDraw(
            f"The section plane '{chosen.name}' has no direction, as it is scaled to 0 or its transform is no number: "
            "clear its scale, or choose another section plane"
        )
    normal *= (1.0 if np.dot(normal, matrix[:3, 2]) >= 0.0 else -1.0) / length
    return (*normal.tolist(), -float(normal @ matrix[:3, 3]))
