# SPDX-License-Identifier: GPL-3.0-or-later
"""Plants: leaves in a pot, clipped balls, tree crowns."""

import math
import random

import numpy as np

from . import shapes
from .place import put
from .shapes import ball, revolve, smooth

GOLDEN = math.pi * (3 - math.sqrt(5))  # golden angle, radians


def leaf(length: float, width: float, rise: float, droop: float):
    """A leaf from the origin along +x, folded along its middle, so that the rib is a crease."""
    t = np.linspace(0, 1, 15)
    x = length * t * (1 - 0.15 * droop * t)
    z = length * (rise * t - droop * t * t)
    half = width * (np.sin(math.pi * np.clip(t, 0.0, 1) ** 0.8) * 0.5 + 0.02 * (1 - t))
    rows = [np.stack([x, side * half, z + 0.5 * half * abs(side)], axis=1) for side in (-1, 0, 1)]
    return shapes.sheet("Leaf", rows)


def rosette(name: str, count: int, length: float, width: float, seed: int, rise=(0.5, 1.3), droop=(0.5, 0.9)):
    """Leaves all around, the inner ones steeper."""
    draw = random.Random(seed)
    leaves = []
    for i in range(count):
        inner = i / count
        size = length * (1 - 0.35 * inner) * draw.uniform(0.85, 1.1)
        blade = leaf(
            size,
            width * draw.uniform(0.85, 1.1),
            rise[0] + (rise[1] - rise[0]) * inner,
            droop[1] + (droop[0] - droop[1]) * inner,
        )
        turn = i * GOLDEN + draw.uniform(-0.2, 0.2)
        leaves.append(shapes.moved(blade, (0.02 * math.cos(turn), 0.02 * math.sin(turn), 0), (0, 0, turn)))
    return shapes.joined(name, leaves)


def crown(name: str, radius: float, lumps: int, size: float, seed: int, segments: int):
    """Foliage as a cloud of balls with an average radius of `size` times `radius`. The balls intersect without edges,
    so that only their visible outlines are drawn."""
    draw = random.Random(seed)
    balls = [ball("Ball", radius * 0.8, segments)]
    for i in range(lumps):
        z = 1 - 2 * (i + 0.5) / lumps
        around, out = i * GOLDEN, math.sqrt(1 - z * z)
        r = size * draw.uniform(0.7, 1.25)
        place = (
            radius * (1 - r) * draw.uniform(0.95, 1.12) * np.array([out * math.cos(around), out * math.sin(around), z])
        )
        balls.append(
            shapes.moved(ball("Ball", radius * r, segments), place, (draw.uniform(0, 6), draw.uniform(0, 6), 0))
        )
    return shapes.joined(name, balls)


def pot(location, size: float, tall: float = 1.0):
    """A clay pot with a rim, filled with soil; returns the height of the soil."""
    h, r = size * tall, size * 0.5
    outside = [
        (0, 0),
        (r * 0.68, 0),
        (r * 0.72, 0.02 * h),
        (r * 0.93, 0.78 * h),
        (r * 1.06, 0.78 * h),
        (r * 1.1, h),
        (r * 0.97, h),
    ]
    put(revolve("Pot", [*outside, (r * 0.92, 0.9 * h), (0, 0.9 * h)]), "clay", location)
    return location[2] + 0.9 * h


def potted(
    location,
    size: float,
    seed: int,
    leaves: int = 22,
    length: float = 1.5,
    width: float = 0.28,
    tall: float = 1.0,
    **habit,
):
    soil = pot(location, size, tall)
    made = rosette("Leaves", leaves, size * length, size * width, seed, **habit)
    put(made, "leaf", (*location[:2], soil + 0.005))


def clipped(location, size: float, seed: int):
    """A ball of box on a stem."""
    soil = pot(location, size, 0.85)
    stem = shapes.sweep("Stem", smooth([(0, 0, 0), (0.01, 0.01, size * 0.5), (0, 0, size * 1.3)], 6), size * 0.05, 16)
    put(stem, "bark", (*location[:2], soil))
    leaves = crown("Clipped ball", size * 0.62, 44, 0.26, seed, 20)
    put(leaves, "leaf", (*location[:2], soil + size * 1.55))


def tree(location, height: float, radius: float, seed: int, segments: int = 36):
    trunk = smooth([(0, 0, 0), (0.05, 0, height * 0.3), (-0.04, 0.05, height * 0.6), (0, 0, height)], 8)
    put(shapes.sweep("Trunk", trunk, np.linspace(0.24, 0.12, len(trunk)) * radius / 2, 24), "bark", location)
    leaves = crown("Crown", radius, 40, 0.32, seed, segments)
    put(leaves, "leaf", (*location[:2], location[2] + height + radius * 0.45))
