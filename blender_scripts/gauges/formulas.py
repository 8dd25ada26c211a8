# SPDX-License-Identifier: GPL-3.0-or-later
"""Gauges as discs on a picture, what dragging makes of them, and where they stand. gauge.js has the same formulas."""

import math

import numpy as np

RADIUS = 20 / 768  # of a gauge's disc, of the picture's height
PIN = 1.2  # length of a pin of which nothing is foreshortened, in radii
STEEPEST = 88.0  # degrees from the viewer: what a drag of two radii makes
SKIP = 20  # numbers of the Halton sequence that are left out, as the first ones of different bases go together


def normal(slant, tilt):
    """(3,) of a gauge that leans `slant` [rad] away from the viewer, to the side of `tilt` [rad] from the x axis."""
    return np.array([math.sin(slant) * math.cos(tilt), math.sin(slant) * math.sin(tilt), math.cos(slant)])


def ellipse(n, radius):
    """(major, minor, angle of the minor axis [rad], pin (2,)) of a gauge's disc with the normal n; the pin, from the
    middle, y up."""
    angle = math.atan2(n[1], n[0])
    return radius, radius * n[2], angle, (PIN * radius * n[0], PIN * radius * n[1])


def lines(n, radius):
    """(disc (k, 2), pin (2, 2)) of a gauge as polylines from its middle, y up."""
    major, minor, angle, pin = ellipse(n, radius)
    turn = np.linspace(0, 2 * np.pi, 65)[:, None]
    narrow, wide = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    return major * np.cos(turn) * wide + minor * np.sin(turn) * narrow, np.array([(0.0, 0.0), pin])


def dragged(offset, radius):
    """(3,) normal that a pointer makes which is dragged so far (x, y) from the middle, y up."""
    far = min(math.hypot(*offset) / (2 * radius), 1.0)
    return normal(math.asin(far) * STEEPEST / 90, math.atan2(offset[1], offset[0]))


def halton(first, count, base):
    """(count,) numbers in [0, 1) from number `first` on: the digits of the number in the base, behind the point in
    reverse order."""
    numbers, values, share = np.arange(first, first + count), np.zeros(count), 1.0
    while numbers.any():
        share /= base
        values += share * (numbers % base)
        numbers = numbers // base
    return values


def places(first, count, size):
    """(count, 2) places in a picture of (width, height), spread evenly however many one takes."""
    return np.stack([halton(first, count, base) for base in (2, 3)], axis=1) * size


def angles(a, b):
    """Degrees between unit vectors (..., 3)."""
    return np.degrees(np.arccos(np.clip((np.asarray(a) * b).sum(axis=-1), -1, 1)))


def sets(count, usual=30):
    """How gauges are shared out over sessions: slices of consecutive ones, of nearly equal sizes up to `usual`."""
    parts = -(-count // usual)
    ends = [round(i * count / parts) for i in range(parts + 1)]
    return [slice(first, end) for first, end in zip(ends, ends[1:])]
