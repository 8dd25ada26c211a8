# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene as read at one moment: native surfaces, and where they are placed."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np


class Origin(NamedTuple):
    """What the placements of an object's data by one instancer have in common."""

    surface: int  # its index
    names: int  # hash of the object's and the instancer's names
    usage: int  # bits DRAW, OCCLUDE, HOLDOUT
    group: int  # the same where objects have one outline together; 0: of none
    object: str  # name
    owners: tuple  # full names: the object's and, for an instance, its instancer's
    importance: float  # in [0, 1], the object's priority
    shown: int  # kinds of lines that the object shows, bit i: the registry's definition i
    color: tuple  # the object's viewport color, scene-linear
    own: tuple  # per parameter of own_lines.parameters(): the object's value, NaN: not overridden


@dataclass(frozen=True, eq=False)
class Snapshot:
    """A scene as the native module takes it: n placements of m surfaces."""

    surfaces: list  # m native surfaces
    slots: list  # m tuples of materials.Slot
    origins: list  # Origins
    origin_of_placement: np.ndarray  # (n,) uint32
    object_to_world: np.ndarray  # (n, 4, 4) float64
    persistent_id: np.ndarray  # (n,) uint64, the same in every frame and every session
    usage: np.ndarray  # (n,) uint8: the Origins', which a caller may narrow
    left_out: dict  # object name -> why some of it has no lines
    section: tuple | None  # the section plane (x, y, z, w) in world space; see section.py
    lights: list  # lights.Lamp
    at_rest: list  # m: (shape, reason) as decided of the mesh at rest; None: of the surface itself, or as asked for

    def native_lights(self, core):
        """The lights as native Lights."""
        return [core.Light(*lamp) for lamp in self.lights]

    def of_origins(self, member, dtype):
        """(n,) array of a member of the placements' Origins."""
        return np.array([getattr(origin, member) for origin in self.origins], dtype)[self.origin_of_placement]

    @cached_property
    def surface_of_placement(self):
        """(n,) int32."""
        return self.of_origins("surface", np.int32)

    @cached_property
    def objects(self):
        """n object names."""
        names = [origin.object for origin in self.origins]
        return [names[i] for i in self.origin_of_placement.tolist()]

    @cached_property
    def drawn(self):
        """The set of the names in `objects`."""
        return {origin.object for origin in self.origins}

    @property
    def triangle_count(self):
        """Of all placements together."""
        placed = np.bincount(self.surface_of_placement, minlength=len(self.surfaces)).tolist()
        return sum(len(surface.triangles) * count for surface, count in zip(self.surfaces, placed))
