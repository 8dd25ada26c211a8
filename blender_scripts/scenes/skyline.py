# SPDX-License-Identifier: GPL-3.0-or-later
"""The background: gabled houses, a round church tower."""

import math

import numpy as np

from . import shapes
from .place import put
from .shapes import arch, combine, revolve, smooth, upright
from .solid import Solid


def house(location, turn: float, width: float, wall: float, roof: float, depth: float = 6.0):
    """Adds a house with its gable towards -y; three windows on each of two floors are shallow niches."""
    half, ridge = width / 2, wall + roof
    body = upright("House", [(-half, 0), (half, 0), (half, wall), (0, ridge), (-half, wall)], 0, depth)
    niches = Solid()
    for k in (-1, 0, 1):
        for floor in (0, 1):
            x, z = k * width / 3, wall * (floor + 0.35) / 2
            niches.add((x - 0.35, x + 0.35), (-0.3, 0.15), (z, z + 1.15))
    put(combine("DIFFERENCE", body, niches.mesh("Niches")), "far plaster", location, turn)
    out, low = half + 0.35, wall - 0.28
    under = [(-out, low), (0, ridge + 0.06), (out, low)]
    over = [(out, low + 0.18), (0, ridge + 0.26), (-out, low + 0.18)]
    put(upright("House roof", under + over, -0.35, depth + 0.35), "far roof", location, turn)


def church(location):
    """A drum with blind arches, a dome, a lantern."""
    drum = [
        (0, 0),
        (3, 0),
        (3, 10),
        (3.3, 10.1),
        (3.3, 10.6),
        (2.8, 10.7),
        (2.8, 13),
        (3.1, 13.2),
        (3.1, 13.6),
        (0, 13.6),
    ]
    niche = arch(1.0, 11.1, 12.1)
    niches = [shapes.moved(upright("Niche", niche, -4, -2.6), turn=(0, 0, k * math.pi / 5)) for k in range(10)]
    put(combine("DIFFERENCE", revolve("Drum", drum, 96), *niches), "far plaster", location)
    angle = np.linspace(0, math.pi / 2 - 0.2, 24)
    dome = [(0, 13.6), *zip(2.8 * np.cos(angle), 13.6 + 3.1 * np.sin(angle))]
    z = dome[-1][1]
    put(revolve("Dome", [*dome, (0, z)], 96), "far roof", location)
    cap = smooth([(0.5, z + 1.2), (0.4, z + 1.6), (0.05, z + 1.9)], 5)
    lantern = [(0, z), (0.5, z), (0.5, z + 1), (0.62, z + 1.05), (0.62, z + 1.2), *cap, (0.04, z + 3), (0, z + 3)]
    put(revolve("Lantern", lantern, 48), "far plaster", location)
