# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of a picture as polylines in space: what the pens draw of them, visible and hidden."""

from dataclasses import dataclass

import numpy as np

from .. import line_arrays, native, pipeline
from ..scene import scene

_LEAST = 0.02  # share of a line that elision must leave


@dataclass(frozen=True)
class DrawnLines:
    """R polylines of M points: those of polyline i are offsets[i] to offsets[i + 1]."""

    offsets: np.ndarray  # (R + 1,) int64
    points: np.ndarray  # (M, 3) float64, world space
    strength: np.ndarray  # (M,) float32 in [0, 1]
    opacity: np.ndarray  # (M,) float32 in [0, 1], of the pen and of what elision leaves of the polyline
    radius: np.ndarray  # (M,) float32, units of the scene: half the pen's width, as the camera sees it there
    kinds: np.ndarray  # (M,) uint32, bit i: the registry's definition i, of the segment from the point
    closed: np.ndarray  # (R,) bool, the last point is the first again
    invisibility: np.ndarray  # (R,) uint8, how many surfaces hide it
    line_set: np.ndarray  # (R,) uint8, index into the style's
    pen: np.ndarray  # (R,) uint32, index into the style's `pens`


def of(read, view, style, options, near=None):
    """DrawnLines of what was Read, as a Style draws them in a View; without haloes and overshoot. `near`: the lines of
    the frames around it, for elision smoothed in time."""
    core = native.load()
    seen = scene.seen(core, view)
    frame = pipeline.frame(read.placed, seen, style, core.CpuBackend(), options, notes=read.notes, near=near)
    return _drawn(frame.polylines(), view, style)


def _drawn(found, view, style):
    """DrawnLines of those of native Polylines that a pen draws and elision leaves."""
    count, pen, left = np.diff(found.offsets.astype(np.int64)), found.pen, found.shown
    kept = (pen != native.UNSET) & (left > _LEAST)
    at = np.repeat(kept, count)
    pens, pen_of_point = style.pens(), np.repeat(pen, count)[at]
    widths = np.array([style.width_px(p, view.reference_scale) for p in pens], np.float32)
    opacity = np.array([p.opacity for p in pens], np.float32)
    position = found.position_view[at].astype(np.float64)
    return DrawnLines(
        offsets=np.concatenate([[0], np.cumsum(count[kept])]),
        points=line_arrays.placed(position, np.linalg.inv(view.world_to_view)),
        strength=found.strength[at],
        opacity=opacity[pen_of_point] * np.repeat(left, count)[at],
        radius=(0.5 * widths[pen_of_point] * _unit(view, position)).astype(np.float32),
        kinds=found.kinds[at],
        closed=found.closed[kept].astype(bool),
        invisibility=found.invisibility[kept],
        line_set=found.line_set[kept],
        pen=pen[kept],
    )


def _unit(view, position):
    """(M,) units of the scene that a pixel covers at places in view space."""
    across = 2 / (view.view_to_clip[1, 1] * view.height)
    return np.full(len(position), across) if view.orthographic else across * -position[:, 2]
