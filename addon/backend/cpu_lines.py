# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawn lines read back as polylines. Each function is one call of the native module, or few."""

import numpy as np

from .. import native

_OUTLINE_STEP = 10.0  # reference pixels between looks at what lies behind an outline


def compact(frame, runs):
    """The native CompactRuns of Runs: their points, whose arrays say where and what they are."""
    return native.load().compact(frame.clipped, frame.paths, runs)


def pens_of(frame, runs, ranges):
    """(R,) uint32 pen of each of Runs, native.UNSET: none draws it; `ranges` as of Style.pen_ranges."""
    core, rows = native.load(), np.array(ranges, np.uint32)
    return core.pens_of_runs(frame.clipped, runs, frame.paths.line_set, rows)


def of_runs(frame, compacted, samples):
    """(R,) float32 means over CompactRuns of (samples,) values along a Frame's lines."""
    clipped = frame.clipped
    count = clipped.sample_count.astype(np.intp)
    segment = np.repeat(np.arange(len(count)), count)
    step = np.arange(len(segment)) - np.repeat(np.cumsum(count) - count, count)
    share = (step + 0.5) / count[segment]
    arc = clipped.arc_px[segment] * (1 - share) + clipped.arc_px[np.minimum(segment + 1, len(count) - 1)] * share
    # Pieces one after the other, far apart, so that one search finds the place on all.
    apart = 4 * max(1.0, float(np.abs(clipped.arc_px).max(initial=1.0)))
    piece_of_point = np.repeat(np.arange(len(clipped.path)), np.diff(clipped.offsets.astype(np.intp)))
    places = piece_of_point[segment] * apart + arc
    order = np.argsort(places, kind="stable")
    places, values = places[order], samples[(clipped.sample_start[segment] + step)[order]].astype(np.float64)
    start, end = (compacted.piece * apart + px for px in (compacted.start_px, compacted.end_px))
    first, last = np.searchsorted(places, start), np.searchsorted(places, end)
    sums = np.concatenate([[0.0], np.cumsum(values)])
    means = (sums[last] - sums[first]) / np.maximum(last - first, 1)
    # Between two samples: as there.
    short = last == first
    means[short] = np.interp((start + end)[short] / 2, places, values)
    return means.astype(np.float32)


def outlined(frame, runs, style, outlines, cancel):
    """Visible Runs parted where they are the outer boundary of their object, and (R,) uint32 the pen of each,
    native.UNSET: none. `outlines`: as of the pipeline's Options."""
    clipped, paths, step = frame.clipped, frame.paths, _OUTLINE_STEP * frame.view.reference_scale
    stand_ins = dict(outlines)
    wanted = [_bits(set(s.kinds) - set(stand_ins.get(i, ()))) for i, s in enumerate(style.line_sets)]
    asked = np.isin(paths.line_set, list(stand_ins)) & (paths.placement != native.UNSET)
    sure = np.where(asked, np.array(wanted, np.uint32)[paths.line_set], np.uint32(0xFFFFFFFF))
    parted, outer, source = native.load().outer_parts(clipped, paths, frame.tracer, runs, sure, step, cancel)
    path = clipped.path[parted.piece]
    pen, inner = paths.line_set[path].astype(np.uint32), outer == 0  # the first pens are those of the sets
    kinds, placement = paths.kinds[source[inner]], paths.placement[path[inner]]
    found = np.full(len(kinds), native.UNSET, np.uint32)
    own = frame.notes.filters.placements or (None,) * len(wanted)
    for i in reversed(range(len(wanted))):
        found[(kinds & wanted[i] != 0) & (own[i] is None or own[i][placement] != 0)] = i
    pen[inner] = found
    return parted, pen


def _bits(kinds):
    """Definitions by name as the registry's bits."""
    return np.uint32(sum(1 << i for i, known in enumerate(native.load().line_definitions()) if known["name"] in kinds))
