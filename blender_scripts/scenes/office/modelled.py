# SPDX-License-Identifier: GPL-3.0-or-later
"""Generated furniture for the office, used where no model files are available, with the same names."""

import math

import numpy as np

from .. import plants, shapes
from ..shapes import box, joined, moved, revolve, smooth, sweep
from ..terrace import rounded
from .cabinets import cabinet, hutch, painted, radiator, shelf, whiteboard


def legs(x: float, y: float, height: float, radius: float = 0.02):
    return [sweep("Leg", [(i * x, j * y, 0), (i * x, j * y, height)], radius, 20) for i in (-1, 1) for j in (-1, 1)]


def desk(width: float = 1.6, depth: float = 0.8):
    top = box("Top", (width, depth, 0.03), (0, 0, 0.7), 0.004, 1)
    panel = box("Panel", (width - 0.3, 0.02, 0.35), (0, depth / 2 - 0.12, 0.34))
    return painted(joined("Desk", [top, panel, *legs(width / 2 - 0.1, depth / 2 - 0.1, 0.699)]), "laminate")


def chair(seat: float = 0.45, width: float = 0.46):
    cushion = box("Seat", (width, width, 0.05), (0, 0, seat - 0.05), 0.018)
    back = moved(box("Back", (width, 0.04, 0.42), rounding=0.018), (0, width / 2 - 0.01, seat + 0.045), (-0.12, 0, 0))
    stand = legs(width / 2 - 0.04, width / 2 - 0.04, seat - 0.05, 0.016)
    return painted(joined("Chair", [cushion, back, *stand]), "upholstery")


def swivel():
    angle = np.linspace(0.25 * math.pi, 0.75 * math.pi, 24)
    section = ((0.27, 0.56), (0.3, 0.62), (0.3, 0.95), (0.285, 0.99), (0.27, 0.95), (0.27, 0.62), (0.27, 0.56))
    shell = [np.stack([r * np.cos(angle), r * np.sin(angle), np.full_like(angle, z)], axis=1) for r, z in section]
    parts = [revolve("Seat", rounded(0.27, 0.42, 0.49), 64), shapes.sheet("Back", shell)]
    parts.append(revolve("Column", [(0, 0.06), (0.035, 0.06), (0.035, 0.42), (0, 0.42)], 32))
    for a in np.arange(5) * 2 * math.pi / 5:
        parts.append(sweep("Foot", [(0, 0, 0.08), (0.3 * math.cos(a), 0.3 * math.sin(a), 0.03)], [0.03, 0.018], 20))
    return painted(joined("Swivel chair", parts), "upholstery")


def round_table():
    foot = [
        (0, 0),
        (0.35, 0),
        (0.35, 0.02),
        *smooth([(0.33, 0.03), (0.1, 0.08), (0.06, 0.2)], 6),
        (0.05, 0.7),
        (0, 0.7),
    ]
    return painted(joined("Table", [revolve("Foot", foot, 64), revolve("Top", rounded(0.62, 0.701, 0.741), 96)]), "oak")


def lamp():
    shade = smooth([(0.03, 0.4), (0.08, 0.38), (0.12, 0.31), (0.122, 0.29)], 8)
    parts = [
        revolve("Foot", rounded(0.09, 0, 0.025), 64),
        revolve("Shade", [(0, 0.4), *shade, (0.116, 0.29), (0, 0.36)], 64),
    ]
    parts.append(revolve("Stem", [(0, 0.025), (0.012, 0.025), (0.012, 0.35), (0, 0.35)], 24))
    return painted(joined("Lamp", parts), "steel")


def plant():
    rim = [(0.1, 0.1), (0.105, 0.1), (0.105, 0.12), (0.095, 0.12), (0.09, 0.105)]
    pot = revolve("Pot", [(0, 0), (0.075, 0), *rim, (0, 0.105)], 64)
    leaves = moved(plants.rosette("Leaves", 18, 0.16, 0.05, 4), (0, 0, 0.107))
    return painted(joined("Plant", [pot, leaves]), "leaf")


def sofa():
    parts = [box("Base", (1.66, 0.74, 0.2), (0, 0, 0.1), 0.03), *legs(0.75, 0.3, 0.1)]
    parts.append(moved(box("Back", (1.36, 0.2, 0.52), rounding=0.06), (0, 0.26, 0.302), (-0.08, 0, 0)))
    for side in (-1, 1):
        parts.append(box("Arm", (0.15, 0.72, 0.32), (side * 0.755, 0, 0.301), 0.06))
        parts.append(box("Cushion", (0.66, 0.56, 0.14), (side * 0.335, -0.08, 0.301), 0.05))
    return painted(joined("Sofa", parts), "upholstery")


def bin():
    outside = [(0, 0), (0.13, 0), (0.16, 0.47), (0.165, 0.47), (0.165, 0.5), (0.15, 0.5)]
    return painted(revolve("Bin", [*outside, (0.12, 0.02), (0, 0.02)], 64), "steel")


def piano():
    """A grand piano: the bent side is one closed outline."""
    bent = [
        (-0.62, -0.5),
        (-0.62, 0.3),
        (-0.5, 0.68),
        (-0.25, 0.74),
        (-0.05, 0.5),
        (0.2, 0.12),
        (0.55, 0.05),
        (0.64, -0.15),
    ]
    outline = smooth([*bent, (0.64, -0.5)], 8)
    parts = [shapes.prism("Case", outline, 0.62, 0.92), box("Keys", (1.26, 0.22, 0.1), (0.01, -0.611, 0.62))]
    lid = moved(shapes.prism("Lid", outline, 0, 0.02), (-0.41, 0, 1.2), (0, -0.42, 0))
    return painted(joined("Piano", [*parts, lid, *legs(0.5, 0.4, 0.619, 0.04)[:3]]), "steel")


def spiral():
    """Most of a turn of stairs around a column."""
    parts, step, rise = [revolve("Column", [(0, 0), (0.07, 0), (0.07, 3.2), (0, 3.2)], 48)], 0.58, 0.26
    arc = np.linspace(0, 0.62, 10)
    tread = [(0.07, 0), *zip(0.75 * np.cos(arc), 0.75 * np.sin(arc))]
    for k in range(10):
        parts.append(moved(shapes.prism("Tread", tread, rise * (k + 0.8), rise * (k + 1)), turn=(0, 0, step * k)))
        x, y = 0.71 * math.cos(step * k + 0.3), 0.71 * math.sin(step * k + 0.3)
        parts.append(sweep("Baluster", [(x, y, rise * (k + 1)), (x, y, rise * k + 1.15)], 0.012, 16))
    t = np.linspace(0, 9, 80)
    turn = step * t + 0.3
    rail = np.stack([0.71 * np.cos(turn), 0.71 * np.sin(turn), 1.17 + rise * t], axis=1)
    return painted(joined("Spiral stair", [*parts, sweep("Handrail", rail, 0.025, 20)]), "steel")


MAKERS = {
    "bookcase": lambda: cabinet(0.92, 0.36, 1.47, 1, 2, "oak"),
    "chair": chair,
    "designChair": swivel,
    "desk": hutch,
    "desklamp": lamp,
    "drawersCabinet": lambda: cabinet(0.6, 0.61, 0.88, 3),
    "dustbin": bin,
    "largeFridge": lambda: cabinet(0.92, 0.9, 1.84, 1, 2),
    "lbDesk": desk,
    "littlePlant": plant,
    "oakTable": round_table,
    "pianoAQueue": piano,
    "radiator1": radiator,
    "shelves": lambda: shelf(2, 2, 0.83, 0.82),
    "sofa2": sofa,
    "spiralStaircase": spiral,
    "stool": lambda: chair(0.68, 0.36),
    "thonet": chair,
    "verticalShelves": lambda: shelf(1, 5, 0.44, 1.96),
    "whiteBoard": whiteboard,
}
