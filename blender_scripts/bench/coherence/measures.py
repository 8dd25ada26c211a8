# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures between frames: which points of strokes are found again, and what has become of their dashes."""

from dataclasses import dataclass

import numpy as np

from . import PERIOD
from .strokes import sampled

STEP = 3.0  # pixels between samples
LEAST = STEP / 2  # pixels: of shorter strokes nobody sees dashes
REACH = 3.0  # pixels within which a moved point's line must lie
SAME_WAY = 0.7  # cosine between the directions of a line found again
SAME_DEPTH = 0.02  # of the distance from the eye
INKED = 2 / 3  # of a period
MIDDLE = INKED / 2  # coordinate in the middle of the ink: a line without dashes has it all along


@dataclass(frozen=True)
class Match:
    """m samples of one frame that are on strokes of the next one."""

    here: np.ndarray  # (m,) of the earlier samples
    there: np.ndarray  # (m,) of the later ones: the nearest
    along: np.ndarray  # (m,) the dashes' coordinate there, right beside the moved point


def match(px, depth, before, after):
    """The Match of Samples `before`, whose points have moved to `px` (n, 2) and `depth` (n,), with Samples `after`."""
    nearest = np.full(len(px), -1)
    best = np.full(len(px), REACH)
    if len(px) and len(after.px):
        low = np.minimum(px.min(axis=0), after.px.min(axis=0)) - 2 * REACH
        cell, cell_after = (np.floor((p - low) / REACH).astype(np.int64) for p in (px, after.px))
        wide = max(cell[:, 0].max(), cell_after[:, 0].max()) + 2
        order = np.argsort(cell_after[:, 1] * wide + cell_after[:, 0], kind="stable")
        keys = (cell_after[:, 1] * wide + cell_after[:, 0])[order]
        for row in (-1, 0, 1):
            wanted = (cell[:, 1] + row) * wide + cell[:, 0]
            first, last = (np.searchsorted(keys, wanted + k, side) for k, side in ((-1, "left"), (1, "right")))
            for k in range(int((last - first).max(initial=0))):
                i = np.flatnonzero(first + k < last)
                j = order[first[i] + k]
                away = np.hypot(*(px[i] - after.px[j]).T)
                closer = away < best[i]
                closer &= np.abs((before.direction[i] * after.direction[j]).sum(axis=1)) > SAME_WAY
                closer &= np.abs(after.depth[j] - depth[i]) < SAME_DEPTH * np.abs(depth[i])
                nearest[i[closer]], best[i[closer]] = j[closer], away[closer]
    here = np.flatnonzero(nearest >= 0)
    there = nearest[here]
    beside = ((px[here] - after.px[there]) * after.direction[there]).sum(axis=1)
    return Match(here, there, after.along[there] + beside * after.per_px[there])


def carried(points, before, after):
    """Points (n, 3) that move with triangles whose corners (3, n, 3) `before` become those `after`."""
    first, *sides = before[0], before[1] - before[0], before[2] - before[0]
    normal = np.cross(*sides)
    square = np.maximum((normal**2).sum(axis=1), 1e-30)
    way = points - first
    second, third = ((np.cross(*pair) * normal).sum(axis=1) / square for pair in ((way, sides[1]), (sides[0], way)))
    shares = np.stack([1 - second - third, second, third])[:, :, None]
    return points + (shares * (after - before)).sum(axis=0)


def octave(whole_px, octaves):
    """(periods a unit of the coordinate is divided in, weight in [0, 1] of these) of the finer of the two blended
    levels; the coarser one has half as many."""
    if not octaves:
        return np.ones_like(whole_px), np.ones_like(whole_px)
    lengths = np.maximum(whole_px, 1.0) / PERIOD
    finer = np.exp2(np.ceil(np.log2(lengths)))
    share = lengths / finer  # as shaders/shared/stroke.glsl has it
    return finer, (share - 0.5) / (share - 0.5 + np.sqrt(0.5) * (1 - share))


def heavier(whole_px, octaves):
    """Periods of the level that has most of the ink."""
    finer, weight = octave(whole_px, octaves)
    return np.where(weight >= 0.5, finer, finer / 2)


def ink(along, whole_px, octaves):
    """Of dashes, in [0, 1]: the mean over a pixel, as in a picture. At points alone, dashes that begin right at one
    would come and go by rounding."""
    finer, weight = octave(whole_px, octaves)
    half = 0.5 / np.maximum(whole_px, 1.0)

    def mean(periods):
        return (inked((along + half) * periods) - inked((along - half) * periods)) / (2 * half * periods)

    return weight * mean(finer) + (1 - weight) * mean(finer / 2)


def inked(periods):
    """The part of so many periods that is ink."""
    whole = np.floor(periods)
    return INKED * whole + np.minimum(periods - whole, INKED)


class Steadiness:
    """Accumulates measures over frames. Keeps the samples of the last one."""

    def __init__(self):
        self.last, self.counts, self.lines, self.links = None, [], [], []
        self.slide, self.stretch, self.popping = [], [], []

    def see(self, strokes, moved):
        """Adds a frame's Strokes. `moved`: function of (n, 3) points of the last frame to ((n, 2) pixels, (n,) depths)
        in this one."""
        now, last = sampled(strokes, STEP), self.last
        self.counts.append(strokes.count)
        self.lines.append(strokes.lines)
        self.last = now, strokes.octaves
        periods = heavier(now.whole_px, strokes.octaves)
        self.stretch.append(np.abs(np.log2(now.whole_px / periods / PERIOD))[now.length_px > LEAST])
        if last is None:
            return
        before, octaves = last
        found = match(*moved(before.world), before, now)
        here = found.here
        periods = heavier(before.whole_px[here], octaves)
        turn = (found.along - before.along[here]) * periods
        slide = np.abs(turn - np.rint(turn)) * before.whole_px[here] / periods
        self.slide.append(slide[before.length_px[here] > LEAST])
        was = before.opacity * ink(before.along, before.whole_px, octaves)
        becomes = np.zeros_like(was)  # none where there is no line any more
        there = found.there
        becomes[here] = now.opacity[there] * ink(found.along, now.whole_px[there], octaves)
        self.popping.append(np.abs(becomes - was)[before.length_px > LEAST])
        self.links.append((before.run[here], now.run[found.there], before.run, now.run))

    def figures(self, dashed=True):
        """`dashed`: else nothing slides, nor is it stretched."""
        slide, stretch, popping = (
            np.concatenate(parts) if parts else np.zeros(0) for parts in (self.slide, self.stretch, self.popping)
        )
        changes = np.abs(np.diff(self.counts))
        told = None not in self.lines
        return {
            "changes_per_frame": rounded(changes.mean()),
            "unexplained_per_frame": rounded((changes * (np.diff(self.lines) != 0)).mean()) if told else None,
            "slide_median_px": at_share(slide, 0.5) if dashed else None,
            "slide_p95_px": at_share(slide, 0.95) if dashed else None,
            "stretch_median": at_share(stretch, 0.5) if dashed else None,
            "stretch_p95": at_share(stretch, 0.95) if dashed else None,
            "blinks_per_1000": rounded(1000 * blinks(self.counts, self.links) / max(sum(self.counts), 1)),
            "popping": rounded(popping.mean()) if len(popping) else None,
        }


def blinks(counts, links):
    """Number of strokes that no stroke of the frame before becomes, and that are gone two frames later. `counts`:
    strokes per frame; `links`: per pair of frames the strokes (before, after) of each sample found again, and those of
    all samples of the two. One becomes another that holds at least half the samples of the shorter of the two."""
    steps = [linked(*link, *size) for link, size in zip(links, zip(counts, counts[1:]))]
    ahead = [np.zeros(n, np.int64) for n in counts]  # frames that each will still live
    born = [np.ones(n, bool) for n in counts]
    for k in reversed(range(len(steps))):
        here, there = steps[k]
        np.maximum.at(ahead[k], here, ahead[k + 1][there] + 1)
    for k, (_, there) in enumerate(steps):
        born[k + 1][there] = False
    # Of the first frame nobody knows the birth, of the last two the death.
    return int(sum((born[k] & (ahead[k] < 2)).sum() for k in range(1, len(counts) - 2)))


def linked(here, there, all_here, all_there, count_here, count_there):
    """((l,), (l,)) strokes of two frames that are the same."""
    pairs, found = np.unique(here.astype(np.int64) * max(count_there, 1) + there, return_counts=True)
    first, second = np.divmod(pairs, max(count_there, 1))
    size_here, size_there = np.bincount(all_here, minlength=count_here), np.bincount(all_there, minlength=count_there)
    same = 2 * found >= np.minimum(size_here[first], size_there[second])
    return first[same], second[same]


def at_share(values, share):
    return rounded(np.quantile(values, share)) if len(values) else None


def rounded(value):
    return round(float(value), 4)
