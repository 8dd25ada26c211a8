# SPDX-License-Identifier: GPL-3.0-or-later
"""The atlas samples that runs cover: their positions in the picture and their opacity factors of elision."""

from dataclasses import dataclass

import numpy as np

from ..quality import Samples


@dataclass(frozen=True)
class Places:
    """n samples inside the picture, in the order of the atlas, so along each run from its start."""

    index: np.ndarray  # (n,) in the atlas
    segment: np.ndarray  # (n,) of ClippedPaths
    t: np.ndarray  # (n,) screen fraction of the segment
    px: np.ndarray  # (n, 2)
    direction: np.ndarray  # (n, 2) unit vectors
    length_px: np.ndarray  # (n,) length of line per sample
    arc_px: np.ndarray  # (n,) arc length along the path
    path: np.ndarray  # (n,) of Paths
    run: np.ndarray  # (n,) of Runs
    to_end_px: np.ndarray  # (n,) along the run to the nearer of its ends
    shown: np.ndarray  # (n,) opacity factor of elision


def places_of(clipped, runs, shown, view):
    """Places in visible Runs; shown: (samples,) of the whole atlas. Elision is undefined outside the picture, so
    samples there are left out."""
    samples = Samples(clipped)
    visible = np.flatnonzero(np.asarray(runs.invisibility) == 0)
    piece, first, last = (np.asarray(part)[visible] for part in (runs.piece, runs.start_px, runs.end_px))
    # Lay all pieces out on one axis without overlap.
    arc = clipped.arc_px
    reach = (np.ptp(arc) if len(arc) else 0.0) + 1.0
    at = samples.piece * reach + (samples.arc_px - (arc.min() if len(arc) else 0.0))
    start = piece * reach + (first - (arc.min() if len(arc) else 0.0))
    run = np.searchsorted(start, at, side="right") - 1
    inside = run >= 0
    inside[inside] = (piece[run[inside]] == samples.piece[inside]) & (samples.arc_px[inside] <= last[run[inside]])
    begin, end = clipped.px[samples.segment], clipped.px[samples.segment + 1]
    px = begin + samples.t[:, None] * (end - begin)
    inside &= (px >= 0).all(axis=1) & (px < (view.width, view.height)).all(axis=1)
    index, segment, t, along = (part[inside] for part in (samples.index, samples.segment, samples.t, samples.arc_px))
    run = run[inside]
    way = (clipped.px[segment + 1] - clipped.px[segment]).astype(np.float64)
    length = np.hypot(*way.T)
    return Places(
        index=index,
        segment=segment,
        t=t,
        px=px[inside],
        direction=way / np.maximum(length, 1e-9)[:, None],
        length_px=length / clipped.sample_count[segment],
        arc_px=along,
        path=clipped.path[samples.piece[inside]],
        run=visible[run],
        to_end_px=np.minimum(along - first[run], last[run] - along),
        shown=np.asarray(shown)[index],
    )
