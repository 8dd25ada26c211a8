# SPDX-License-Identifier: GPL-3.0-or-later
"""The square before the cafe: garden wall and gate, a lamp, a few stones of the paving."""

import math
import random

import numpy as np

from . import shapes
from .place import pipe, put
from .shapes import arch, combine, revolve, smooth, upright
from .solid import Solid


def ground():
    sheet = shapes.mesh("Ground", [(-60, -40, 0), (60, -40, 0), (60, 90, 0), (-60, 90, 0)], [[0, 1, 2, 3]])
    put(sheet, "ground")


def garden_wall(location, turn: float, length: float):
    """From `location` along local +x; an arched gate a little way along, a coping on top."""
    wall, along, gate = Solid(), (-0.6, length), 2.2
    for across, height in ((0.16, (0, 2.1)), (0.2, (0, 0.35)), (0.22, (2.1, 2.2))):
        wall.add(along, (-across, across), height)
    wall.add((gate - 1.1, gate + 1.1), (-0.24, 0.24), (0, 2.62))
    wall.add((gate - 1.18, gate + 1.18), (-0.32, 0.32), (2.62, 2.74))
    hole = shapes.moved(upright("Hole", arch(1.4, -1, 1.6), -1, 1), (gate, 0, 0))
    put(combine("DIFFERENCE", wall.mesh("Garden wall"), hole), "plaster", location, turn)
    for x in np.linspace(-0.6, 0.6, 9):
        bar = [(gate + x, 0, 0.08), (gate + x, 0, 1.58 + math.sqrt(0.66**2 - x * x))]
        pipe("Gate bar", bar, 0.011, "iron", location=location, turn=turn)
    for z in (0.14, 1.1, 1.6):
        rail = [(gate - 0.67, -0.02, z), (gate + 0.67, -0.02, z)]
        pipe("Gate rail", rail, 0.016, "iron", location=location, turn=turn)


def lamp(location, height: float = 3.3):
    """A globe on a cast post."""
    foot = [(0, 0), (0.17, 0), (0.17, 0.1), *smooth([(0.15, 0.12), (0.13, 0.2), (0.12, 0.5), (0.08, 0.62)], 5)]
    collar = [(0.1, 0.64), (0.1, 0.69), (0.055, 0.72)]
    knot = smooth([(0.042, height - 0.5), (0.09, height - 0.44), (0.05, height - 0.38)], 5)
    neck = [(0.038, height - 0.36), *smooth([(0.035, height - 0.16), (0.06, height - 0.06), (0.12, height)], 5)]
    plate = height + 0.035
    post = [*foot, *collar, *knot, *neck, (0.12, plate), (0, plate)]
    put(revolve("Lamp post", post, 64), "iron", location)
    radius, angle = 0.24, np.linspace(-1.05, 1.32, 40)
    bowl = np.stack([radius * np.cos(angle), plate + 0.001 + radius * (np.sin(angle) - math.sin(angle[0]))], axis=1)
    top = bowl[-1, 1]
    put(revolve("Globe", [(0, bowl[0, 1]), *bowl, (0, top)], 96), "glass", location)
    spike = smooth([(0.07, top + 0.03), (0.03, top + 0.05), (0.015, top + 0.1), (0, top + 0.15)], 5)
    put(revolve("Lamp cap", [(0, top + 0.001), (0.08, top + 0.001), *spike], 64), "iron", location)


def manhole(location):
    rim = [(0.34, 0.004), (0.34, 0.012), (0.3, 0.012), (0.3, 0.008), (0.27, 0.008), (0.27, 0.012)]
    put(revolve("Manhole", [(0, 0.004), *rim, (0, 0.012)], 96), "iron", location)


def setts(name: str, places, location=(0, 0, 0), turn: float = 0.0):
    """Adds stones at (x, y, rotation, size): open shells with rounded tops, so that each draws a single outline."""
    angle = np.linspace(0, 2 * math.pi, 20, endpoint=False)
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    stone = np.sign(circle) * np.sqrt(np.abs(circle)) * (0.092, 0.07)  # half way to a rectangle
    profile = [(1.0, 0.0), (0.98, 0.4), (0.9, 0.7), (0.72, 0.9), (0.4, 0.98), (0.0, 1.0)]
    stones = []
    for x, y, spin, size in places:
        turned = np.array([[math.cos(spin), math.sin(spin)], [-math.sin(spin), math.cos(spin)]])
        rings = [np.insert(stone @ turned * size * r + (x, y), 2, 0.003 + 0.022 * h, axis=1) for r, h in profile]
        stones.append(shapes.sheet("Sett", rings, wrap_columns=True))
    put(shapes.joined(name, stones), "stone", location, turn)


def cobbles(center, turn: float, rows: int, columns: int, seed: int):
    """A patch of setts laid in arcs, thinning out from its middle."""
    draw, places = random.Random(seed), []
    for row in range(rows):
        for column in range(columns):
            u, v = (column + 0.5 * (row % 2)) / columns * 2 - 1, row / max(rows - 1, 1) * 2 - 1
            if draw.random() < u * u + v * v:
                continue
            x, y = u * columns * 0.105, v * rows * 0.085 + 0.3 * u * u
            spin = math.atan(0.6 * u / columns / 0.105) + draw.uniform(-0.06, 0.06)
            x, y = x + draw.uniform(-0.008, 0.008), y + draw.uniform(-0.008, 0.008)
            places.append((x, y, spin, draw.uniform(0.88, 1.04)))
    setts("Cobbles", places, center, turn)


def edging(path, seed: int):
    """One row of setts along a path, with random gaps."""
    draw, path = random.Random(seed), np.asarray(path, dtype=float)
    steps = np.diff(path, axis=0)
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(steps, axis=1))])
    places, at, left = [], 0.0, 12
    while at < length[-1]:
        dx, dy = steps[np.searchsorted(length, at, side="right") - 1]
        spin = math.atan2(dy, dx) + draw.uniform(-0.05, 0.05)
        places.append((*(np.interp(at, length, path[:, k]) for k in (0, 1)), spin, draw.uniform(1.2, 1.4)))
        left -= 1
        at += 0.27 if left else draw.uniform(0.5, 2.2)
        left = left or draw.randint(5, 16)
    setts("Edging", places)
