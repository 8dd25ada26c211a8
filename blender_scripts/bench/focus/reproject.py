# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares pictures of two views by reprojection, where both show the same surface point.

A line lies on the silhouette of a surface, so a pixel's depth is that of the nearest surface within REACH pixels."""

from dataclasses import dataclass

import numpy as np

REACH = 2
NOTHING = 1e9  # distances from this value on mean background
SAME = 0.02  # relative tolerance of the depth of a reprojected point


class Seen:
    """A stages.View and its depth buffer. distance: (H, W) along the view direction, bottom row first."""

    def __init__(self, view, distance):
        self.view, self.distance = view, nearest_around(distance)

    def points(self):
        """(H, W, 3) world positions."""
        clip, (height, width) = self.view.view_to_clip, self.distance.shape
        z = -self.distance.astype(np.float64)
        w = clip[3, 2] * z + clip[3, 3]
        x = (((np.arange(width) + 0.5) / width * 2 - 1) * w - clip[0, 2] * z - clip[0, 3]) / clip[0, 0]
        y = (((np.arange(height) + 0.5) / height * 2 - 1)[:, None] * w - clip[1, 2] * z - clip[1, 3]) / clip[1, 1]
        to_world = np.linalg.inv(self.view.world_to_view)
        return np.stack((x, y, z), axis=-1) @ to_world[:3, :3].T + to_world[:3, 3]

    def brought_over(self, before):
        """The Over that maps this view's pixels to an earlier Seen."""
        there = self.points() @ before.view.world_to_view[:3, :3].T + before.view.world_to_view[:3, 3]
        clip, (height, width) = before.view.view_to_clip, before.distance.shape
        homogeneous = there @ clip[[0, 1, 3], :3].T + clip[[0, 1, 3], 3]
        with np.errstate(divide="ignore", invalid="ignore"):
            at = (homogeneous[..., :2] / homogeneous[..., 2:] + 1) / 2 * (width, height) - 0.5
        known = (self.distance < NOTHING) & (there[..., 2] < 0)
        known &= (at >= 0).all(axis=-1) & (at <= (width - 1, height - 1)).all(axis=-1)
        at = np.where(known[..., None], at, 0.0)
        nearest = np.rint(at).astype(np.int64)
        known &= np.abs(before.distance[nearest[..., 1], nearest[..., 0]] + there[..., 2]) < SAME * self.distance
        return Over(at, known)


@dataclass(frozen=True)
class Over:
    at: np.ndarray  # (H, W, 2) in pixels of the earlier picture, whole numbers at their centers
    known: np.ndarray  # (H, W) whether the point was visible there

    def difference(self, now, before):
        """(mean absolute, root mean square) difference of two (H, W) pictures over the points that both show."""
        column, row = self.at[self.known].T
        i = np.clip(row.astype(np.int64), 0, max(before.shape[0] - 2, 0))
        j = np.clip(column.astype(np.int64), 0, max(before.shape[1] - 2, 0))
        v, u = row - i, column - j
        lower = before[i, j] * (1 - u) + before[i, j + 1] * u
        upper = before[i + 1, j] * (1 - u) + before[i + 1, j + 1] * u
        change = np.abs(now[self.known] - (lower * (1 - v) + upper * v))
        change = change[np.isfinite(change)]  # both values are defined
        return (float(change.mean()), float(np.sqrt((change**2).mean()))) if len(change) else (0.0, 0.0)


def mean_around(values, reach):
    """(H, W) box filter over `reach` pixels to each side, padded with 0."""
    for axis in (0, 1):
        edge = [(reach + 1, reach) if k == axis else (0, 0) for k in (0, 1)]
        sums = np.cumsum(np.pad(values.astype(np.float64), edge), axis=axis)
        low = np.arange(values.shape[axis])
        values = (np.take(sums, low + 2 * reach + 1, axis=axis) - np.take(sums, low, axis=axis)) / (2 * reach + 1)
    return values


def nearest_around(distance):
    """(H, W) minimum filter over REACH pixels to each side along both axes."""
    for axis in (0, 1):
        edge = [(REACH, REACH) if k == axis else (0, 0) for k in (0, 1)]
        wide = np.pad(distance, edge, mode="edge")
        shifted = [np.take(wide, np.arange(distance.shape[axis]) + k, axis=axis) for k in range(2 * REACH + 1)]
        distance = np.minimum.reduce(shifted)
    return distance
