# SPDX-License-Identifier: GPL-3.0-or-later
"""Awning, signs, and the interior visible through the shop window."""

import math

import numpy as np

from .. import shapes
from ..palette import paint
from ..place import lettering, pipe, put
from ..shapes import revolve, smooth
from ..solid import Solid
from .plan import DOOR, FRONT, RADIUS, SHOP


def build():
    awning()
    lettering("Sign", "Café Fovea", 0.5, "gilt", ((SHOP[0] + SHOP[1]) / 2, FRONT - 0.005, 3.07))
    hanging_sign(DOOR - 82)
    inside()


def awning():
    """A quarter round of striped cloth with a scalloped edge."""
    x0, x1, stripes, steps = SHOP[0] - 0.3, SHOP[1] + 0.3, 18, 12
    top, out, fall = 2.75, 1.15, 0.5
    u = np.linspace(0, 1, stripes * steps + 1)
    x, flat = x0 + (x1 - x0) * u, np.ones_like(u)
    rows = []
    for t in np.linspace(0, math.pi / 2, 14):
        y, z = FRONT - 0.02 - out * math.sin(t), top - fall * (1 - math.cos(t))
        rows.append(np.stack([x, y * flat, z * flat], axis=1))
    hang = 0.1 + 0.1 * np.sqrt(np.abs(np.sin(math.pi * u * stripes)))
    lowest = rows[-1]
    rows += [lowest - np.outer(share * hang, (0, 0, 1)) for share in (0.5, 1)]
    cloth = shapes.sheet("Awning", rows)
    for name in ("stripe", "cloth"):
        cloth.materials.append(paint(name))
    stripe = np.arange(stripes * steps) // steps % 2
    cloth.polygons.foreach_set("material_index", np.tile(stripe, len(rows) - 1).astype(np.int32))
    put(cloth, None)
    put(Solid().add((x0, x1), (FRONT - 0.07, FRONT), (top, top + 0.07)).mesh("Awning box"), "joinery")


def hanging_sign(angle: float):
    """A round board on a bracket at the tower's side."""
    out = np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle))])

    def at(beyond, z):
        return (*((RADIUS + beyond) * out), z)

    pipe("Bracket", [at(0, 3.1), at(1.0, 3.1)], 0.016, "iron")
    turn = np.linspace(0, 3.5 * math.pi, 20)
    curl = 0.11 * np.exp(-turn / 6)
    scroll = [at(0.2 + c * math.sin(t + 2.6), 2.95 + c * math.cos(t + 2.6)) for c, t in zip(curl, turn)]
    pipe("Scroll", smooth([at(0.02, 2.72), at(0.06, 2.8), *scroll], 6), 0.011, "iron")
    for side in (-0.18, 0.18):
        pipe("Hook", [at(0.66 + side, 3.085), at(0.66 + side, 2.93)], 0.007, "iron")
    edge = smooth([(0.34, -0.03), (0.36, 0), (0.34, 0.03)], 4)
    disc = revolve("Sign board", [(0, -0.03), *edge, (0.3, 0.03), (0.3, 0.018), (0, 0.018)], 96)
    middle = np.array(at(0.66, 2.63))
    put(shapes.moved(disc, middle, (math.pi / 2, 0, math.radians(angle + 180))), "joinery")
    face = np.array([-out[1], out[0], 0])
    lettering("Tea", "Thé", 0.32, "gilt", middle + 0.023 * face, angle + 180)


def inside():
    """Lamps, a counter, cakes under glass."""
    x0, x1, z0, z1 = SHOP
    shade = smooth([(0.02, 0.24), (0.05, 0.2), (0.14, 0.12), (0.2, 0.02), (0.2, 0)], 6)
    for k in range(3):
        x = x0 + (x1 - x0) * (k + 0.8) / 3.2
        put(revolve("Shade", [(0, 0.24), *shade, (0.185, 0), (0, 0.15)], 64), "china", (x, 0.1, 1.82))
        pipe("Flex", [(x, 0.1, 2.06), (x, 0.1, z1)], 0.008, "iron")
    counter = Solid().add((x0 + 0.5, x1), (0.5, 0.95), (z0, z0 + 0.32))
    put(counter.add((x0 + 0.45, x1), (0.45, 1.0), (z0 + 0.32, z0 + 0.37)).mesh("Counter"), "joinery")
    stem = smooth([(0.07, 0.01), (0.02, 0.04), (0.02, 0.1)], 5)
    stand = revolve("Cake stand", [(0, 0), (0.07, 0), *stem, (0.15, 0.11), (0.15, 0.125), (0, 0.125)], 64)
    angle = np.linspace(0, math.pi / 2, 17)
    knob = smooth([(0.012, 0.171), (0.02, 0.185), (0.012, 0.2), (0, 0.203)], 4)
    bell = [(0, 0), (0.13, 0), *zip(0.13 * np.cos(angle), 0.05 + 0.12 * np.sin(angle)), *knob]
    bell = revolve("Glass bell", bell, 64)
    for x in (x0 + 1.15, x0 + 2.5):
        put(stand, "china", (x, 0.7, z0 + 0.371))
        put(bell, "glass", (x, 0.7, z0 + 0.497))
