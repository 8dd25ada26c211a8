# SPDX-License-Identifier: GPL-3.0-or-later
"""Straight stairs, and railings along them and around the holes in the slabs."""

import math

import numpy as np

from ..place import pipe, put
from ..solid import Solid
from .plan import FLOORS, GOING, HEIGHT, RISERS, level


def build():
    for k, floor in enumerate(FLOORS):
        for x, y0, y1 in floor.flights:
            flight(x, y0, y1, level(k))
        for x0, x1, y0, y1 in floor.openings:
            around = [(x0 - 0.06, y1 + 0.06), (x1 + 0.06, y1 + 0.06), (x1 + 0.06, y0 - 0.06), (x0 - 0.06, y0 - 0.06)]
            for a, b in zip(around[:-1], around[1:]):  # no railing on the side of the stairs
                rail((*a, level(k)), (*b, level(k)), 0.95, max(2, round(math.dist(a, b) / 0.5)))


def flight(x: float, y0: float, y1: float, z: float):
    """A flight of stairs from x, rising towards -x."""
    rise, steps = HEIGHT / RISERS, Solid()
    for k in range(RISERS - 1):
        under = z + max(0, rise * (k - 1))
        steps.add((x - GOING * (k + 1), x - GOING * k), (y0 + 0.03, y1 - 0.03), (under, z + rise * (k + 1)))
    put(steps.mesh("Stairs"), "stone")
    foot, head = (x - GOING / 2, y0 + 0.06, z + rise), (x - GOING * (RISERS - 1.5), y0 + 0.06, z + rise * (RISERS - 1))
    rail(foot, head, 0.92, 6)


def rail(start, end, height: float, posts: int):
    """A handrail on posts between two points."""
    a, b, up = np.array(start), np.array(end), np.array([0, 0, height])
    pipe("Handrail", [a + up, b + up], 0.022, "iron")
    pipe("Rail", [a + up / 2, b + up / 2], 0.012, "iron")
    for t in np.linspace(0, 1, posts):
        foot = a + (b - a) * t
        pipe("Post", [foot, foot + up - (0, 0, 0.022)], 0.014, "iron")
