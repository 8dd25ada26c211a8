# SPDX-License-Identifier: GPL-3.0-or-later
"""Small models as texts of OBJ files, which say the same on every system."""

import math


def obj(positions, faces):
    """positions: (x, y, z); faces: of vertices, from 0."""
    rows = [f"v {x:.4f} {y:.4f} {z:.4f}" for x, y, z in positions]
    return "\n".join(rows + ["f " + " ".join(str(v + 1) for v in face) for face in faces]) + "\n"


def grid(place, columns, rows, around=False):
    """(positions, faces) of a surface: place(u, v) for u, v in 0..1; `around`: closed in both directions."""
    wide, high = (columns, rows) if around else (columns + 1, rows + 1)
    positions = [place(i / columns, j / rows) for j in range(high) for i in range(wide)]

    def vertex(i, j):
        return j % high * wide + i % wide

    faces = [
        (vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1))
        for j in range(rows)
        for i in range(columns)
    ]
    return positions, faces


def torus():
    def place(u, v):
        a, b = math.tau * u, math.tau * v
        radius = 1.0 + 0.4 * math.cos(b)
        return radius * math.cos(a), radius * math.sin(a), 0.4 * math.sin(b)

    return obj(*grid(place, 36, 18, around=True))


def hills():
    def place(u, v):
        x, y = 6.0 * u - 3.0, 6.0 * v - 3.0
        return x, y, 0.5 * math.sin(2.0 * x) * math.cos(1.5 * y) + 0.2 * math.sin(5.0 * x + y)

    return obj(*grid(place, 48, 48))


def stairs():
    """Boxes that stand in and beside each other: creases, intersections, and much that is hidden."""
    positions, faces = [], []
    sides = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    for step in range(6):
        first = len(positions)
        low, high = (0.5 * step, 0.1 * step, 0.0), (0.5 * step + 0.8, 0.1 * step + 1.5, 0.3 * step + 0.4)
        positions += [
            tuple(high[axis] if corner >> axis & 1 else low[axis] for axis in range(3)) for corner in range(8)
        ]
        faces += [tuple(first + v for v in side) for side in sides]
    return obj(positions, faces)


MODELS = {"torus": torus, "hills": hills, "stairs": stairs}
