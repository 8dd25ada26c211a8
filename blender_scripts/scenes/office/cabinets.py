# SPDX-License-Identifier: GPL-3.0-or-later
"""Simple furniture made of boxes, used where no model files are available."""

import numpy as np

from ..palette import paint as material
from ..solid import Solid


def painted(shape, paint: str):
    shape.materials.append(material(paint))
    return shape


def shelf(columns: int, rows: int, width: float, height: float, depth: float = 0.38):
    """Open shelves with books in some."""
    made, half, board = Solid(), depth / 2, 0.015  # half a board thick
    made.add((-width / 2, width / 2), (-half, half), (0, height))
    x = np.linspace(board - width / 2, width / 2 - board, columns + 1)
    z = np.linspace(board, height - board, rows + 1)
    draw = np.random.default_rng(columns * 10 + rows)
    for x0, x1 in zip(x[:-1] + board, x[1:] - board):
        for z0, z1 in zip(z[:-1] + board, z[1:] - board):
            made.cut((x0, x1), (-depth, half - 0.02), (z0, z1))
            at, end = x0, x0 + (x1 - x0) * draw.uniform(0, 0.95)
            while at < end - 0.06:
                thick, tall, front = draw.uniform((0.02, 0.55, 0.1), (0.05, 0.85, 0.3))
                made.add((at, at + thick), (-front * depth, half - 0.02), (z0, z0 + tall * (z1 - z0)))
                at += thick
    return painted(made.mesh("Shelf"), "oak")


def cabinet(width: float, depth: float, height: float, drawers: int, columns: int = 1, paint: str = "laminate"):
    """Drawers or doors with a gap around each and a bar to pull."""
    made, front = Solid(), -depth / 2
    made.add((-width / 2, width / 2), (front, -front), (0, height))
    x, z = np.linspace(-width / 2, width / 2, columns + 1), np.linspace(0.06, height, drawers + 1)
    for x0, x1 in zip(x[:-1], x[1:]):
        for z0, z1 in zip(z[:-1], z[1:]):
            middle = (x0 + x1) / 2
            made.add((x0 + 0.008, x1 - 0.008), (front - 0.018, front), (z0 + 0.006, z1 - 0.006))
            made.add((middle - 0.08, middle + 0.08), (front - 0.04, front - 0.018), (z1 - 0.08, z1 - 0.06))
    return painted(made.mesh("Cabinet"), paint)


def hutch():
    """A desk with drawers and a shelf for a screen."""
    made = Solid().add((-0.7, 0.7), (-0.27, 0.27), (0.7, 0.73)).add((-0.7, -0.25), (-0.25, 0.27), (0, 0.7))
    made.cut((-0.67, -0.28), (-0.3, -0.24), (0.05, 0.66)).add((0.66, 0.7), (-0.25, 0.27), (0, 1.05))
    made.add((0.3, 0.34), (0, 0.27), (0.73, 1.05)).add((0.3, 0.7), (-0.05, 0.27), (1.02, 1.05))
    return painted(made.mesh("Desk with shelf"), "oak")


def radiator():
    made = Solid().add((-1.0, 1.0), (-0.05, 0.05), (0.0, 0.6))
    for x in np.arange(-0.95, 0.95, 0.1):
        made.add((x + 0.01, x + 0.07), (-0.07, 0.05), (0.05, 0.55))
    return painted(made.mesh("Radiator"), "laminate")


def whiteboard():
    made = Solid().add((-0.62, 0.62), (-0.02, 0.02), (0.5, 1.3)).cut((-0.59, 0.59), (-0.03, -0.01), (0.53, 1.27))
    made.add((-0.3, 0.3), (-0.07, -0.02), (0.48, 0.5))
    for x in (-0.58, 0.58):
        made.add((x - 0.02, x + 0.02), (-0.015, 0.015), (0.03, 0.5)).add((x - 0.02, x + 0.02), (-0.27, 0.27), (0, 0.03))
    return painted(made.mesh("Whiteboard"), "laminate")
