"""Plain furniture for the office where the models are absent, under the same names."""

import math

import numpy as np

from . import plants, shapes, stage, terrace
from .shapes import box, joined, moved, revolve, smooth, sweep
from .solid import Solid

WOOD = ("Oak", (0.62, 0.46, 0.3))
LIGHT = ("Laminate", (0.85, 0.84, 0.8))
DARK = ("Steel", (0.25, 0.26, 0.28))
CLOTH = ("Upholstery", (0.36, 0.42, 0.5))


def painted(name, paint, parts):
    made = parts if not isinstance(parts, list) else joined(name, parts)
    made.materials.append(stage.material(*paint))
    return made


def legs(x: float, y: float, height: float, radius: float = 0.02):
    return [sweep("Leg", [(sx * x, sy * y, 0), (sx * x, sy * y, height)], radius, 20) for sx in (-1, 1) for sy in (-1, 1)]


def desk(width: float = 1.6, depth: float = 0.8):
    return painted("Desk", LIGHT, [box("Top", (width, depth, 0.03), (0, 0, 0.7), 0.004, 1), *legs(width / 2 - 0.1, depth / 2 - 0.1, 0.699),
                                   box("Panel", (width - 0.3, 0.02, 0.35), (0, depth / 2 - 0.12, 0.34))])


def hutch():
    made = Solid().add((-0.7, 0.7), (-0.27, 0.27), (0.7, 0.73)).add((-0.7, -0.25), (-0.25, 0.27), (0, 0.7)).cut((-0.67, -0.28), (-0.3, -0.24), (0.05, 0.66))
    made.add((0.66, 0.7), (-0.25, 0.27), (0, 1.05)).add((0.3, 0.34), (0, 0.27), (0.73, 1.05)).add((0.3, 0.7), (-0.05, 0.27), (1.02, 1.05))
    return painted("Desk with shelf", WOOD, made.mesh("Hutch"))


def chair(seat: float = 0.45, width: float = 0.46):
    back = moved(box("Back", (width, 0.04, 0.42), rounding=0.018), (0, width / 2 - 0.01, seat + 0.045), (-0.12, 0, 0))
    return painted("Chair", CLOTH, [box("Seat", (width, width, 0.05), (0, 0, seat - 0.05), 0.018), back, *legs(width / 2 - 0.04, width / 2 - 0.04, seat - 0.05, 0.016)])


def swivel():
    parts = [revolve("Seat", terrace.rounded(0.27, 0.42, 0.49), 64), revolve("Column", [(0, 0.06), (0.035, 0.06), (0.035, 0.42), (0, 0.42)], 32)]
    angle = np.linspace(0.25 * math.pi, 0.75 * math.pi, 24)
    shell = [np.stack([r * np.cos(angle), r * np.sin(angle) * 1.0, z + 0 * angle], axis=1)
             for r, z in ((0.27, 0.56), (0.3, 0.62), (0.3, 0.95), (0.285, 0.99), (0.27, 0.95), (0.27, 0.62), (0.27, 0.56))]
    parts.append(shapes.sheet("Back", shell))
    parts += [sweep("Foot", [(0, 0, 0.08), (0.3 * math.cos(a), 0.3 * math.sin(a), 0.03)], [0.03, 0.018], 20) for a in np.arange(5) * 2 * math.pi / 5]
    return painted("Swivel chair", CLOTH, parts)


def round_table():
    foot = [(0, 0), (0.35, 0), (0.35, 0.02), *smooth([(0.33, 0.03), (0.1, 0.08), (0.06, 0.2)], 6), (0.05, 0.7), (0, 0.7)]
    return painted("Round table", WOOD, [revolve("Foot", foot, 64), revolve("Top", terrace.rounded(0.62, 0.701, 0.741), 96)])


def shelf(columns: int, rows: int, width: float, height: float, depth: float = 0.38):
    """Open shelves with books in some."""
    made, board = Solid().add((-width / 2, width / 2), (-depth / 2, depth / 2), (0, height)), 0.03
    x = np.linspace(-width / 2 + board / 2, width / 2 - board / 2, columns + 1)
    z = np.linspace(board / 2, height - board / 2, rows + 1)
    draw = np.random.default_rng(columns * 10 + rows)
    for x0, x1 in zip(x[:-1], x[1:]):
        for z0, z1 in zip(z[:-1], z[1:]):
            made.cut((x0 + board / 2, x1 - board / 2), (-depth, depth / 2 - 0.02), (z0 + board / 2, z1 - board / 2))
            at, end = x0 + board / 2, x0 + (x1 - x0) * draw.uniform(0, 0.95)
            while at < end - 0.06:
                thick, tall = draw.uniform(0.02, 0.05), draw.uniform(0.55, 0.85) * (z1 - z0 - board)
                made.add((at, at + thick), (draw.uniform(-0.3, -0.1) * depth, depth / 2 - 0.02), (z0 + board / 2, z0 + board / 2 + tall))
                at += thick
    return painted("Shelf", WOOD, made.mesh("Shelf"))


def cabinet(width: float, depth: float, height: float, drawers: int, columns: int = 1, paint=LIGHT):
    """Drawers or doors with a gap around each and a bar to pull."""
    made = Solid().add((-width / 2, width / 2), (-depth / 2, depth / 2), (0, height))
    x, z = np.linspace(-width / 2, width / 2, columns + 1), np.linspace(0.06, height, drawers + 1)
    for x0, x1 in zip(x[:-1], x[1:]):
        for z0, z1 in zip(z[:-1], z[1:]):
            made.add((x0 + 0.008, x1 - 0.008), (-depth / 2 - 0.018, -depth / 2), (z0 + 0.006, z1 - 0.006))
            middle = (x0 + x1) / 2
            made.add((middle - 0.08, middle + 0.08), (-depth / 2 - 0.04, -depth / 2 - 0.018), (z1 - 0.08, z1 - 0.06))
    return painted("Cabinet", paint, made.mesh("Cabinet"))


def lamp():
    shade = smooth([(0.03, 0.4), (0.08, 0.38), (0.12, 0.31), (0.122, 0.29)], 8)
    parts = [revolve("Foot", terrace.rounded(0.09, 0, 0.025), 64), revolve("Stem", [(0, 0.025), (0.012, 0.025), (0.012, 0.35), (0, 0.35)], 24),
             revolve("Shade", [(0, 0.4), *shade, (0.116, 0.29), (0, 0.36)], 64)]
    return painted("Lamp", DARK, parts)


def plant():
    pot = revolve("Pot", [(0, 0), (0.075, 0), (0.1, 0.1), (0.105, 0.1), (0.105, 0.12), (0.095, 0.12), (0.09, 0.105), (0, 0.105)], 64)
    return painted("Plant", ("Leaf", plants.LEAF), [pot, moved(plants.rosette("Leaves", 18, 0.16, 0.05, 4), (0, 0, 0.107))])


def sofa():
    parts = [box("Base", (1.66, 0.74, 0.2), (0, 0, 0.1), 0.03), moved(box("Back", (1.36, 0.2, 0.52), rounding=0.06), (0, 0.26, 0.302), (-0.08, 0, 0))]
    parts += [box("Arm", (0.15, 0.72, 0.32), (side * 0.755, 0, 0.301), 0.06) for side in (-1, 1)]
    parts += [box("Cushion", (0.66, 0.56, 0.14), (side * 0.335, -0.08, 0.301), 0.05) for side in (-1, 1)]
    return painted("Sofa", CLOTH, parts + legs(0.75, 0.3, 0.1))


def bin():
    return painted("Bin", DARK, revolve("Bin", [(0, 0), (0.13, 0), (0.16, 0.47), (0.165, 0.47), (0.165, 0.5), (0.15, 0.5), (0.12, 0.02), (0, 0.02)], 64))


def piano():
    """A grand piano: the bent side is one closed outline."""
    bend = smooth([(-0.62, -0.5), (-0.62, 0.3), (-0.5, 0.68), (-0.25, 0.74), (-0.05, 0.5), (0.2, 0.12), (0.55, 0.05), (0.64, -0.15), (0.64, -0.5)], 8)
    parts = [shapes.prism("Case", bend, 0.62, 0.92), box("Keys", (1.26, 0.22, 0.1), (0.01, -0.611, 0.62)), *[moved(leg, (0, 0, 0)) for leg in legs(0.5, 0.4, 0.619, 0.04)[:3]]]
    parts.append(moved(shapes.prism("Lid", bend, 0, 0.02), (-0.41, 0, 1.2), (0, -0.42, 0)))
    return painted("Piano", DARK, parts)


def radiator():
    made = Solid().add((-1.0, 1.0), (-0.05, 0.05), (0.0, 0.6))
    for x in np.arange(-0.95, 0.95, 0.1):
        made.add((x + 0.01, x + 0.07), (-0.07, 0.05), (0.05, 0.55))
    return painted("Radiator", LIGHT, made.mesh("Radiator"))


def spiral():
    """A turn of stairs around a column."""
    parts = [revolve("Column", [(0, 0), (0.07, 0), (0.07, 3.2), (0, 3.2)], 48)]
    for k in range(10):
        arc = np.linspace(0, 0.62, 10)
        wedge = [(0.07, 0), *zip(0.75 * np.cos(arc), 0.75 * np.sin(arc))]
        parts.append(moved(shapes.prism("Tread", wedge, 0.21 + 0.26 * k, 0.26 + 0.26 * k), turn=(0, 0, 0.58 * k)))
        a = 0.58 * k + 0.3
        parts.append(sweep("Baluster", [(0.71 * math.cos(a), 0.71 * math.sin(a), 0.26 + 0.26 * k), (0.71 * math.cos(a), 0.71 * math.sin(a), 1.15 + 0.26 * k)], 0.012, 16))
    t = np.linspace(0.3, 0.58 * 9 + 0.3, 80)
    parts.append(sweep("Handrail", np.stack([0.71 * np.cos(t), 0.71 * np.sin(t), 1.17 + 0.26 * (t - 0.3) / 0.58], axis=1), 0.025, 20))
    return painted("Spiral stair", DARK, parts)


def whiteboard():
    made = Solid().add((-0.62, 0.62), (-0.02, 0.02), (0.5, 1.3)).cut((-0.59, 0.59), (-0.03, -0.01), (0.53, 1.27)).add((-0.3, 0.3), (-0.07, -0.02), (0.48, 0.5))
    for side in (-1, 1):
        made.add((side * 0.58 - 0.02, side * 0.58 + 0.02), (-0.015, 0.015), (0.03, 0.5)).add((side * 0.58 - 0.02, side * 0.58 + 0.02), (-0.27, 0.27), (0, 0.03))
    return painted("Whiteboard", LIGHT, made.mesh("Whiteboard"))


MAKERS = {
    "bookcase": lambda: cabinet(0.92, 0.36, 1.47, 1, 2, WOOD), "chair": chair, "designChair": swivel, "desk": hutch, "desklamp": lamp,
    "drawersCabinet": lambda: cabinet(0.6, 0.61, 0.88, 3), "dustbin": bin, "largeFridge": lambda: cabinet(0.92, 0.9, 1.84, 1, 2), "lbDesk": desk,
    "littlePlant": plant, "oakTable": round_table, "pianoAQueue": piano, "radiator1": radiator, "shelves": lambda: shelf(2, 2, 0.83, 0.82),
    "sofa2": sofa, "spiralStaircase": spiral, "stool": lambda: chair(0.68, 0.36), "thonet": chair, "verticalShelves": lambda: shelf(1, 5, 0.44, 1.96),
    "whiteBoard": whiteboard,
}
