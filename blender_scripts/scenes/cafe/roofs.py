# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of tiles with round ends, on a cone and on a slope. Each row is an open sheet over the top of the one below."""

import math

import numpy as np

from .. import shapes
from ..place import pipe, put
from ..shapes import revolve, smooth
from ..solid import Solid
from .plan import CORNICE, EAVE, FRONT, LENGTH, PITCH, RADIUS, RIDGE

RIM = RADIUS + 0.38  # the cone's eave
TOP = 6.5  # its tip
EDGE = FRONT - 0.3  # the wing's eave in y


def build():
    cone()
    finial()
    slope()
    eaves()


def row(lower, upper, count: int, phase: float, thick):
    """Tiles between two curves, functions of u in [0, 1] that give points; `thick` lifts their lower ends."""
    u = np.linspace(0, 1, count * 8 + 1)
    round_end = 0.26 * (1 - np.sqrt(np.abs(np.cos(math.pi * (u * count + phase)))))[:, None]
    low, high = lower(u), upper(u)
    edge = low + (high - low) * round_end + thick
    return shapes.sheet("Row", [edge, (edge + high) / 2, high])


def cone():
    def radius(t):  # it flares out at the eave
        return RIM * (1 - t) ** 1.12

    def ring(t):
        angles, z = 2 * math.pi, CORNICE + (TOP - CORNICE) * t
        r = radius(t)
        return lambda u: np.stack([r * np.cos(angles * u), r * np.sin(angles * u), np.full_like(u, z)], axis=1)

    rows, lift = 12, np.array([0, 0, 0.022])
    tiles = []
    for k in range(rows):
        count = 44 if k < 6 else 22 if k < 11 else 11
        tiles.append(row(ring(k / rows), ring(min((k + 2) / rows, 0.985)), count, k % 2 / 2, lift))
    put(shapes.joined("Cone", tiles), "tile")
    boards = [(radius(t) - 0.03, CORNICE - 0.01 + (TOP - CORNICE) * t) for t in np.linspace(0, 0.95, 16)]
    put(revolve("Cone boards", boards), "tile")
    under, over = CORNICE - 0.04, CORNICE + 0.02
    put(
        revolve("Soffit", [(RADIUS + 0.2, under), (RIM - 0.01, under), (RIM - 0.01, over), (RADIUS + 0.2, over)]),
        "trim",
    )


def finial():
    foot = [(0.13, 0), (0.075, 0.12), (0.05, 0.2), (0.05, 0.22)]
    knob = [(0.05, 0.22), (0.12, 0.29), (0.14, 0.38), (0.1, 0.47), (0.03, 0.51)]
    spike = [(0.03, 0.51), (0.025, 0.6), (0.005, 0.78), (0, 0.79)]
    profile = np.concatenate([smooth(part, 5) for part in (foot, knob, spike)])
    put(revolve("Finial", profile, 64), "iron", (0, 0, TOP - 0.16))


def height(y):
    """z of the wing's roof at y."""
    return EAVE + (y - EDGE) * PITCH


def slope():
    def line(y):
        return lambda u: np.stack([LENGTH * u, np.full_like(u, y), np.full_like(u, height(y))], axis=1)

    rows, lift = 8, np.array([0, -0.015, 0.025])
    step = (RIDGE - EDGE) / rows
    tiles = [row(line(EDGE + k * step), line(EDGE + (k + 2) * step), 52, k % 2 / 2, lift) for k in range(rows)]
    put(shapes.joined("Roof", tiles), "tile")
    gable = [(EDGE + 0.03, EAVE - 0.02), (RIDGE, height(RIDGE) - 0.04), (2 * RIDGE - EDGE, EAVE)]
    boards = shapes.moved(shapes.prism("Roof boards", gable, 0.8, LENGTH), turn=(math.pi / 2, 0, math.pi / 2))
    put(boards, "tile")
    pipe("Ridge", [(x, RIDGE, height(RIDGE) + 0.03) for x in (0.8, LENGTH)], 0.09, "tile")


def eaves():
    put(Solid().add((1.3, LENGTH), (EDGE + 0.02, FRONT), (EAVE - 0.16, EAVE - 0.02)).mesh("Eave"), "trim")
    pipe("Gutter", [(x, EDGE - 0.06, EAVE - 0.05) for x in (1.42, LENGTH)], 0.06, "iron")
    meeting = [(math.sqrt(RADIUS**2 - y * y) + 0.01, y, height(y) + 0.05) for y in np.linspace(EDGE + 0.32, RIDGE, 40)]
    pipe("Flashing", meeting, 0.05, "trim")  # where tiles meet the tower there is no edge: lead covers it
