"""Drawn lines read back as polylines. Each function is one call of the native module, or few."""

import numpy as np

from .. import native


def compact(frame, runs):
    """The native CompactRuns of Runs: their points, whose arrays say where and what they are."""
    return native.load().compact(frame.clipped, frame.paths, runs)


def pens_of(frame, runs, ranges):
    """(R,) uint32 pen of each of Runs, native.UNSET: none draws it; `ranges` as of Style.pen_ranges."""
    core, rows = native.load(), np.array(ranges, np.uint32)
    return core.pens_of_runs(frame.clipped, runs, frame.paths.line_set, rows)


def at_points(frame, compacted, samples):
    """(M,) float32 at the points of CompactRuns: (samples,) values along a Frame's lines."""
    clipped = frame.clipped
    count = clipped.sample_count.astype(np.intp)
    segment = np.repeat(np.arange(len(count)), count)
    step = np.arange(len(segment)) - np.repeat(np.cumsum(count) - count, count)
    share = (step + 0.5) / count[segment]
    arc = clipped.arc_px[segment] * (1 - share) + clipped.arc_px[np.minimum(segment + 1, len(count) - 1)] * share
    # Pieces one after the other, far apart, so that one search finds the place on all.
    apart = 4 * max(1.0, float(np.abs(clipped.arc_px).max(initial=1.0)))
    piece_of_point = np.repeat(np.arange(len(clipped.path)), np.diff(clipped.offsets.astype(np.intp)))
    wanted = np.repeat(compacted.piece, np.diff(compacted.offsets.astype(np.intp))) * apart + compacted.arc_px
    places, sample = piece_of_point[segment] * apart + arc, clipped.sample_start[segment] + step
    order = np.argsort(places, kind="stable")
    return np.interp(wanted, places[order], samples[sample[order]]).astype(np.float32)

