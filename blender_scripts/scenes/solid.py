# SPDX-License-Identifier: GPL-3.0-or-later
"""Axis-aligned solids: walls, slabs, frames, steps. Boxes are added and subtracted in order; the mesh is the surface of
the result, with edges at all joints, so that each has its line."""

import bmesh
import numpy as np

from . import shapes


class Solid:
    def __init__(self):
        self.steps = []

    def add(self, x, y, z, keep: bool = True):
        """x, y, z: pairs (from, to), in any order."""
        self.steps.append((np.sort(np.round([x, y, z], 4), axis=1), keep))
        return self

    def cut(self, x, y, z):
        return self.add(x, y, z, keep=False)

    def mesh(self, name: str):
        lines = [np.unique([bounds[axis] for bounds, _ in self.steps]) for axis in range(3)]
        filled = np.zeros([len(line) + 1 for line in lines], dtype=bool)  # one empty cell all around
        for bounds, keep in self.steps:
            cells = tuple(slice(*(np.searchsorted(lines[axis], bounds[axis]) + 1)) for axis in range(3))
            filled[cells] = keep
        faces = np.concatenate([_faces(filled, axis) for axis in range(3)])
        used, index = np.unique(faces, return_inverse=True)
        grid = np.unravel_index(used, [len(line) for line in lines])
        points = np.stack([line[i] for line, i in zip(lines, grid)], axis=1)
        return _merged(shapes.mesh(name, points, index.reshape(-1, 4)))


def _faces(filled: np.ndarray, axis: int) -> np.ndarray:
    """(n, 4) quads between filled and empty cells along `axis`, facing outwards, as flat indices of grid points."""
    shape = [n - 1 for n in filled.shape]
    solid = np.moveaxis(filled, axis, 0).astype(np.int8)
    step = np.diff(solid, axis=0)  # -1: solid below, empty above
    u, v = [(1, 2), (2, 0), (0, 1)][axis]
    result = []
    for sign, order in ((-1, (0, 1, 2, 3)), (1, (0, 3, 2, 1))):
        where = np.argwhere(step == sign)
        cell = np.empty_like(where)
        cell[:, axis] = where[:, 0]
        rest = [a for a in range(3) if a != axis]
        cell[:, rest[0]], cell[:, rest[1]] = where[:, 1] - 1, where[:, 2] - 1  # the empty border is no grid point
        corners = np.repeat(cell[:, None], 4, axis=1)
        corners[:, [1, 2], u] += 1
        corners[:, [2, 3], v] += 1
        result.append(np.ravel_multi_index(tuple(np.moveaxis(corners[:, order], 2, 0)), shape))
    return np.concatenate(result)


def _merged(shape):
    """Merges coplanar faces."""
    work = bmesh.new()
    work.from_mesh(shape)
    bmesh.ops.dissolve_limit(work, angle_limit=0.01, verts=work.verts, edges=work.edges)
    work.to_mesh(shape)
    work.free()
    return shape


def bars(
    width: float, height: float, columns: int, rows: int, thick: float = 0.05, deep: float = 0.06, inner: float = 0.03
):
    """A window frame with mullions in the x, z plane: from x = 0 and z = 0, its middle at y = 0."""
    made = Solid().add((0, width), (-deep / 2, deep / 2), (0, height))
    x = np.linspace(thick - inner / 2, width - thick + inner / 2, columns + 1)
    z = np.linspace(thick - inner / 2, height - thick + inner / 2, rows + 1)
    for x0, x1 in zip(x[:-1], x[1:]):
        for z0, z1 in zip(z[:-1], z[1:]):
            made.cut((x0 + inner / 2, x1 - inner / 2), (-deep, deep), (z0 + inner / 2, z1 - inner / 2))
    return made
