# SPDX-License-Identifier: GPL-3.0-or-later
"""A roadster with a basket, along x, its front towards +x, standing on z = 0."""

import math

import numpy as np

from . import shapes
from .place import put
from .shapes import moved, revolve, smooth, sweep

WHEEL = 0.335  # radius of the tyre's middle
BACK, FRONT, HUB = -0.52, 0.52, 0.355  # x of the wheels, z of their hubs
CRANK, SEAT = np.array([-0.06, 0, 0.3]), np.array([-0.24, 0, 0.8])  # where the frame's tubes meet
HEAD, FORK = np.array([0.36, 0, 0.84]), np.array([0.39, 0, 0.68])


def tube(points, radius, sides: int = 20):
    return sweep("Tube", points, radius, sides)


def ring(radius: float, thick: float, segments: int = 96):
    """A torus around y."""
    turn = np.linspace(0, 2 * math.pi, 21)
    return moved(
        revolve("Ring", np.stack([radius + thick * np.cos(turn), thick * np.sin(turn)], axis=1), segments),
        turn=(math.pi / 2, 0, 0),
    )


def wheel(x: float):
    """Tyre, rim and hub; spokes are single slivers, so thin that their two edges draw one line."""
    spokes = 14
    angle = np.arange(spokes) * 2 * math.pi / spokes
    foot, tip = 0.024, WHEEL - 0.024
    skew = angle + np.where(np.arange(spokes) % 2, 0.9, -0.9)
    points = np.stack(
        [
            np.stack([foot * np.cos(skew - 0.05), np.full(spokes, 0.02), foot * np.sin(skew - 0.05)], axis=1),
            np.stack([foot * np.cos(skew + 0.05), np.full(spokes, 0.02), foot * np.sin(skew + 0.05)], axis=1),
            np.stack([tip * np.cos(angle), np.zeros(spokes), tip * np.sin(angle)], axis=1),
        ],
        axis=1,
    )
    slivers = shapes.mesh("Spokes", points.reshape(-1, 3), np.arange(spokes * 3).reshape(-1, 3))
    hub = moved(
        revolve(
            "Hub",
            [
                (0, -0.05),
                (0.012, -0.05),
                (0.012, -0.03),
                (0.028, -0.03),
                (0.028, -0.022),
                (0.014, -0.02),
                (0.014, 0.02),
                (0.028, 0.022),
                (0.028, 0.03),
                (0.012, 0.03),
                (0.012, 0.05),
                (0, 0.05),
            ],
            32,
        ),
        turn=(math.pi / 2, 0, 0),
    )
    return [moved(part, (x, 0, HUB)) for part in (ring(WHEEL, 0.02), ring(WHEEL - 0.03, 0.008), hub, slivers)]


def guard(x: float, start: float, stop: float):
    """A mudguard: a strip curved across."""
    angle = np.radians(np.linspace(start, stop, 40))
    rows = []
    for across in np.linspace(-1, 1, 7):
        radius = WHEEL + 0.04 - 0.012 * across * across
        rows.append(
            np.stack(
                [x + radius * np.cos(angle), np.full_like(angle, 0.03 * across), HUB + radius * np.sin(angle)], axis=1
            )
        )
    return shapes.sheet("Mudguard", rows)


def saddle():
    x = np.linspace(-1, 1, 17)
    half = np.interp(x, [-1, -0.75, -0.2, 0.4, 1], [0.05, 0.085, 0.06, 0.022, 0.014])
    turn = np.linspace(0, 2 * math.pi, 25)[:-1]
    rows = [
        np.stack(
            [
                np.full_like(turn, 0.13 * a),
                h * np.cos(turn),
                0.028 * np.sin(turn) * (1 - 0.4 * (np.sin(turn) < 0)) + 0.012 * a * a,
            ],
            axis=1,
        )
        for a, h in zip(x, half)
    ]
    rows = [rows[0].mean(axis=0) + 0 * rows[0], *rows, rows[-1].mean(axis=0) + 0 * rows[-1]]
    return shapes.sheet("Saddle", rows, wrap_columns=True)


def basket():
    """A wicker basket: hoops and stakes."""
    parts = []
    for z, r in ((0, 0.105), (0.075, 0.12), (0.15, 0.135), (0.22, 0.15)):
        parts.append(moved(ring(r, 0.013 if z == 0.22 else 0.009, 64), (0, 0, z), (math.pi / 2, 0, 0)))
    for k in range(10):
        a = 2 * math.pi * k / 10
        parts.append(
            tube(
                [(0.103 * math.cos(a), 0.103 * math.sin(a), 0), (0.15 * math.cos(a), 0.15 * math.sin(a), 0.22)],
                0.005,
                14,
            )
        )
    return parts


def frame():
    """Tubes, fork and mudguards."""
    low = smooth([FORK, (0.16, 0, 0.46), CRANK], 8)
    bow = smooth([HEAD - (0, 0, 0.05), (0.14, 0, 0.6), (-0.13, 0, 0.5)], 8)
    parts = [tube([CRANK, SEAT], 0.016), tube([FORK, HEAD], 0.02), tube(low, 0.017), tube(bow, 0.016)]
    for y in (-0.055, 0.055):
        parts.append(tube([(BACK, y, HUB), CRANK + (0, 0.55 * y, 0)], 0.01))
        parts.append(tube([(BACK, y, HUB), SEAT + (0.035, 0.3 * y, -0.1)], 0.009))
        parts.append(tube(smooth([(FRONT, y, HUB), (0.45, y, 0.56), (0.4, 0.7 * y, 0.69)], 6), 0.011))
    return [*parts, guard(BACK, 20, 175), guard(FRONT, 35, 190)]


def drive():
    """Chainring, cranks and pedals."""
    hub = CRANK - (0, 0.045, 0)
    parts = [moved(ring(0.085, 0.007, 64), hub), moved(ring(0.02, 0.009, 32), hub)]
    for side in (-1, 1):
        start, end = CRANK + (0, 0.06 * side, 0), CRANK + (0.12 * side, 0.06 * side, -0.12 * side)
        pedal = shapes.box("Pedal", (0.09, 0.09, 0.02), rounding=0.004)
        parts += [tube([start, end], 0.009), moved(pedal, end + (0, 0.055 * side, -0.01))]
    return parts


def steering():
    half = [(0.1, -0.27, 0.98), (0.24, -0.26, 0.99), (0.34, -0.16, 0.96)]
    bar = smooth([*half, (0.36, 0, 0.93), *((x, -y, z) for x, y, z in half[::-1])], 8)
    return [tube(bar, 0.011), tube([HEAD, (0.36, 0, 0.93)], 0.012)]


def bicycle(location, turn: float, lean: float = 0.0):
    """`lean`: degrees towards its left, +y."""
    post = tube([SEAT, SEAT + (-0.02, 0, 0.09)], 0.012)
    groups = [
        ("Bicycle", "enamel", frame()),
        ("Wheels", "iron", [*wheel(BACK), *wheel(FRONT), *drive(), *steering(), post]),
        ("Saddle", "leather", [moved(saddle(), SEAT + (-0.03, 0, 0.115))]),
        ("Basket", "wicker", [moved(part, (0.6, 0, 0.78)) for part in basket()]),
    ]
    for name, paint, parts in groups:
        shape = moved(shapes.joined(name, parts), turn=(math.radians(-lean), 0, 0))
        shape.shade_smooth()
        shape.set_sharp_from_angle(angle=shapes.CREASE)
        put(shape, paint, location, turn)
