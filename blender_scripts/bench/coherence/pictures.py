# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames side by side, and one row of their pixels over time, in which dashes that hold still are smooth streaks, and
those that slide or jump are stairs. Pictures are (H, W), bottom row first; 0 is ink."""

import numpy as np
import sheet

from . import measures
from .strokes import sampled

STEP = 0.4  # pixels between the dots that a stroke is drawn of
HALF = 1  # pixels to each side of a line's
FRAMES = 4  # of a strip
REPEATS = 6  # rows of a frame's pixels


def drawn(strokes, size):
    """(H, W) picture of Strokes."""
    dots = sampled(strokes, STEP)
    inked = dots.opacity * measures.ink(dots.along, dots.whole_px, strokes.octaves)
    dark = np.zeros((size[1], size[0]))
    at = np.floor(dots.px).astype(np.int64)
    for row in range(-HALF, HALF + 1):
        for column in range(-HALF, HALF + 1):
            x, y = at[:, 0] + column, at[:, 1] + row
            inside = (x >= 0) & (y >= 0) & (x < size[0]) & (y < size[1])
            np.maximum.at(dark, (y[inside], x[inside]), inked[inside])
    return 1 - dark


def pane(frames):
    """(rows, columns) as slices: half as wide and two thirds as high as the pictures, where the middle one has the most
    ink."""
    ink = 1 - frames[len(frames) // 2]
    sides = (1, ink.shape[0] * 2 // 3), (0, ink.shape[1] // 2)
    starts = [(densest(ink.sum(axis=axis), length), length) for axis, length in sides]
    return tuple(slice(start, start + length) for start, length in starts)


def strip(frames, shown):
    """The same `pane` of the first FRAMES of some pictures, side by side."""
    panes = [frame[shown] for frame in frames[:FRAMES]]
    edge = np.full((len(panes[0]), 1), 0.5)
    return np.hstack([part for pane in panes for part in (pane, edge)][:-1])


def darkest_row(frames):
    return int(frames[len(frames) // 2].sum(axis=1).argmin())


def over_time(frames, row):
    """A row of pixels in all pictures: time runs downwards."""
    return np.repeat(np.stack([frame[row] for frame in frames[::-1]]), REPEATS, axis=0)


def write(frames, size, folder, name):
    """Writes FOLDER/NAME-strip.png and FOLDER/NAME-slice.png of a list of Strokes."""
    folder.mkdir(parents=True, exist_ok=True)
    made = [drawn(strokes, size) for strokes in frames]
    sheet.save(strip(made, pane(made)), folder / f"{name}-strip.png")
    sheet.save(over_time(made, darkest_row(made)), folder / f"{name}-slice.png")


def densest(sums, length):
    """Start of the `length` neighbors with the largest sum."""
    total = np.concatenate([[0], np.cumsum(sums)])
    return int((total[length:] - total[:-length]).argmax()) if len(sums) > length else 0
