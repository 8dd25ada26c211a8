# SPDX-License-Identifier: GPL-3.0-or-later
"""boxes:N, the hard case for line visibility: N x N boxes, nearly every line hidden by other boxes. One mesh."""

import random

import bpy
import numpy as np

from . import stage

WIDTH = 4.0  # of the grid
HALF = 1.6  # half-width of a box, divided by N
FLOOR = -0.5

CORNERS = np.array([(x, y, z) for z in (0, 1) for y in (-1, 1) for x in (-1, 1)], dtype=np.float32)
QUADS = np.array([(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)], dtype=np.int32)


def heights(count: int) -> np.ndarray:
    """random.Random(1), one number per box in row order: along x within a row, rows towards +y."""
    draw = random.Random(1)
    return np.array([draw.random() for _ in range(count)], dtype=np.float32)


def grid(n: int) -> np.ndarray:
    """(n * n, 8, 3) corners."""
    place = (np.arange(n, dtype=np.float32) + 0.5) * (WIDTH / n) - WIDTH / 2
    corners = np.broadcast_to(CORNERS, (n * n, 8, 3)) * np.float32(HALF / n)
    corners[..., 0] += np.tile(place, n)[:, None]
    corners[..., 1] += np.repeat(place, n)[:, None]
    corners[..., 2] = FLOOR + CORNERS[:, 2] * heights(n * n)[:, None]
    return corners


def mesh(n: int):
    corners = grid(n)
    quads = (np.arange(n * n, dtype=np.int32)[:, None, None] * 8 + QUADS).ravel()
    made = bpy.data.meshes.new("Boxes")
    made.vertices.add(n * n * 8)
    made.vertices.foreach_set("co", corners.ravel())
    made.loops.add(len(quads))
    made.loops.foreach_set("vertex_index", quads)
    made.polygons.add(n * n * 6)
    made.polygons.foreach_set("loop_start", np.arange(0, len(quads), 4, dtype=np.int32))
    made.update(calc_edges=True)
    return made


def build(argument: int, shared):
    stage.clear()
    stage.frame()
    boxes = mesh(argument)
    boxes.materials.append(stage.material("Card", (0.82, 0.78, 0.7)))
    stage.link("Boxes", boxes)
    stage.camera((3.2, -4.2, 2), (0, 0, 0))
    stage.sun(-60, 50)
