# SPDX-License-Identifier: GPL-3.0-or-later
"""The drawn lines of a picture, visible and hidden, as polylines in world space."""

from dataclasses import dataclass

import numpy as np

from .. import line_arrays, native, pipeline
from ..scene import scene

_LEAST = 0.02  # runs with at most this opacity factor of elision are dropped


@dataclass(frozen=True)
class DrawnLines:
    """R polylines of M points: polyline i has the points offsets[i] to offsets[i + 1] - 1."""

    offsets: np.ndarray  # (R + 1,) int64
    points: np.ndarray  # (M, 3) float64, world space
    strength: np.ndarray  # (M,) float32 in [0, 1]
    opacity: np.ndarray  # (M,) float32 in [0, 1], the pen's opacity times the polyline's opacity factor of elision
    radius: np.ndarray  # (M,) float32, scene units: half the pen's width in pixels, unprojected at the point's depth
    color: np.ndarray  # (M, 3) float32, scene-linear; as opacity and radius, that of the pen in and out of focus, mixed
    kinds: np.ndarray  # (M,) uint32 of the segment that starts at the point, bit i: the registry's definition i
    closed: np.ndarray  # (R,) bool, the last point repeats the first
    invisibility: np.ndarray  # (R,) uint8, quantitative invisibility: number of surfaces that hide it
    line_set: np.ndarray  # (R,) uint8, index into the style's line sets
    pen: np.ndarray  # (R,) uint32, index into the style's `pens()`


def of(read, view, style, options, near=None):
    """DrawnLines of a Read scene for a Style and a View, without haloes and overshoot. `near`: {frame offset:
    ShownLines} of neighboring frames, for elision smoothed in time."""
    core = native.load()
    seen = scene.seen(core, view)
    frame = pipeline.frame(read.placed, seen, style, core.CpuBackend(), options, notes=read.notes, near=near)
    return _drawn(frame.polylines(), view, style)


def _drawn(found, view, style):
    """DrawnLines of the native Polylines that have a pen and are not elided."""
    count, pen, left = np.diff(found.offsets.astype(np.int64)), found.pen, found.shown
    kept = (pen != native.UNSET) & (left > _LEAST)
    at = np.repeat(kept, count)
    pens = style.pens()
    widths = np.array([style.width_px(p, view.reference_scale) for p in pens], np.float32)
    opacity = np.array([p.opacity for p in pens], np.float32)
    color = np.array([p.color for p in pens], np.float32)
    near, away = (np.repeat(which, count)[at] for which in (pen, found.pen_away))
    mix = dict(zip(("color", "texture", "width", "opacity"), found.mix[at].T))

    def mixed(values, effect):
        share = mix[effect].reshape(-1, *[1] * (values.ndim - 1))
        return (1 - share) * values[near] + share * values[away]

    position = found.position_view[at].astype(np.float64)
    return DrawnLines(
        offsets=np.concatenate([[0], np.cumsum(count[kept])]),
        points=line_arrays.placed(position, np.linalg.inv(view.world_to_view)),
        strength=found.strength[at],
        opacity=mixed(opacity, "opacity") * np.repeat(left, count)[at],
        radius=(0.5 * mixed(widths, "width") * _unit(view, position)).astype(np.float32),
        color=mixed(color, "color"),
        kinds=found.kinds[at],
        closed=found.closed[kept].astype(bool),
        invisibility=found.invisibility[kept],
        line_set=found.line_set[kept],
        pen=pen[kept],
    )


def _unit(view, position):
    """(M,) scene units per pixel at points (M, 3) in view space."""
    across = 2 / (view.view_to_clip[1, 1] * view.height)
    return np.full(len(position), across) if view.orthographic else across * -position[:, 2]
