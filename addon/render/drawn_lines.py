# SPDX-License-Identifier: GPL-3.0-or-later
"""The strokes of a picture, visible and hidden, as polylines in world space."""

from dataclasses import dataclass, fields

import numpy as np

from .. import line_arrays, native, pipeline
from ..scene import scene


@dataclass(frozen=True)
class DrawnLines:
    """R polylines of M points: polyline i has the points offsets[i] to offsets[i + 1] - 1. They are in the order of the
    ids of their paths."""

    offsets: np.ndarray  # (R + 1,) int64
    points: np.ndarray  # (M, 3) float32, world space
    strength: np.ndarray  # (M,) float32 in [0, 1]
    opacity: np.ndarray  # (M,) float32 in [0, 1], of the pen, as focus, distance, and line thinning have it
    radius: np.ndarray  # (M,) float32, scene units: half the stroke's width in pixels, unprojected at the point's depth
    color: np.ndarray  # (M, 3) float32, scene-linear
    kinds: np.ndarray  # (M,) uint32 of the segment around the point, bit i: the registry's definition i
    closed: np.ndarray  # (R,) bool, the last point repeats the first
    invisibility: np.ndarray  # (R,) uint8, quantitative invisibility: number of surfaces that hide it
    line_set: np.ndarray  # (R,) uint8, index into the style's line sets
    pen: np.ndarray  # (R,) uint32, index into the style's `pens()`
    path_id: np.ndarray  # (R,) uint64, the same in all frames for lines of the mesh

    @property
    def memory(self):
        """Bytes of its arrays."""
        return sum(getattr(self, field.name).nbytes for field in fields(self))


def of(read, view, style, options, near=None, cancel=None):
    """DrawnLines of a Read scene for a Style and a View, as strokes are drawn: with haloes, overshoot, and what changes
    pens along strokes. `near`: a pipeline.Near, for elision smoothed in time; `cancel`: a native Cancel, or
    None."""
    core = native.load()
    seen = scene.seen(core, view)
    beside = {"notes": read.notes, "near": near, "cancel": cancel}
    frame = pipeline.frame(read.placed, seen, style, core.CpuBackend(), options, **beside)
    with native.refusals():
        return _in_world(core.CenterLines(frame), view)


def _in_world(found, view):
    """DrawnLines of native CenterLines."""
    position = found.position_view.astype(np.float64)
    return DrawnLines(
        offsets=found.offsets.astype(np.int64),
        points=line_arrays.placed(position, np.linalg.inv(view.world_to_view)).astype(np.float32),
        strength=found.strength,
        opacity=found.opacity,
        radius=(0.5 * found.width_px * _unit(view, position)).astype(np.float32),
        color=found.color,
        kinds=found.kinds,
        closed=found.closed.astype(bool),
        invisibility=found.invisibility,
        line_set=found.line_set,
        pen=found.pen,
        path_id=found.path_id,
    )


def _unit(view, position):
    """(M,) scene units per pixel at points (M, 3) in view space."""
    across = 2 / (view.view_to_clip[1, 1] * view.height)
    return np.full(len(position), across) if view.orthographic else across * -position[:, 2]
