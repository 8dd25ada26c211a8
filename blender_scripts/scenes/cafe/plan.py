# SPDX-License-Identifier: GPL-3.0-or-later
"""The measures that the cafe's parts share, in metres; the tower's axis is the z axis."""

import math

from .. import shapes

RADIUS, WALL = 1.7, 0.3  # of the tower
CORNICE = 4.63  # its upper edge
DOOR = 251.0  # where the door looks, degrees from +x
SILL = 0.47  # of the door, a hand above three steps
WINDOWS = (DOOR - 58, DOOR + 56)  # where the tower's windows look
OCULI = (DOOR - 44, DOOR, DOOR + 44)
OCULUS = 3.83  # height of their middles

FRONT = -0.95  # the wing's wall in y
LENGTH = 18.0  # of the wing, out of the picture
EAVE, RIDGE = 3.5, 1.35  # of the wing's roof: height of the one, y of the other
PITCH = math.tan(math.radians(30))
SHOP = (4.1, 7.9, 0.75, 2.35)  # its window: x from, to, z from, to


def radial(shape, angle: float, radius: float = RADIUS):
    """Takes a mesh made around x = y = 0, looking to -y, to the tower's wall."""
    turn = math.radians(angle)
    return shapes.moved(shape, (radius * math.cos(turn), radius * math.sin(turn), 0), (0, 0, turn + math.pi / 2))
