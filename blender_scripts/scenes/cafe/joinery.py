# SPDX-License-Identifier: GPL-3.0-or-later
"""Door and windows, each GAP smaller than its opening on every side, so that it has an outline of its own."""

import math

import numpy as np

from .. import shapes
from ..place import put
from ..shapes import arch, box, combine, revolve, smooth, upright
from ..solid import Solid, bars
from .plan import DOOR, FRONT, OCULI, OCULUS, RADIUS, SHOP, SILL, WINDOWS, radial

INSET = RADIUS - 0.16  # where frames stand in the wall
GAP = 0.003


def build():
    door()
    for angle in WINDOWS:
        window(angle)
    for angle in OCULI:
        oculus(angle)
    x0, x1, z0, z1 = SHOP
    frame = bars(x1 - x0 - 2 * GAP, z1 - z0 - 2 * GAP, 4, 1, 0.08, 0.1, 0.05)
    frame.add((0.05, x1 - x0 - 0.05), (-0.03, 0.03), (1.18, 1.23))
    put(frame.mesh("Shop window"), "joinery", (x0 + GAP, FRONT + 0.12, z0 + GAP))


def arched(name: str, width: float, base: float, spring: float, bar: float):
    """The frame of an opening with a round head: around it, across at the spring, a fan above."""
    outline = arch(width - 2 * GAP, base + GAP, spring)
    middle = np.array([0, (outline[0, 1] + outline[:, 1].max()) / 2])
    half = np.abs(outline - middle).max(axis=0)
    hole = upright("Hole", (outline - middle) * (1 - bar / half) + middle, -1, 1)
    parts = [combine("DIFFERENCE", upright("Frame", outline, 0, 0.08), hole)]
    for turn in np.radians([-45, 0, 45]):
        spoke = box("Spoke", (0.03, 0.04, (width - bar) / 2), (0, 0.05, 0))
        parts.append(shapes.moved(spoke, (0, 0, spring), (0, turn, 0)))
    parts.append(box("Rail", (width - 2 * bar, 0.06, 0.08), (0, 0.04, spring - 0.05)))
    return shapes.joined(name, parts)


def door():
    put(radial(arched("Door frame", 1.3, SILL, 2.1, 0.07), DOOR, INSET), "joinery")
    for side in (-1, 1):
        leaf = Solid().add((0, 0.565), (0.02, 0.07), (0, 1.58)).cut((0.09, 0.475), (0, 0.1), (0.62, 1.48))
        leaf.cut((0.1, 0.465), (0, 0.04), (0.12, 0.5)).add((0.15, 0.415), (0.03, 0.05), (0.17, 0.45))
        leaf.add((0.27, 0.295), (0.03, 0.06), (0.62, 1.48)).add((0.09, 0.475), (0.03, 0.06), (1.04, 1.065))
        shape = shapes.moved(leaf.mesh("Door leaf"), (0.005 if side > 0 else -0.57, 0, SILL + 0.01))
        put(radial(shape, DOOR, INSET), "joinery")
        turned = smooth([(0.012, 0.03), (0.03, 0.045), (0.02, 0.07), (0, 0.075)], 4)
        knob = revolve("Knob", [(0, 0), (0.012, 0), *turned], 24)
        knob = shapes.moved(knob, (side * 0.045, 0.02, SILL + 0.85), (math.pi / 2, 0, 0))
        put(radial(knob, DOOR, INSET), "iron")


def window(angle: float):
    put(radial(arched("Window frame", 0.72, 1.3, 2.15, 0.05), angle, INSET), "joinery")
    casement = shapes.moved(bars(0.616, 0.79, 2, 2, 0.03, 0.05).mesh("Casement"), (-0.308, 0.035, 1.305))
    put(radial(casement, angle, INSET), "joinery")
    blind = Solid().add((-0.33, 0.33), (0.12, 0.13), (1.31, 2.46)).mesh("Blind")  # the tower has no interior
    put(radial(blind, angle, INSET), "cloth")
    put(radial(Solid().add((-0.41, 0.41), (-0.11, 0.05), (1.2, 1.297)).mesh("Sill"), angle), "trim")


def oculus(angle: float):
    def outwards(shape, y):
        return shapes.moved(shape, (0, y, OCULUS), (math.pi / 2, 0, 0))

    rim = revolve("Oculus", [(0.3, 0), (0.37, 0), (0.37, 0.07), (0.3, 0.07), (0.3, 0)], 64)
    put(radial(outwards(rim, 0.02), angle), "trim")
    pane = revolve("Pane", [(0, 0), (0.266, 0), (0.266, 0.02), (0, 0.02)], 64)
    put(radial(outwards(pane, 0.02), angle, RADIUS - 0.12), "glass")
    cross = Solid().add((-0.265, 0.265), (0, 0.02), (-0.014, 0.014)).add((-0.014, 0.014), (0, 0.02), (-0.265, 0.265))
    put(radial(shapes.moved(cross.mesh("Cross"), (0, -0.02, OCULUS)), angle, RADIUS - 0.12), "joinery")
