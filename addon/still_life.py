# SPDX-License-Identifier: GPL-3.0-or-later
"""The scenes for thumbnails, as plain arrays: of styles a jug, a ball and a box on a round table, which have smooth and
flat surfaces, sharp edges and occlusion; of line thinning, boards one behind the other.
"""

from dataclasses import dataclass

import numpy as np

EYE, TARGET = (2.6, -5.2, 2.7), (0.0, 0.0, 0.62)
HALF_HEIGHT = 0.27  # tangent of half the field of view
SUN = (-0.55, -0.35, -0.75)  # direction of the light's travel
AROUND = 72  # vertices around the axis of a surface of revolution
_JUG = (
    *((0.0, 0.0), (0.36, 0.0), (0.4, 0.05), (0.58, 0.35), (0.62, 0.6), (0.5, 0.92), (0.3, 1.15), (0.25, 1.3)),
    *((0.33, 1.48), (0.29, 1.47), (0.21, 1.3), (0.25, 1.12)),
)


@dataclass(frozen=True)
class Shape:
    name: str
    positions: np.ndarray  # (V, 3) float32, world space
    corners: np.ndarray  # (C,) int32 vertices
    offsets: np.ndarray  # (F + 1,) int32 corners of polygons
    normals: np.ndarray  # (C, 3) float32
    color: tuple  # scene-linear


def shapes():
    """The Shapes of the scene: the table, and the objects on it."""
    table = ((0.0, -0.14), (1.95, -0.14), (1.95, 0.0), (0.0, 0.0))
    around = np.linspace(-np.pi / 2, np.pi / 2, 33)
    ball = np.column_stack([0.4 * np.cos(around), 0.4 + 0.4 * np.sin(around)])
    return (
        _turned("Table", np.array(table), (0.0, 0.0), (0.42, 0.26, 0.14), smooth=False),
        _turned("Jug", _rounded(np.array(_JUG)), (-0.45, 0.15), (0.12, 0.3, 0.5)),
        _turned("Ball", ball, (0.42, -0.75), (0.75, 0.16, 0.07)),
        _box("Box", (0.85, 0.4), (0.45, 0.32, 0.42), 1.1, (0.72, 0.55, 0.16)),
    )


def boards():
    """The Shapes of upright boards in a row, whose edges crowd the more the farther they are away."""
    return tuple(
        _box(f"Board {i}", (-0.45, -1.3 + 0.22 * i), (0.8, 0.02, 0.45), 0.0, (0.8, 0.8, 0.8)) for i in range(20)
    )


def view():
    """(world_to_view, view_to_clip, near, far) for a square image; matrices (4, 4) float64."""
    back = np.subtract(EYE, TARGET)
    back = back / np.linalg.norm(back)
    right = np.cross((0, 0, 1), back)
    right /= np.linalg.norm(right)
    world_to_view, clip, near, far = np.eye(4), np.zeros((4, 4)), 0.5, 50.0
    world_to_view[:3, :3] = right, np.cross(back, right), back
    world_to_view[:3, 3] = -world_to_view[:3, :3] @ EYE
    clip[0, 0], clip[1, 1], clip[3, 2] = 1 / HALF_HEIGHT, 1 / HALF_HEIGHT, -1
    clip[2, 2:] = -(far + near) / (far - near), -2 * far * near / (far - near)
    return world_to_view, clip, near, far


def _rounded(profile, steps=6):
    """(n, 2) profile interpolated by a Catmull-Rom spline, `steps` points per interval."""
    ends = np.vstack([profile[:1], profile, profile[-1:]])
    t = np.linspace(0, 1, steps, endpoint=False)[:, None]
    pieces = []
    for a, b, c, d in zip(ends, ends[1:], ends[2:], ends[3:]):
        pieces.append(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t**2 + (3 * b - a - 3 * c + d) * t**3))
    return np.vstack([*pieces, profile[-1:]])


def _turned(name, profile, place, color, smooth=True):
    """Surface of revolution of a profile (n, 2) of (radius, height), from the bottom outwards, about the vertical axis
    through `place` (x, y). Vertices at radius 0 are merged."""
    count = len(profile)
    angle = np.linspace(0, 2 * np.pi, AROUND, endpoint=False)
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    points = np.empty((count, AROUND, 3))
    points[..., :2], points[..., 2] = profile[:, None, :1] * ring + place, profile[:, 1:]
    first, then = np.meshgrid(np.arange(count - 1), np.arange(AROUND), indexing="ij")
    beside = (then + 1) % AROUND
    quads = np.stack([first * AROUND + then, first * AROUND + beside, (first + 1) * AROUND + beside], axis=-1)
    quads = np.concatenate([quads, ((first + 1) * AROUND + then)[..., None]], axis=-1).reshape(-1, 4)
    along = np.gradient(profile, axis=0)
    out = np.stack([along[:, 1:] * ring[..., None, :, 0], along[:, 1:] * ring[..., None, :, 1]], axis=-1)
    out = np.concatenate([out, np.broadcast_to(-along[:, :1, None], (count, AROUND, 1))], axis=-1)
    return _shape(name, points.reshape(-1, 3), quads, out.reshape(-1, 3) if smooth else None, color)


def _box(name, place, half, turn, color):
    corners = np.array([(x, y, z) for z in (0, 2) for y in (-1, 1) for x in (-1, 1)]) * half
    c, s = np.cos(turn), np.sin(turn)
    points = corners @ np.array([(c, s, 0), (-s, c, 0), (0, 0, 1)])
    quads = np.array([(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])
    return _shape(name, points + (*place, 0.0), quads, None, color)


def _shape(name, points, quads, normals, color):
    """A Shape of quads (F, 4), with vertices at equal positions merged. `normals`: per vertex; None: face normals."""
    _, first, same = np.unique(np.round(points, 6), axis=0, return_index=True, return_inverse=True)
    same = same.reshape(-1)
    if normals is None:
        p = points[quads]
        normals = np.repeat(np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1]), 4, axis=0)
    else:
        normals = normals[quads.ravel()]
    normals = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    corners = same[quads]
    kept = corners != np.roll(corners, 1, axis=1)  # quads at the axis become triangles
    return Shape(
        name,
        points[first].astype(np.float32),
        corners[kept].astype(np.int32),
        np.concatenate([[0], np.cumsum(kept.sum(axis=1))]).astype(np.int32),
        normals[kept.ravel()].astype(np.float32),
        color,
    )
