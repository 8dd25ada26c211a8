# SPDX-License-Identifier: GPL-3.0-or-later
"""office: a cutaway of five furnished floors, some 300,000 triangles of placed geometry."""

import numpy as np

from .. import plants, stage
from ..place import put
from ..shapes import revolve
from ..solid import Solid
from . import house, joinery, stairs
from .furniture import Furniture
from .plan import DEPTH, FLOORS, WIDTH, level


def build(argument, shared):
    stage.clear()
    stage.frame()
    house.build()
    joinery.build()
    stairs.build()
    furnish(shared)
    surroundings()
    stage.camera((-11.5, -31, 15), (7.6, 3.2, 7.1), lens=41)
    stage.sun(-130, 45)


def furnish(shared):
    """Adds linked copies of the furniture, with small random rotations of movable pieces."""
    furniture, draw = Furniture(shared), np.random.default_rng(1)
    for k, floor in enumerate(FLOORS):
        for name, x, y, turn, *more in floor.pieces:
            up, scale = (*more, 0.0, 1.0)[:2] if len(more) < 2 else more
            if name in ("chair", "designChair", "thonet", "stool", "dustbin", "littlePlant"):
                turn += draw.uniform(-8, 8)
            put(furniture.mesh(name), None, (x, y, level(k) + up), turn, scale)


def surroundings():
    """The base plate, trees, and ventilation units and chimneys on the roof."""
    put(Solid().add((-5, WIDTH + 3.5), (-2.6, DEPTH + 2.5), (-0.35, -0.001)).mesh("Base"), "stone")
    for x, y, height, radius, seed in ((-3.2, 6.6, 2.3, 1.5, 2), (-3.4, -1.0, 1.6, 1.0, 5), (19.0, 2.4, 2.1, 1.2, 9)):
        plants.tree((x, y, 0), height, radius, seed, segments=14)
    top = level(len(FLOORS))
    unit = Solid().add((0, 1.6), (0, 0.9), (0, 0.9)).cut((0.1, 1.5), (-0.1, 0.05), (0.15, 0.8))
    for slat in np.arange(0.2, 0.78, 0.1):
        unit.add((0.1, 1.5), (0, 0.05), (slat, slat + 0.05))
    unit = unit.mesh("Ventilation")
    for x in (2.4, 4.4):
        put(unit, "frame", (x, DEPTH - 1.6, top))
    cowl = [(0.16, 0.9), (0.24, 0.9), (0.24, 0.97), (0.05, 1.15), (0, 1.15)]
    chimney = revolve("Chimney", [(0, 0), (0.16, 0), *cowl], 64)
    for x in (10.2, 11.0, 13.6):
        put(chimney, "iron", (x, DEPTH - 0.9, top))
