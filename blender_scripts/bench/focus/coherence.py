# SPDX-License-Identifier: GPL-3.0-or-later
"""Temporal coherence of elision.

Static lines: samples are matched between two frames by path id and arc length in object space; where both are visible,
a change of opacity is due to elision alone, computed per frame or smoothed in time. A change is explained by visibility
if another static line appears or disappears within NEAR times the lines' spacing: a whole run, or samples farther than
the spacing from the ends of their run; or a view-dependent line, where about as near there was none in the other frame.

View-dependent lines have no such correspondence: their ink is compared with that of the previous frame reprojected by
depth, and so is the share of ink that elision removes; both also with elision thresholded to a hard cut."""

from collections import deque
from dataclasses import dataclass, replace

import numpy as np

from . import reproject

LABEL = {"soft": "soft", "hard": "hard cut", "none": "no elision"}
LEAST_INK = 0.02  # mean ink around a pixel below which a share of it is undefined
HARD = 0.5  # threshold on the opacity for the hard cut
NEAR = 2.0  # radius, in units of the lines' spacing, in which an appearing line explains a change
SAME_PLACE = 0.1  # tolerance of a match's position, as a fraction of the distance between two samples


@dataclass(frozen=True)
class OnPaths:
    """Visible samples of static paths, in the order of the atlas."""

    index: np.ndarray  # (n,) in the atlas
    px: np.ndarray  # (n, 2)
    run: np.ndarray  # (n,)
    to_end_px: np.ndarray  # (n,) along the run to the nearer of its ends
    id: np.ndarray  # (n,) uint64 of the path
    arc: np.ndarray  # (n,) arc length along the path, in object space
    position: np.ndarray  # (n, 3) in object space
    shown: np.ndarray  # (n,) opacity factor of elision
    px_of_view: np.ndarray  # (k, 2) of samples of view-dependent lines


def on_paths(drawn):
    clipped, paths, places = drawn.frame.clipped, drawn.frame.paths, drawn.places()
    static = np.asarray(paths.of_view)[places.path] == 0
    first, t = places.segment[static], places.t[static]
    point, after = clipped.source[first], np.minimum(clipped.source[first] + 1, len(paths.points_obj) - 1)
    begin = clipped.source_t[first].astype(np.float64)
    end = np.where(clipped.source[first + 1] == point, clipped.source_t[first + 1], 1.0)
    if not drawn.view.orthographic:
        depth = -clipped.position_view[:, 2].astype(np.float64)
        near, far = depth[first], depth[first + 1]
        t = t * near / (far + t * (near - far))
    along = begin + t * (end - begin)
    arc, points = np.asarray(paths.arc_obj), np.asarray(paths.points_obj, np.float64)
    return OnPaths(
        places.index[static],
        places.px[static],
        places.run[static],
        places.to_end_px[static],
        np.asarray(paths.ids)[places.path[static]],
        arc[point] + along * (arc[after] - arc[point]),
        points[point] + along[:, None] * (points[after] - points[point]),
        places.shown[static],
        places.px[~static],
    )


def changes(before, after, distance):
    """(all, unexplained): absolute changes of opacity at the matched samples of two OnPaths, and at those of them near
    which no line appears or disappears. `distance`: spacing of lines in pixels."""
    (here, shown), (there, _) = match(before, after), match(after, before)
    change = np.abs(shown - before.shown[here])
    views = before.px_of_view, after.px_of_view
    causes = [before.px[lost(before, here, distance)], after.px[lost(after, there, distance)]]
    causes += [one[~disturbed(one, other, NEAR * distance)] for one, other in (views, views[::-1])]
    near = disturbed(before.px[here], np.concatenate(causes), NEAR * distance)
    return change, change[~near]


def lost(places, matched, distance):
    """Indices of samples that have no match in the other frame, and are more than `distance` pixels from the ends of
    their run or on a run without any match."""
    missing = np.ones(len(places.id), bool)
    missing[matched] = False
    known = np.bincount(places.run[matched], minlength=places.run.max() + 1 if len(places.run) else 0)
    return np.flatnonzero(missing & ((places.to_end_px > distance) | (known[places.run] == 0)))


def disturbed(px, causes, distance):
    """(n,) bool: whether any of `causes` (k, 2) is within about `distance` pixels of each `px` (n, 2): in the same or
    an adjacent cell of a grid."""
    cells = np.floor(px / distance).astype(np.int64) + 2
    rows, columns = (int(part) + 4 for part in (cells.max(axis=0) if len(cells) else (0, 0)))
    taken = np.zeros((rows, columns), bool)
    at = np.floor(causes / distance).astype(np.int64) + 2
    at = at[((at >= 0) & (at < (rows, columns))).all(axis=1)]
    for i in (-1, 0, 1):
        for j in (-1, 0, 1):
            taken[np.clip(at[:, 0] + i, 0, rows - 1), np.clip(at[:, 1] + j, 0, columns - 1)] = True
    return taken[cells[:, 0], cells[:, 1]]


def match(before, after):
    """((m,) indices of samples of `before` that have a match in `after`, (m,) opacity interpolated there)."""
    if not len(before.id) or not len(after.id):
        return np.zeros(0, np.int64), np.zeros(0)
    ids, number = np.unique(np.concatenate([before.id, after.id]), return_inverse=True)
    reach = max(before.arc.max(), after.arc.max()) + 1.0
    old = number[: len(before.id)] * reach + before.arc
    new = number[len(before.id) :] * reach + after.arc
    order = np.argsort(new, kind="stable")
    new = new[order]
    right = np.clip(np.searchsorted(new, old), 1, max(len(new) - 1, 1))
    right = np.minimum(right, len(new) - 1)
    left, right = order[right - 1], order[right]
    low, high = before.arc - after.arc[left], after.arc[right] - before.arc
    neighbors = (np.abs(after.index[left] - after.index[right]) == 1) & (after.id[left] == after.id[right])
    matched = neighbors & (after.id[left] == before.id) & (low >= 0) & (high >= 0)
    left, right, low, high = left[matched], right[matched], low[matched], high[matched]
    share = low / np.maximum(low + high, 1e-12)
    there = after.position[left] + share[:, None] * (after.position[right] - after.position[left])
    away = np.linalg.norm(there - before.position[matched], axis=1)
    same = away <= SAME_PLACE * np.linalg.norm(after.position[right] - after.position[left], axis=1) + 1e-6
    shown = after.shown[left] + share * (after.shown[right] - after.shown[left])
    return np.flatnonzero(matched)[same], shown[same]


def of_view(drawn):
    """{elision: (H, W) ink of the view-dependent lines} for soft elision, hard cut, and none."""
    clipped = drawn.frame.clipped
    path = np.repeat(np.repeat(clipped.path, np.diff(clipped.offsets)), clipped.sample_count)
    turning = (np.asarray(drawn.frame.paths.of_view)[path] != 0).astype(np.float32)
    shown = drawn.shown
    return {
        "soft": drawn.ink(shown * turning),
        "hard": drawn.ink((shown >= HARD) * turning),
        "none": drawn.ink(turning),
    }


def taken(inks, name, reach):
    """(H, W) share of the ink around each pixel that elision removes; NaN where there is less than LEAST_INK."""
    whole = reproject.mean_around(inks["none"], reach)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(whole > LEAST_INK, 1 - reproject.mean_around(inks[name], reach) / whole, np.nan)


class Static:
    """Accumulates changes of static lines over frames. `distance`: spacing of lines in pixels. Stores only the last
    frame."""

    def __init__(self, distance):
        self.distance, self.last, self.changes, self.matched = distance, None, [], []

    def see(self, drawn):
        last, self.last = self.last, on_paths(drawn)
        if last is not None:
            self.changes.append(changes(last, self.last, self.distance))
            self.matched.append(len(self.changes[-1][0]) / max(len(last.id), 1))


class OfView:
    """Accumulates changes of view-dependent lines over frames; as Static."""

    def __init__(self, distance):
        self.distance, self.last = distance, None
        self.differences = {"soft": [], "hard": [], "none": []}
        self.taken = {"soft": [], "hard": []}

    def see(self, drawn):
        now = of_view(drawn), reproject.Seen(drawn.view, drawn.image.depth)
        if self.last is not None:
            (inks, seen), (inks_now, seen_now) = self.last, now
            over, reach = seen_now.brought_over(seen), round(self.distance / 2)
            for name, found in self.differences.items():
                found.append(over.difference(inks_now[name], inks[name]))
            for name, found in self.taken.items():
                found.append(over.difference(taken(inks_now, name, reach), taken(inks, name, reach)))
        self.last = now


class InTime:
    """Passes frames to `watch` with elision smoothed over `frames` to each side, as soon as these have been seen."""

    def __init__(self, frames, watch):
        self.frames, self.watch, self._known = frames, watch, deque(maxlen=2 * frames + 1)

    def see(self, drawn):
        """Adds a frame; the first and the last `frames` are not passed on."""
        self._known.append((replace(drawn, image=None), drawn.frame.found_lines().shown_lines))
        if len(self._known) == self._known.maxlen:
            here, lines = self._known[self.frames]
            near = {k - self.frames: known for k, (_, known) in enumerate(self._known) if k != self.frames}
            shown = lines.smoothed(here.shown, near, self.frames) if near else here.shown
            self.watch.see(replace(here, shown=shown))


def rows(scene, alone, smoothed, of_view):
    """Result rows from a Static, {frames to each side: Static of smoothed elision}, and an OfView."""
    told = static_rows(alone, "", wanted=True)
    told += [("static lines: places found again, share", np.mean(alone.matched), None)]
    for frames, watch in smoothed.items():
        told += static_rows(watch, f", smoothed over {frames} to each side", wanted=False)
    return [{"figure": f, "scene": scene, "value": float(v), "wanted": w} for f, v, w in told + view_rows(of_view)]


def static_rows(watch, how, wanted):
    every, unexplained = (np.concatenate(parts) for parts in zip(*watch.changes))
    told = []
    for words, found, asked in (("", every, False), (", beyond visibility", unexplained, wanted)):
        found, words = found if len(found) else np.zeros(1), words + how
        told += [
            (f"static lines: mean change of opacity{words}", found.mean(), "<= .02" if asked else None),
            (f"static lines: largest change of opacity{words}", found.max(), "<= .35" if asked else None),
            (f"static lines: changes above .35, share{words}", (found > 0.35).mean(), "0" if asked else None),
            (f"static lines: places a frame{words}", len(found) / len(watch.changes), None),
        ]
    return told


def view_rows(watch):
    told = []
    for what, values in (("ink", watch.differences), ("share of ink taken", watch.taken)):
        mean, square = ({name: np.mean([pair[k] for pair in v]) for name, v in values.items()} for k in (0, 1))
        told += [(f"lines of the view: {what}, mean difference, {LABEL[name]}", mean[name], None) for name in mean]
        ratio = mean["soft"] / mean["hard"] if mean["hard"] else 1.0
        told += [(f"lines of the view: {what}, soft / hard", ratio, "<= .5")]
        # A fade has the same total change as a cut in smaller steps, so only the squares differ.
        ratio = square["soft"] / square["hard"] if square["hard"] else 1.0
        told += [(f"lines of the view: {what}, root mean square, soft / hard", ratio, None)]
    return told
