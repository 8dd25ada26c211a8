# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangulates a polygon by ear clipping. Meisters, "Polygons have ears", American Mathematical Monthly 1975."""

import numpy as np


def triangulate(points):
    """(n - 2, 3) corner indices of the triangles of a polygon (n, 3), projected along the dominant axis of its average
    normal. Always n - 2 triangles; degenerate or overlapping ones if the polygon intersects itself."""
    flat = _flatten(points)
    left = np.arange(len(points))
    triangles = []
    while len(left) > 3:
        ear = _find_ear(flat, left)
        triangles.append((left[ear - 1], left[ear], left[(ear + 1) % len(left)]))
        left = np.delete(left, ear)
    return np.array([*triangles, left])


def _flatten(points):
    """(n, 2), counterclockwise: projection along the dominant axis of Newell's normal."""
    following = np.roll(points, -1, axis=0)
    normal = np.cross(points, following).sum(axis=0)
    dropped = np.abs(normal).argmax()
    flat = points[:, [(dropped + 1) % 3, (dropped + 2) % 3]]
    return flat if normal[dropped] >= 0 else flat * (1, -1)


def _find_ear(flat, left):
    before, here, after = flat[np.roll(left, 1)], flat[left], flat[np.roll(left, -1)]
    convex = _turn(before, here, after) > 0
    hollows = here[~convex]
    for ear in np.flatnonzero(convex):
        a, b, c = before[ear], here[ear], after[ear]
        inside = (_turn(a, b, hollows) >= 0) & (_turn(b, c, hollows) >= 0) & (_turn(c, a, hollows) >= 0)
        corner = (hollows == a).all(axis=1) | (hollows == c).all(axis=1)
        if not (inside & ~corner).any():
            return ear
    return int(convex.argmax())


def _turn(a, b, c):
    """Twice the signed area of abc; positive if counterclockwise."""
    return (b - a)[..., 0] * (c - a)[..., 1] - (b - a)[..., 1] * (c - a)[..., 0]
