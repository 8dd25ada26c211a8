# SPDX-License-Identifier: GPL-3.0-or-later
"""Points for a response curve: the fewest found whose monotone cubic (native/fovea/focus/transfer.h) keeps to a given one."""

from functools import lru_cache

import numpy as np

TOLERANCE = 1e-3


def monotone_cubic(points, x):
    """Values at `x` of the curve through (n, 2) points, x ascending; held beyond the first and the last. As
    native/fovea/focus/transfer.cpp joins them."""
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
    """Indices of those of a curve's points (a tuple of many (x, y), x ascending) that give it back within TOLERANCE, at
    most `most`, or as near as so many do. Tuples of indices: `kept`, those that stay; `corners`, those where the curve
    has a corner, which takes a point to each side."""
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
    """With a point more where the curve is farthest off, or in the middle of that stretch, until it is near."""
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
    """Without points that nothing needs."""
    for i in list(chosen):
        fewer = [j for j in chosen if j != i]
        if i not in kept and len(fewer) > 1 and _off(x, y, fewer).max() <= TOLERANCE:
            chosen = fewer
    return chosen


def _off(x, y, chosen):
    return np.abs(monotone_cubic(np.stack([x[chosen], y[chosen]], axis=1), x) - y)
