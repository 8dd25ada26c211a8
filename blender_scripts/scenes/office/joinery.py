# SPDX-License-Identifier: GPL-3.0-or-later
"""Windows and doors: linked copies, each GAP smaller than its opening on every side, so that it has an outline of its
own."""

from .. import shapes
from ..place import put
from ..solid import Solid, bars
from .house import windows
from .plan import DOORWAY, ENTRANCE, FLOORS, INNER, OUTER, PLINTH, WIDTH, WINDOW, level

GAP = 0.003


def build():
    glaze()
    hang_doors()
    entrance()


def glaze():
    wide, tall, sill = WINDOW
    frame = bars(wide - 2 * GAP, tall - 2 * GAP, 2, 2, 0.06, 0.07, 0.035).mesh("Window")
    frame = shapes.moved(frame, (GAP - wide / 2, 0, GAP))
    board = Solid().add((-wide / 2 - 0.08, wide / 2 + 0.08), (-0.14, 0), (-0.05, 0)).mesh("Sill")
    for x, y, along, k in windows():
        turn = 0 if along else 90 if x > WIDTH / 2 else -90
        put(frame, "frame", (x, y, level(k) + sill), turn)
        if turn < 0:  # only on the facade that the camera sees
            put(board, "stone", (-0.001, y, level(k) + sill), turn)


def hang_doors():
    width, height = DOORWAY
    leaf = Solid().add((0, width - 0.02), (-0.02, 0.02), (0.01, height - 0.01))
    for side in (-1, 1):
        for panel in ((0.25, 0.95), (1.1, 1.9)):
            leaf.cut((0.14, width - 0.16), (side * 0.01, side * 0.03), panel)
        leaf.add((width - 0.11, width - 0.08), (side * 0.02, side * 0.06), (1.0, 1.025))
        leaf.add((width - 0.2, width - 0.08), (side * 0.05, side * 0.07), (1.0, 1.025))
    leaf = leaf.mesh("Door")
    for k, floor in enumerate(FLOORS):
        for x, _, _, door, swing in floor.walls:
            put(leaf, "door", (x - INNER / 2 - 0.025, door + width / 2 - 0.01, level(k)), -90 - swing)


def entrance():
    y0, y1 = ENTRANCE
    wide = y1 - y0 - 2 * GAP
    frame = shapes.moved(bars(wide, 2.294, 2, 1, 0.08, 0.08, 0.07).mesh("Entrance"), (-wide / 2, 0, GAP / 2))
    put(frame, "frame", (OUTER / 2, (y0 + y1) / 2, PLINTH), -90)
    around = (y0 - 0.3, y1 + 0.3)
    put(Solid().add((-1.5, -0.001), around, (PLINTH + 2.55, PLINTH + 2.7)).mesh("Canopy"), "stone")
    put(Solid().add((-1.1, -0.101), around, (0, PLINTH - 0.02)).mesh("Step"), "stone")
