# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits a monotone cubic (native/fovea/focus/monotone_cubic.h) to a densely sampled response curve, with few points."""

from functools import lru_cache

import numpy as np

from . import native

TOLERANCE = 1e-3


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
    return np.abs(native.load().monotone_cubic(np.stack([x[chosen], y[chosen]], axis=1), x) - y)
