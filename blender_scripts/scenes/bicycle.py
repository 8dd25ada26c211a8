"""A roadster with a basket, along x, its front towards +x, standing on z = 0."""

import math

import numpy as np

from . import shapes, stage
from .shapes import moved, revolve, smooth, sweep

WHEEL = 0.335  # radius of the tyre's middle
BACK, FRONT, HUB = -0.52, 0.52, 0.355
IRON = (0.13, 0.14, 0.15)
ENAMEL = (0.2, 0.42, 0.45)
WICKER = (0.62, 0.45, 0.26)
LEATHER = (0.4, 0.22, 0.12)


def tube(points, radius, sides: int = 20):
    return sweep("Tube", points, radius, sides)


def ring(radius: float, thick: float, segments: int = 96):
    """A torus around y."""
    turn = np.linspace(0, 2 * math.pi, 21)
    return moved(revolve("Ring", np.stack([radius + thick * np.cos(turn), thick * np.sin(turn)], axis=1), segments), turn=(math.pi / 2, 0, 0))


def wheel(x: float):
    """Tyre, rim and hub; spokes are single slivers, so thin that their two edges draw one line."""
    spokes = 14
    angle = np.arange(spokes) * 2 * math.pi / spokes
    foot, tip = 0.024, WHEEL - 0.024
    skew = angle + np.where(np.arange(spokes) % 2, 0.9, -0.9)
    points = np.stack([
        np.stack([foot * np.cos(skew - 0.05), np.full(spokes, 0.02), foot * np.sin(skew - 0.05)], axis=1),
        np.stack([foot * np.cos(skew + 0.05), np.full(spokes, 0.02), foot * np.sin(skew + 0.05)], axis=1),
        np.stack([tip * np.cos(angle), np.zeros(spokes), tip * np.sin(angle)], axis=1)], axis=1)
    slivers = shapes.mesh("Spokes", points.reshape(-1, 3), np.arange(spokes * 3).reshape(-1, 3))
    hub = moved(revolve("Hub", [(0, -0.05), (0.012, -0.05), (0.012, -0.03), (0.028, -0.03), (0.028, -0.022), (0.014, -0.02), (0.014, 0.02), (0.028, 0.022), (0.028, 0.03), (0.012, 0.03), (0.012, 0.05), (0, 0.05)], 32), turn=(math.pi / 2, 0, 0))
    return [moved(part, (x, 0, HUB)) for part in (ring(WHEEL, 0.02), ring(WHEEL - 0.03, 0.008), hub, slivers)]


def guard(x: float, start: float, stop: float):
    """A mudguard: a strip curved across."""
    angle = np.radians(np.linspace(start, stop, 40))
    rows = []
    for across in np.linspace(-1, 1, 7):
        radius = WHEEL + 0.04 - 0.012 * across * across
        rows.append(np.stack([x + radius * np.cos(angle), np.full_like(angle, 0.03 * across), HUB + radius * np.sin(angle)], axis=1))
    return shapes.sheet("Mudguard", rows)


def saddle():
    x = np.linspace(-1, 1, 17)
    half = np.interp(x, [-1, -0.75, -0.2, 0.4, 1], [0.05, 0.085, 0.06, 0.022, 0.014])
    turn = np.linspace(0, 2 * math.pi, 25)[:-1]
    rows = [np.stack([np.full_like(turn, 0.13 * a), h * np.cos(turn), 0.028 * np.sin(turn) * (1 - 0.4 * (np.sin(turn) < 0)) + 0.012 * a * a], axis=1) for a, h in zip(x, half)]
    rows = [rows[0].mean(axis=0) + 0 * rows[0], *rows, rows[-1].mean(axis=0) + 0 * rows[-1]]
    return shapes.sheet("Saddle", rows, wrap_columns=True)


def basket():
    """A wicker basket: hoops and stakes."""
    parts = []
    for z, r in ((0, 0.105), (0.075, 0.12), (0.15, 0.135), (0.22, 0.15)):
        parts.append(moved(ring(r, 0.013 if z == 0.22 else 0.009, 64), (0, 0, z), (math.pi / 2, 0, 0)))
    for k in range(10):
        a = 2 * math.pi * k / 10
        parts.append(tube([(0.103 * math.cos(a), 0.103 * math.sin(a), 0), (0.15 * math.cos(a), 0.15 * math.sin(a), 0.22)], 0.005, 14))
    return parts


def bicycle(location, turn: float, lean: float = 0.0):
    """`lean`: degrees towards its left, +y."""
    crank, seat, head, fork = np.array([-0.06, 0, 0.3]), np.array([-0.24, 0, 0.8]), np.array([0.36, 0, 0.84]), np.array([0.39, 0, 0.68])
    steel = [tube([crank, seat], 0.016), tube([fork, head], 0.02), tube(smooth([fork, (0.16, 0, 0.46), crank], 8), 0.017),
             tube(smooth([head - (0, 0, 0.05), (0.14, 0, 0.6), (-0.13, 0, 0.5)], 8), 0.016)]
    for side in (-1, 1):
        steel.append(tube([(BACK, side * 0.055, HUB), crank + (0, side * 0.03, 0)], 0.01))
        steel.append(tube([(BACK, side * 0.055, HUB), seat + (0.035, side * 0.016, -0.1)], 0.009))
        steel.append(tube(smooth([(FRONT, side * 0.055, HUB), (0.45, side * 0.055, 0.56), (0.4, side * 0.04, 0.69)], 6), 0.011))
    steel += [guard(BACK, 20, 175), guard(FRONT, 35, 190)]
    bar = smooth([(0.1, -0.27, 0.98), (0.24, -0.26, 0.99), (0.34, -0.16, 0.96), (0.36, 0, 0.93), (0.34, 0.16, 0.96), (0.24, 0.26, 0.99), (0.1, 0.27, 0.98)], 8)
    iron = wheel(BACK) + wheel(FRONT) + [tube(bar, 0.011), tube([head, (0.36, 0, 0.93)], 0.012), tube([seat, seat + (-0.02, 0, 0.09)], 0.012)]
    iron += [moved(ring(0.085, 0.007, 64), crank - (0, 0.045, 0)), moved(ring(0.02, 0.009, 32), crank - (0, 0.045, 0))]
    for sign in (-1, 1):
        end = crank + np.array([sign * 0.12, sign * 0.0, sign * -0.12])
        iron.append(tube([crank + (0, sign * 0.06, 0), end + (0, sign * 0.06, 0)], 0.009))
        iron.append(moved(shapes.box("Pedal", (0.09, 0.09, 0.02), rounding=0.004), end + (0, sign * 0.115, -0.01)))
    groups = [("Bicycle", steel, ENAMEL), ("Bicycle iron", iron, IRON),
              ("Saddle", [moved(saddle(), seat + (-0.03, 0, 0.115))], LEATHER), ("Basket", [moved(part, (0.6, 0, 0.78)) for part in basket()], WICKER)]
    for name, parts, colour in groups:
        shape = moved(shapes.joined(name, parts), turn=(math.radians(-lean), 0, 0))
        shape.shade_smooth()
        shape.set_sharp_from_angle(angle=shapes.CREASE)
        stage.put(shape, stage.material(name, colour), location, turn)
