# SPDX-License-Identifier: GPL-3.0-or-later
"""How a hand draws, fitted to drawings: how far strokes go on beyond the ends of lines, and how they wobble. Without
Blender."""

from dataclasses import dataclass

import numpy as np

from . import native, style
from .stages import REFERENCE_HEIGHT

LEAST_ENDS = 12  # of lines that strokes are near to
LEAST_OVERSHOOT = 1.0  # pixels: less is how strokes end
MOST_OF_LINE, LONGER, MOST_STEPS = 0.25, 1.05, 20  # strokes overshoot by that share of their line at most
LEAST_SAMPLES = 400  # pixels of lines beside which strokes are
LONGEST = 1 / 6  # of the diagonal: waves
AT_END, AT_FRAME = 1.0, 4.0  # pixels from a path's end, and from the frame's border
FADED = 0.5  # of a line's strength: weaker ends are where the threshold puts them


@dataclass(frozen=True)
class Hand:
    """Of a line set, in pixels of the frame; None: drawings do not show it."""

    name: str
    overshoot: float | None
    wobble: float | None
    wobble_length: float | None  # None where there is no wobble, too


def ended(found, size):
    """{px, offsets, is_free: (2 R,) uint8 whether their starts and ends are ends of whole paths, length: (R,) [px] of
    these} of the visible ones of line_arrays.seen, hidden ones included, in a frame of (width, height) pixels."""
    offsets, path, arc = found["offsets"], found["path"], found["arc_px"]
    first, last = offsets[:-1], offsets[1:] - 1
    count = int(path.max(initial=0)) + 1
    low, high = np.full(count, np.inf), np.full(count, -np.inf)
    np.minimum.at(low, path, arc[first])
    np.maximum.at(high, path, arc[last])
    is_end = np.stack([arc[first] - low[path] < AT_END, high[path] - arc[last] < AT_END], axis=1)
    ends = np.stack([first, last], axis=1)
    px = found["px"][ends]
    inside = ((px > AT_FRAME) & (px < np.array(size) - AT_FRAME)).all(axis=2)
    is_free = is_end & inside & (found["strength"][ends] > FADED) & ~found["closed"][:, None]
    seen = (found["invisibility"] == 0) & (found["shown"] > 0) & (np.diff(offsets) > 1)
    lengths = np.diff(offsets)
    return {
        "px": found["px"][np.repeat(seen, lengths)],
        "offsets": np.concatenate([[0], np.cumsum(lengths[seen])]).astype(np.int64),
        "is_free": is_free[seen].astype(np.uint8).ravel(),
        "length": (high - low)[path[seen]],
    }


def traced(trace, whole):
    """What trace(style) gives of each line set of a Style that has lines: of these alone, with what surfaces hide of
    them, none of them thinned out."""
    hidden, sets = (style.Hidden(),), whole.line_sets
    alone = [
        tuple(s.replace(hidden=hidden) if k == i else s.replace(kinds={}) for k, s in enumerate(sets))
        for i, one in enumerate(sets) if one.kinds
    ]  # fmt: skip
    return [trace(whole.replace(line_sets=each, elision=style.Elision())) for each in alone]


def hands(sets, traced, laid, every):
    """A Hand of each line set, or None where drawings have no strokes near to it. `traced`: what `ended` gives of each;
    `laid`: a registered_drawing.Laid of each drawing; `every`: the native Bitmap of all lines."""
    return [_hand(line_set, of, laid, every) if len(of["px"]) else None for line_set, of in zip(sets, traced)]


def _hand(line_set, of, laid, every):
    core, away, rows, beyond = native.load(), [], [np.zeros(1, np.int64)], []
    lengths = np.repeat(of["length"], 2)
    for each in laid:
        gray, cap = each.gray, 0.5 if line_set.pen.cap == "round" else 0.0
        if gray is None:
            gray, cap = core.GrayImage((255 * (1 - each.bitmap.pixels)).astype(np.uint8)), 0.5
        how = of["px"], of["offsets"], of["is_free"], every, every.usual_tolerance, cap
        found = core.StrokeCourses.of(gray, *how)
        away.append(found.away)
        rows.append(found.first[1:] + rows[-1][-1])
        beyond.append(np.stack([found.beyond.ravel(), lengths], axis=1))
    away = np.concatenate(away)
    if np.isfinite(away).sum() < LEAST_SAMPLES:
        return None
    longest = LONGEST * np.hypot(*every.pixels.shape)
    wobble, length = core.wobble_of(away, np.concatenate(rows), longest)
    return Hand(line_set.name, _overshoot(np.concatenate(beyond)), wobble, length if wobble else None)


def _overshoot(ends):
    """The median of how far strokes go on beyond ends (n, 2), with the lengths of their lines, that are so long that
    they may; None where there are too few."""
    ends, found = ends[np.isfinite(ends[:, 0])], None
    for _ in range(MOST_STEPS):
        if len(ends) < LEAST_ENDS:
            break
        before, found = found, float(np.median(ends[:, 0]))
        if found == before:
            break
        ends = ends[ends[:, 1] * MOST_OF_LINE > LONGER * found]
    return found if found is None or found >= LEAST_OVERSHOOT else 0.0


def with_hands(made, found, height):
    """A Style whose line sets are drawn by a Hand each, or None, in a frame of `height` px."""
    unit = REFERENCE_HEIGHT / height
    return made.replace(line_sets=tuple(_drawn_by(*each, unit) for each in zip(made.line_sets, found)))


def _drawn_by(line_set, hand, unit):
    if hand is None:
        return line_set
    pen = line_set.pen.replace(wobble=_rounded(hand.wobble * unit))
    if hand.wobble_length:
        pen = pen.replace(wobble_length=_rounded(hand.wobble_length * unit))
    overshoot = line_set.overshoot if hand.overshoot is None else _rounded(hand.overshoot * unit)
    return line_set.replace(pen=pen, overshoot=overshoot)


def _rounded(value):
    return float(f"{value:.4g}")
