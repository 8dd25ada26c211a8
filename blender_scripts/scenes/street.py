"""The square before the cafe: garden wall and gate, street lamp, a few cobbles, houses far off."""

import math
import random

import numpy as np

from . import shapes, stage
from .shapes import arch, combine, revolve, smooth, upright
from .solid import Solid, bars

STONE = (0.78, 0.76, 0.72)
PLASTER = (0.87, 0.8, 0.66)
IRON = (0.13, 0.14, 0.15)
FAR = (0.85, 0.86, 0.87)
ROOF = (0.7, 0.5, 0.42)


def ground():
    sheet = shapes.mesh("Ground", [(-60, -40, 0), (60, -40, 0), (60, 90, 0), (-60, 90, 0)], [[0, 1, 2, 3]])
    stage.put(sheet, stage.material("Ground", (0.8, 0.79, 0.77)))


def garden_wall(location, turn: float, length: float):
    """From `location` along local +x; an arched gate a little way along, a coping on top."""
    wall = Solid().add((-0.6, length), (-0.16, 0.16), (0, 2.1)).add((-0.6, length), (-0.2, 0.2), (0, 0.35)).add((-0.6, length), (-0.22, 0.22), (2.1, 2.2))
    wall.add((1.1, 3.3), (-0.24, 0.24), (0, 2.62)).add((1.02, 3.38), (-0.32, 0.32), (2.62, 2.74))
    shape = combine("DIFFERENCE", wall.mesh("Garden wall"), shapes.moved(upright("Hole", arch(1.4, -1, 1.6), -1, 1), (2.2, 0, 0)))
    stage.put(shape, stage.material("Plaster", PLASTER), location, turn)
    iron = stage.material("Iron", IRON)
    for k in range(9):
        x = -0.6 + 0.15 * k
        top = 1.6 + math.sqrt(0.66 ** 2 - x * x)
        bar = [(2.2 + x, 0, 0.08), (2.2 + x, 0, top - 0.02)]
        stage.pipe("Gate bar", bar, 0.011, iron, location=location, turn=turn)
    for z in (0.14, 1.1, 1.6):
        stage.pipe("Gate rail", [(2.2 - 0.67, -0.02, z), (2.2 + 0.67, -0.02, z)], 0.016, iron, location=location, turn=turn)


def lamp(location, height: float = 3.3):
    """A globe on a cast post."""
    iron = stage.material("Iron", IRON)
    base = [(0, 0), (0.17, 0), (0.17, 0.1), *smooth([(0.15, 0.12), (0.13, 0.2), (0.12, 0.5), (0.08, 0.62)], 5), (0.1, 0.64), (0.1, 0.69), (0.055, 0.72)]
    top = [(0.042, height - 0.5), *smooth([(0.042, height - 0.5), (0.09, height - 0.44), (0.05, height - 0.38)], 5), (0.038, height - 0.36), (0.035, height - 0.16),
           *smooth([(0.035, height - 0.16), (0.06, height - 0.06), (0.12, height)], 5), (0.12, height + 0.035), (0, height + 0.035)]
    stage.put(revolve("Lamp post", [*base, *top], 64), iron, location)
    radius, angle = 0.24, np.linspace(-1.05, math.pi / 2 - 0.25, 40)
    globe = np.stack([radius * np.cos(angle), height + 0.036 + radius * (np.sin(angle) - math.sin(-1.05))], axis=1)
    stage.put(revolve("Globe", [(0, globe[0, 1]), *globe, (0, globe[-1, 1])], 96), stage.material("Glass", (0.62, 0.74, 0.78)), location)
    cap = [(0, globe[-1, 1] + 0.001), (0.08, globe[-1, 1] + 0.001), *smooth([(0.07, globe[-1, 1] + 0.03), (0.03, globe[-1, 1] + 0.05), (0.015, globe[-1, 1] + 0.1), (0, globe[-1, 1] + 0.15)], 5)]
    stage.put(revolve("Lamp cap", cap, 64), iron, location)


def setts(name: str, places, location=(0, 0, 0), turn: float = 0.0):
    """Stones at (x, y, spin, size): open shells with round shoulders, so that each is one outline on the ground."""
    angle = np.linspace(0, 2 * math.pi, 21)[:-1]
    square = np.stack([np.sign(np.cos(angle)) * np.abs(np.cos(angle)) ** 0.5, np.sign(np.sin(angle)) * np.abs(np.sin(angle)) ** 0.5], axis=1)
    profile = [(1.0, 0.0), (0.98, 0.4), (0.9, 0.7), (0.72, 0.9), (0.4, 0.98), (0.0, 1.0)]
    stones = []
    for x, y, spin, size in places:
        along = np.array([[math.cos(spin), math.sin(spin)], [-math.sin(spin), math.cos(spin)]])
        rings = [np.insert((square * (0.092, 0.07)) @ along * size * r + (x, y), 2, 0.003 + 0.022 * h, axis=1) for r, h in profile]
        stones.append(shapes.sheet("Sett", rings, wrap_columns=True))
    stage.put(shapes.joined(name, stones), stage.material("Stone", STONE), location, turn)


def cobbles(centre, turn: float, rows: int, columns: int, seed: int):
    """A patch of setts laid in arcs, thinning out from its middle."""
    draw = random.Random(seed)
    places = []
    for row in range(rows):
        for column in range(columns):
            u, v = (column + 0.5 * (row % 2)) / columns * 2 - 1, row / max(rows - 1, 1) * 2 - 1
            if draw.random() >= u * u + v * v:
                places.append((u * columns * 0.105 + draw.uniform(-0.008, 0.008), v * rows * 0.085 + 0.3 * u * u + draw.uniform(-0.008, 0.008),
                               math.atan(0.6 * u / columns / 0.105) + draw.uniform(-0.06, 0.06), draw.uniform(0.88, 1.04)))
    setts("Cobbles", places, centre, turn)


def edging(path, seed: int):
    """One row of setts along a path, with gaps where the pen may rest."""
    draw = random.Random(seed)
    path = np.asarray(path, dtype=float)
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))])
    places, at, left = [], 0.0, 12
    while at < length[-1]:
        x, y = (np.interp(at, length, path[:, k]) for k in range(2))
        k = min(np.searchsorted(length, at, side="right"), len(path) - 1)
        dx, dy = path[k] - path[k - 1]
        places.append((x, y, math.atan2(dy, dx) + draw.uniform(-0.05, 0.05), draw.uniform(1.2, 1.4)))
        left -= 1
        at += 0.27 if left > 0 else draw.uniform(0.5, 2.2)
        left = left if left > 0 else draw.randint(5, 16)
    setts("Edging", places)


def manhole(location):
    lid = [(0, 0.004), (0.34, 0.004), (0.34, 0.012), (0.3, 0.012), (0.3, 0.008), (0.27, 0.008), (0.27, 0.012), (0, 0.012)]
    stage.put(revolve("Manhole", lid, 96), stage.material("Iron", IRON), location)


def house(location, turn: float, width: float, wall: float, roof: float, depth: float = 6.0, windows=(3, 2)):
    """A gabled house far off, its eaves or gable to the viewer as it is turned; windows are shallow niches."""
    outline = [(-width / 2, 0), (width / 2, 0), (width / 2, wall), (0, wall + roof), (-width / 2, wall)]
    body = upright("House", outline, 0, depth)
    columns, floors = windows
    niches = Solid()
    for k in range(columns):
        for floor in range(floors):
            x, z = width * ((k + 0.5) / columns - 0.5), wall * (floor + 0.35) / floors
            niches.add((x - 0.35, x + 0.35), (-0.3, 0.15), (z, z + 1.15))
    stage.put(combine("DIFFERENCE", body, niches.mesh("Niches")), stage.material("Far plaster", FAR), location, turn)
    eaves = [(-width / 2 - 0.35, wall - 0.28), (0, wall + roof + 0.06), (width / 2 + 0.35, wall - 0.28), (width / 2 + 0.35, wall - 0.1), (0, wall + roof + 0.26), (-width / 2 - 0.35, wall - 0.1)]
    stage.put(upright("House roof", eaves, -0.35, depth + 0.35), stage.material("Far roof", ROOF), location, turn)


def church(location):
    """A round tower with a dome and a lantern on the skyline."""
    far, roof = stage.material("Far plaster", FAR), stage.material("Far roof", ROOF)
    drum = [(3, 0), (3, 10), (3.3, 10.1), (3.3, 10.6), (2.8, 10.7), (2.8, 13), (3.1, 13.2), (3.1, 13.6), (0, 13.6)]
    niches = [shapes.moved(upright("Niche", arch(1.0, 11.1, 12.1), -4, -2.6), turn=(0, 0, math.radians(k * 36))) for k in range(10)]
    stage.put(combine("DIFFERENCE", revolve("Drum", [(0, 0), *drum], 96), *niches), far, location)
    angle = np.linspace(0, math.pi / 2 - 0.2, 24)
    dome = [(0, 13.6), *zip(2.8 * np.cos(angle), 13.6 + 3.1 * np.sin(angle)), (0, 13.6 + 3.1 * math.sin(angle[-1]))]
    stage.put(revolve("Dome", dome, 96), roof, location)
    z = dome[-1][1]
    lantern = [(0, z), (0.5, z), (0.5, z + 1), (0.62, z + 1.05), (0.62, z + 1.2), *smooth([(0.5, z + 1.2), (0.4, z + 1.6), (0.05, z + 1.9)], 5), (0.04, z + 3), (0, z + 3)]
    stage.put(revolve("Lantern", lantern, 48), far, location)
