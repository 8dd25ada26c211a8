# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits a monotone cubic (native/fovea/focus/transfer.h) to a densely sampled response curve with few control points."""

from functools import lru_cache

import numpy as np

TOLERANCE = 1e-3


def monotone_cubic(points, x):
    """Values at `x` of the monotone cubic through (n, 2) points with ascending x; constant beyond the first and the
    last point. The same interpolation as native/fovea/focus/transfer.cpp."""
    px, py = np.asarray(points, float).T
    if len(px) == 1:
        return np.full(len(x), py[0])
    chord = np.diff(py) / np.diff(px)
    before, after = np.concatenate([chord[:1], chord]), np.concatenate([chord, chord[-1:]])
    rising = before * after > 0
    slope = np.where(rising, 2 * before * after / np.where(rising, before + after, 1.0), 0.0)
    i = np.clip(np.searchsorted(px, x) - 1, 0, len(px) - 2)
    h = px[i + 1] - px[i]
    t = np.clip((x - px[i]) / h, 0, 1)
    s = 1 - t
    ends = s * s * (1 + 2 * t) * py[i] + t * t * (3 - 2 * t) * py[i + 1]
    return ends + h * s * t * (s * slope[i] - t * slope[i + 1])


@lru_cache(maxsize=64)
def fewest(points, kept, corners, most):
    """Indices of a subset of `points` (tuple of (x, y), x ascending) whose monotone cubic reproduces all of them within
    TOLERANCE, at most `most`; if that many do not suffice, the subset of least maximum error found. `kept`: indices
    that must stay; `corners`: indices where the curve has a corner, which needs a point on each side. Greedy: grows,
    then thins."""
    x, y = np.array(points).T
    first = {0, len(x) - 1, *kept}
    beside = {near for i in corners for near in (i - 1, i + 1) if 0 <= near < len(x)}
    if len(first | beside) <= most:
        first |= beside
    tried = [_grown(x, y, sorted(first), most, middle) for middle in (False, True)]
    near = [chosen for chosen in tried if _off(x, y, chosen).max() <= TOLERANCE]
    if not near:
        return tuple(min(tried, key=lambda chosen: _off(x, y, chosen).max()))
    return tuple(min((_thinned(x, y, chosen, kept) for chosen in near), key=len))


def _grown(x, y, chosen, most, middle):
    """Adds points to the subset `chosen` until the maximum error is within TOLERANCE or it has `most`: each where the
    error is largest, or with `middle` half way between the chosen points around that place."""
    while len(chosen) < most:
        off = _off(x, y, chosen)
        worst = int(off.argmax())
        if off[worst] <= TOLERANCE:
            break
        if middle:
            after = int(np.searchsorted(chosen, worst))
            worst = (chosen[after - 1] + chosen[after]) // 2
        if worst in chosen:
            break
        chosen = sorted({*chosen, worst})
    return chosen


def _thinned(x, y, chosen, kept):
    """Removes points not in `kept` as long as the error stays within TOLERANCE."""
    for i in list(chosen):
        fewer = [j for j in chosen if j != i]
        if i not in kept and len(fewer) > 1 and _off(x, y, fewer).max() <= TOLERANCE:
            chosen = fewer
    return chosen


def _off(x, y, chosen):
    return np.abs(monotone_cubic(np.stack([x[chosen], y[chosen]], axis=1), x) - y)
