# SPDX-License-Identifier: GPL-3.0-or-later
"""Slabs, outer walls and partitions with their openings: one solid."""

import numpy as np

from ..place import put
from ..solid import Solid
from .plan import DEPTH, DOORWAY, ENTRANCE, FLOORS, INNER, OUTER, PLINTH, SLAB, WIDTH, WINDOW, front, level


def build():
    made = Solid().add((-0.1, WIDTH + 0.1), (-0.4, DEPTH + 0.1), (0, PLINTH))
    for k in range(len(FLOORS)):
        storey(made, k)
    for k, floor in enumerate(FLOORS):  # after all storeys, whose walls would fill the holes again
        for x0, x1, y0, y1 in floor.openings:
            made.cut((x0, x1), (y0, y1), (level(k) - SLAB, level(k)))
    roof(made)
    for x, y, along, k in windows():
        wide, tall, sill = WINDOW
        half = (wide / 2, OUTER / 2) if along else (OUTER / 2, wide / 2)
        z = level(k) + sill
        made.cut((x - half[0], x + half[0]), (y - half[1], y + half[1]), (z, z + tall))
    made.cut((0, OUTER), ENTRANCE, (PLINTH, PLINTH + 2.3))
    put(made.mesh("House"), "wall")


def storey(made: Solid, k: int):
    y, low, high = front(k), level(k), level(k + 1) - SLAB
    if k:
        made.add((0, WIDTH), (y, DEPTH), (low - SLAB, low))
    made.add((0, WIDTH), (DEPTH - OUTER, DEPTH), (low, high))
    for x in (0, WIDTH - OUTER):
        made.add((x, x + OUTER), (y, DEPTH), (low, high))
    for x, y0, y1, door, _ in FLOORS[k].walls:
        across = (x - INNER / 2, x + INNER / 2)
        made.add(across, (max(y0, y), y1), (low, high))
        made.cut(across, (door - DOORWAY[0] / 2, door + DOORWAY[0] / 2), (low, low + DOORWAY[1]))


def roof(made: Solid):
    top, along = level(len(FLOORS)), (-0.15, WIDTH + 0.15)
    made.add(along, (DEPTH - 2.4, DEPTH + 0.15), (top - SLAB, top))
    made.add(along, (DEPTH - 0.05, DEPTH + 0.15), (top, top + 0.3))


def windows():
    """(x, y of the middle, whether its wall runs along x, floor) of every window."""
    for k in range(len(FLOORS)):
        for x in np.arange(1.55, WIDTH - 1, 2.32):
            yield x, DEPTH - OUTER / 2, True, k
        for y in np.arange(DEPTH - 1.6, front(k) + 1.0, -1.9):
            if k or y > ENTRANCE[1] + 0.4:
                yield OUTER / 2, y, False, k
            yield WIDTH - OUTER / 2, y, False, k
