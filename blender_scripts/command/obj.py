# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the polygons of a Wavefront OBJ file unchanged: no axis swap, scaling or welding."""

import re
from dataclasses import dataclass

import numpy as np

from . import ears


def whole_corners(finite, corners, starts):
    """The corners of the polygons without a broken vertex. finite (V,) bool; corners (C,): vertices; starts (F,): the
    first corner of each polygon."""
    whole = np.logical_and.reduceat(finite[corners], starts) if len(starts) else np.zeros(0, bool)
    return corners[np.repeat(whole, np.diff(starts, append=len(corners)))]


@dataclass(frozen=True)
class Polygons:
    positions: np.ndarray  # (V, 3) float64
    corner_verts: np.ndarray  # (C,) int32
    offsets: np.ndarray  # (F + 1,) int32: first corner of each polygon
    material: np.ndarray  # (F,) int32: index of the material name in the file; 0: none

    def drawn_positions(self):
        """(n, 3): of the vertices that polygons without broken vertices have."""
        finite = np.isfinite(self.positions).all(axis=1)
        return self.positions[np.unique(whole_corners(finite, self.corner_verts, self.offsets[:-1]))]

    def ngon_triangles(self):
        """Triangulation of polygons with more than four corners: vertices (T, 3) int32 and polygon (T,) int32."""
        triangles, owners = [np.empty((0, 3), np.int32)], [np.empty(0, np.int32)]
        for polygon in np.flatnonzero(np.diff(self.offsets) > 4):
            corners = self.corner_verts[self.offsets[polygon] : self.offsets[polygon + 1]]
            triangles.append(corners[ears.triangulate(self.positions[corners])])
            owners.append(np.full(len(corners) - 2, polygon, np.int32))
        return np.concatenate(triangles), np.concatenate(owners)


def read(path):
    """The Polygons of an OBJ file, without faces of fewer than three corners. ValueError, with the file's name, if it
    is not a valid OBJ file."""
    lines = path.read_bytes().replace(b"\\\r\n", b" ").replace(b"\\\n", b" ").splitlines()
    lines = [line.strip() for line in lines]
    is_vertex = np.array([line[:2] in (b"v ", b"v\t") for line in lines], bool)
    is_face = np.array([line[:2] in (b"f ", b"f\t") for line in lines], bool)
    try:
        positions = _positions([lines[i][2:] for i in np.flatnonzero(is_vertex)])
        seen = np.cumsum(is_vertex)[is_face]
        corners, counts = _corners([lines[i][2:] for i in np.flatnonzero(is_face)], seen)
    except ValueError as error:
        raise ValueError(f"{path} is no OBJ file that can be read: {error}") from error
    if len(corners) and not 0 <= corners.min() <= corners.max() < len(positions):
        raise ValueError(f"{path} has faces of vertices that it does not have")
    kept = counts > 2
    offsets = np.concatenate([[0], np.cumsum(counts[kept])])
    corners = corners[np.repeat(kept, counts)].astype(np.int32)
    return Polygons(positions, corners, offsets.astype(np.int32), _materials(lines, is_face)[kept])


def _positions(lines):
    """(V, 3): the first three numbers of each line; weights or colors may follow."""
    numbers = _numbers(lines, float)
    if len(numbers) != 3 * len(lines):
        numbers = _numbers([b" ".join(line.split()[:3]) for line in lines], float)
    if len(numbers) != 3 * len(lines):
        raise ValueError("a vertex has fewer than three coordinates")
    return numbers.reshape(-1, 3)


def _corners(lines, seen):
    """(zero-based vertices of all faces, concatenated; number of corners of each face). Negative indices count
    backwards from the number of vertices `seen` before the face."""
    lines = re.sub(rb"/[^\s]*", b"", b"\n".join(lines)).split(b"\n") if lines else []
    counts = np.array([len(line.split()) for line in lines], np.int64)
    index = _numbers(lines, np.int64)
    if (index == 0).any():
        raise ValueError("a face names vertex 0, and they count from 1")
    return np.where(index > 0, index - 1, index + np.repeat(seen, counts)), counts


def _materials(lines, is_face):
    """Index of the material named last before each face; 0 if there is none."""
    names = {b"": 0}
    uses = [i for i, line in enumerate(lines) if line.split(None, 1)[:1] == [b"usemtl"]]
    number = [0, *(names.setdefault(lines[i][6:].strip(), len(names)) for i in uses)]
    return np.array(number, np.int32)[np.searchsorted(uses, np.flatnonzero(is_face))]


def _numbers(lines, kind):
    return np.array(b" ".join(lines).split(), kind)
