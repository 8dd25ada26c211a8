# SPDX-License-Identifier: GPL-3.0-or-later
"""Tower, steps and wing in one piece, with their openings."""

import math

from .. import shapes
from ..place import put
from ..shapes import arch, combine, revolve, smooth, upright
from ..solid import Solid
from .plan import CORNICE, DOOR, EAVE, FRONT, LENGTH, OCULI, OCULUS, RADIUS, SHOP, SILL, WALL, WINDOWS, radial


def build():
    whole = combine("UNION", tower(), wing(), steps())
    put(combine("DIFFERENCE", whole, *openings()), "plaster")


def tower():
    inner, moulding = RADIUS - WALL, RADIUS + 0.09
    plinth = [(inner, 0), (moulding, 0), (moulding, 0.55), (RADIUS, 0.61)]
    course = [(RADIUS, 3.24), (moulding, 3.26), (moulding, 3.36), (RADIUS, 3.38)]
    swell = [(0.02, 4.33), (0.05, 4.42), (0.16, 4.48), (0.24, 4.55)]
    cornice = [(RADIUS, 4.27), (RADIUS + 0.02, 4.27), *smooth([(RADIUS + out, z) for out, z in swell], 4)]
    top = [(RADIUS + 0.24, CORNICE), (inner, CORNICE), (inner, 0)]
    return revolve("Cafe", [*plinth, *course, *cornice, *top], 128)


def wing():
    x0, x1, z0, z1 = SHOP
    block = Solid().add((1.3, LENGTH), (FRONT, 4), (0, EAVE - 0.16)).add((1.3, LENGTH), (FRONT - 0.07, 0), (0, 0.5))
    block.cut((x0, x1), (-2, 1.2), (z0, z1))
    return block.add((x0 - 0.12, x1 + 0.12), (FRONT - 0.14, FRONT), (z0 - 0.09, z0)).mesh("Wing")


def steps():
    treads = [(1.65 - 0.38 * k, 0.15 * (k + up)) for k in range(3) for up in (0, 1)]
    return radial(revolve("Steps", [(0, 0), *treads, (0, 0.45)], 96), DOOR, 1.55)


def openings():
    yield radial(upright("Door hole", arch(1.3, SILL, 2.1), -1, 0.6), DOOR)
    for angle in WINDOWS:
        yield radial(upright("Window hole", arch(0.72, 1.3, 2.15), -1, 0.6), angle)
    for angle in OCULI:
        hole = revolve("Oculus hole", [(0, -1), (0.27, -1), (0.27, 0.6), (0, 0.6)], 64)
        yield radial(shapes.moved(hole, (0, 0, OCULUS), (-math.pi / 2, 0, 0)), angle)
