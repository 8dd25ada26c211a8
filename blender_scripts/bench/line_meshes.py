# SPDX-License-Identifier: GPL-3.0-or-later
"""Generated meshes for `fovea bench lines`: analytic surfaces tessellated to about a given number of triangles."""

import math
from dataclasses import dataclass

import numpy as np

WAVES = ((0.10, 4, 1, 0.3), (0.08, -1.5, 5, 1.1), (0.05, 3, -4, 2))  # c sin(a x + b y + phase)


@dataclass
class Mesh:
    positions: np.ndarray  # (V, 3)
    triangles: np.ndarray  # (T, 3)

    def surface(self, native, name):
        offsets = np.arange(0, self.triangles.size + 1, 3, dtype=np.int32)
        corners = self.triangles.reshape(-1).astype(np.int32)
        edges = native.PolygonEdges(offsets, corners)
        mesh = native.Mesh(
            positions=self.positions.astype(np.float32),
            edge_verts=edges.edge_verts,
            corner_verts=corners,
            corner_edges=edges.corner_edges,
            polygon_offsets=offsets,
        )
        return native.Surface(name, mesh)

    def sphere(self):
        low, high = self.positions.min(axis=0), self.positions.max(axis=0)
        return (low + high) / 2, np.linalg.norm(high - low) / 2


def waves(triangles):
    """A height field over [-1,1]^2, front-facing from above nearly everywhere."""
    n = round(math.sqrt(triangles / 2))
    x, y = np.meshgrid(np.linspace(-1, 1, n + 1), np.linspace(-1, 1, n + 1))
    z = sum(c * np.sin(a * x + b * y + phase) for c, a, b, phase in WAVES)
    return Mesh(np.stack([x, y, z], -1).reshape(-1, 3), _cells(n, n, closed=False))


def bumpy_torus(triangles):
    """A torus around z with bumps: saddles, ridges and valleys; half of it is back-facing."""
    m = round(math.sqrt(triangles) / 2)
    n = 2 * m
    a, b = np.meshgrid(2 * np.pi * np.arange(n) / n, 2 * np.pi * np.arange(m) / m)
    tube = 0.4 * (1 + 0.12 * np.sin(7 * a) * np.cos(3 * b) + 0.05 * np.sin(13 * a + 5 * b))
    ring = 1 + tube * np.cos(b)
    points = np.stack([ring * np.cos(a), ring * np.sin(a), tube * np.sin(b)], -1)
    return Mesh(points.reshape(-1, 3), _cells(n, m, closed=True))


def _cells(n, m, closed):
    """Two triangles per cell of an n x m grid; closed: periodic in both directions."""
    wide, high = (n, m) if closed else (n + 1, m + 1)
    i, j = np.meshgrid(np.arange(n), np.arange(m))
    right, up = (i + 1) % wide, (j + 1) % high
    a, b, c, d = i + wide * j, right + wide * j, right + wide * up, i + wide * up
    return np.stack([a, b, c, a, c, d], -1).reshape(-1, 3)


SHAPES = {"waves": waves, "bumpy torus": bumpy_torus}
