# SPDX-License-Identifier: GPL-3.0-or-later
"""Dimensions shared by the cafe's parts, in meters; the tower's axis is the z axis."""

import math

from .. import shapes

RADIUS, WALL = 1.7, 0.3  # of the tower
CORNICE = 4.63  # its upper edge
DOOR = 251.0  # direction that the door faces, degrees from +x
SILL = 0.47  # height of the door's sill, just above three steps
WINDOWS = (DOOR - 58, DOOR + 56)  # directions that the tower's windows face
OCULI = (DOOR - 44, DOOR, DOOR + 44)
OCULUS = 3.83  # height of their middles

FRONT = -0.95  # the wing's wall in y
LENGTH = 18.0  # of the wing, out of the picture
EAVE, RIDGE = 3.5, 1.35  # of the wing's roof: height of the one, y of the other
PITCH = math.tan(math.radians(30))
SHOP = (4.1, 7.9, 0.75, 2.35)  # its window: x from, to, z from, to


def radial(shape, angle: float, radius: float = RADIUS):
    """Moves a mesh that is at x = y = 0 and faces -y to the tower's wall; `angle`: degrees from +x."""
    turn = math.radians(angle)
    return shapes.moved(shape, (radius * math.cos(turn), radius * math.sin(turn), 0), (0, 0, turn + math.pi / 2))
