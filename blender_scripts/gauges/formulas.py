# SPDX-License-Identifier: GPL-3.0-or-later
"""Gauges as discs on a picture, what dragging makes of them, and where they stand. gauge.js has the same formulas."""

import numpy as np
from command import addon_files

_shared = addon_files.loaded("gauges")  # what sessions in Blender need, too
STEEPEST, normal, ellipse, lines = _shared.STEEPEST, _shared.normal, _shared.ellipse, _shared.lines
dragged, sets, angles, EXAMPLE = _shared.dragged, _shared.sets, _shared.angles, _shared.EXAMPLE

RADIUS = 20 / 768  # of a gauge's disc, of the picture's height
STRING, SPACING = 15, 5 / 768  # gauges of a string, and between them, of the picture's height
SKIP = 20  # numbers of the Halton sequence that are left out, as the first ones of different bases go together


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


def string(middle, degrees, size):
    """(STRING, 2) places along a line through a place, from the left and the top of a picture of (width, height), both
    0 to 1, that rises by so many degrees."""
    along = np.array([np.cos(np.radians(degrees)), -np.sin(np.radians(degrees))])
    steps = np.arange(STRING) - (STRING - 1) / 2
    return np.multiply(middle, size) + SPACING * size[1] * steps[:, None] * along
