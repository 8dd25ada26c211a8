# SPDX-License-Identifier: GPL-3.0-or-later
"""Strokes of a frame as arrays, whoever drew them, and points spaced evenly along them."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Strokes:
    """R polylines of M points; polyline i has the points offsets[i] to offsets[i + 1] - 1."""

    offsets: np.ndarray  # (R + 1,) int64
    px: np.ndarray  # (M, 2) from the lower left corner
    world: np.ndarray  # (M, 3)
    depth: np.ndarray  # (M,) distance from the eye along the view axis; 1 everywhere in an orthographic view
    along: np.ndarray  # (M,) the dashes' coordinate, of any unit, that levels leave as it is
    whole_px: np.ndarray  # (M,) pixels that a unit of it has there
    octaves: bool  # whether a unit is divided by powers of two; else it is a period
    opacity: np.ndarray  # (M,) of the dashes there, in [0, 1]
    lines: int | None = None  # number of the whole lines that they are seen parts of; None: nobody tells

    @property
    def count(self):
        return len(self.offsets) - 1


@dataclass(frozen=True)
class Samples:
    """n points spaced evenly along strokes."""

    px: np.ndarray  # (n, 2)
    direction: np.ndarray  # (n, 2) unit vectors
    world: np.ndarray  # (n, 3)
    depth: np.ndarray  # (n,)
    along: np.ndarray  # (n,)
    per_px: np.ndarray  # (n,) change of `along` per pixel
    whole_px: np.ndarray  # (n,)
    opacity: np.ndarray  # (n,)
    run: np.ndarray  # (n,) of Strokes
    length_px: np.ndarray  # (n,) length of line that each stands for


def arc_from_start(px, offsets):
    """(M,) pixels of arc length from each polyline's start."""
    step = np.zeros(len(px))
    step[1:] = np.hypot(*np.diff(px, axis=0).T)
    step[offsets[:-1]] = 0.0
    arc = np.cumsum(step)
    return arc - np.repeat(arc[offsets[:-1]], np.diff(offsets))


def divided(offsets, px, depth, step_px):
    """Points of polylines and more between them, at most `step_px` apart: (offsets, (m,) the point that each follows,
    (m,) shares of the way to the next one in the image, (m,) in space)."""
    size = np.zeros(len(px))
    size[:-1] = np.hypot(*np.diff(px, axis=0).T)
    size[offsets[1:] - 1] = 0.0
    parts = np.maximum(1, np.ceil(size / step_px).astype(np.int64))
    point = np.repeat(np.arange(len(px)), parts)
    first = np.concatenate([[0], np.cumsum(parts)])
    t = (np.arange(len(point)) - first[point]) / parts[point]
    return first[offsets], point, t, in_space(t, depth[point], depth[np.minimum(point + 1, len(px) - 1)])


def in_space(t, near, far):
    """What is the share t of a line in the image, by the depths of its ends."""
    return t * near / (far + t * (near - far))


def sampled(strokes, step_px):
    """Samples at the middles of equal parts of each stroke, about `step_px` long."""
    sizes = np.diff(strokes.offsets)
    arc = arc_from_start(strokes.px, strokes.offsets)
    length = arc[strokes.offsets[1:] - 1]
    kept = np.flatnonzero((sizes > 1) & (length > 0))
    parts = np.maximum(1, np.rint(length[kept] / step_px).astype(np.int64))
    run = np.repeat(kept, parts)
    first = np.repeat(np.cumsum(parts) - parts, parts)
    at = (np.arange(len(run)) - first + 0.5) / np.repeat(parts, parts) * length[run]
    # All strokes on one axis, without overlap.
    reach = (length.max() if len(length) else 0.0) + 1.0
    axis = arc + np.repeat(np.arange(len(sizes)), sizes) * reach
    segment = np.searchsorted(axis, run * reach + at, side="right") - 1
    segment = np.clip(segment, strokes.offsets[run], strokes.offsets[run + 1] - 2)
    after = segment + 1
    way = (strokes.px[after] - strokes.px[segment]).astype(np.float64)
    size = np.maximum(np.hypot(*way.T), 1e-12)
    t = np.clip((at - arc[segment]) / size, 0.0, 1.0)
    s = in_space(t, strokes.depth[segment], strokes.depth[after])
    return Samples(
        px=mixed(strokes.px, segment, t),
        direction=way / size[:, None],
        world=mixed(strokes.world, segment, s),
        depth=mixed(strokes.depth, segment, s),
        along=mixed(strokes.along, segment, t),
        per_px=(strokes.along[after] - strokes.along[segment]) / size,
        whole_px=mixed(strokes.whole_px, segment, t),
        opacity=mixed(strokes.opacity, segment, t),
        run=run,
        length_px=np.repeat(length[kept] / parts, parts),
    )


def mixed(values, segment, t):
    values = np.asarray(values, np.float64)
    t = t[:, None] if values.ndim > 1 else t
    return values[segment] + t * (values[np.minimum(segment + 1, len(values) - 1)] - values[segment])
