"""How steady elision is from frame to frame.

Static lines: places on them, matched by the path's id and arc length in space, that are visible in both frames; what
changes there is elision alone. Lines of the view have no such places: their ink is compared with that of the frame
before, brought over by depth, and with elision switched to a hard cut beside it."""

from dataclasses import dataclass

import numpy as np

from . import reproject

HARD = 0.5  # opacity at which elision switches where it cuts
SAME_PLACE = 0.1  # of the way between two samples, by which a matched place may be elsewhere in space


@dataclass(frozen=True)
class OnPaths:
    """Visible samples of static paths, in the order of the atlas."""

    index: np.ndarray  # (n,) in the atlas
    id: np.ndarray  # (n,) uint64 of the path
    arc: np.ndarray  # (n,) along the path, in object space
    position: np.ndarray  # (n, 3) in object space
    shown: np.ndarray  # (n,)


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
        np.asarray(paths.ids)[places.path[static]],
        arc[point] + along * (arc[after] - arc[point]),
        points[point] + along[:, None] * (points[after] - points[point]),
        places.shown[static],
    )


def changes(before, after):
    """(m,) by how much the opacity of OnPaths changes at the m places of one that are also in the other."""
    if not len(before.id) or not len(after.id):
        return np.zeros(0)
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
    neighbours = (np.abs(after.index[left] - after.index[right]) == 1) & (after.id[left] == after.id[right])
    matched = neighbours & (after.id[left] == before.id) & (low >= 0) & (high >= 0)
    left, right, low, high = left[matched], right[matched], low[matched], high[matched]
    share = low / np.maximum(low + high, 1e-12)
    there = after.position[left] + share[:, None] * (after.position[right] - after.position[left])
    away = np.linalg.norm(there - before.position[matched], axis=1)
    same = away <= SAME_PLACE * np.linalg.norm(after.position[right] - after.position[left], axis=1) + 1e-6
    shown = after.shown[left] + share * (after.shown[right] - after.shown[left])
    return np.abs(shown - before.shown[matched])[same]


def of_view(drawn):
    """{elision: (H, W) ink of the lines that change with the view}: soft, hard, and none."""
    path = np.repeat(np.repeat(drawn.frame.clipped.path, np.diff(drawn.frame.clipped.offsets)), drawn.frame.clipped.sample_count)
    turning = (np.asarray(drawn.frame.paths.of_view)[path] != 0).astype(np.float32)
    shown = drawn.shown
    return {
        "soft": drawn.ink(shown * turning),
        "hard": drawn.ink((shown >= HARD) * turning),
        "none": drawn.ink(turning),
    }


class Watch:
    """Follows frames; keeps no more than the last."""

    def __init__(self):
        self.last, self.changes, self.matched = None, [], []
        self.differences = {"soft": [], "hard": [], "none": []}

    def see(self, drawn):
        now = on_paths(drawn), of_view(drawn), reproject.Seen(drawn.view, drawn.image.depth)
        if self.last is not None:
            (lines, inks, seen), (lines_now, inks_now, seen_now) = self.last, now
            self.changes.append(changes(lines, lines_now))
            self.matched.append(len(self.changes[-1]) / max(len(lines.id), 1))
            over = seen_now.brought_over(seen)
            for name, found in self.differences.items():
                found.append(over.difference(inks_now[name], inks[name]))
        self.last = now


def rows(scene, watch):
    found = np.concatenate(watch.changes)
    told = [
        ("static lines: opacity, mean change a frame", found.mean() if len(found) else 0.0, "<= .02"),
        ("static lines: opacity, largest change", found.max() if len(found) else 0.0, "<= .35"),
        ("static lines: changes above .35, share", (found > 0.35).mean() if len(found) else 0.0, "0"),
        ("static lines: places followed a frame", len(found) / len(watch.changes), None),
        ("static lines: places followed, share", np.mean(watch.matched), None),
    ]
    soft, hard, none = (np.mean(watch.differences[name]) for name in ("soft", "hard", "none"))
    told += [
        ("lines of the view: ink, mean difference, soft", soft, None),
        ("lines of the view: ink, mean difference, hard cut", hard, None),
        ("lines of the view: ink, mean difference, no elision", none, None),
        ("lines of the view: soft / hard", soft / hard if hard else 1.0, "<= .5"),
    ]
    return [{"figure": f, "scene": scene, "value": float(value), "wanted": wanted} for f, value, wanted in told]
