# SPDX-License-Identifier: GPL-3.0-or-later
"""The rank sum test (Wilcoxon, Mann and Whitney): whether values of one kind tend to be larger than others."""

import math

import numpy as np


def ranks(values):
    """(n,) ranks from 1 on; those of equal values are their mean."""
    _, which, counts = np.unique(values, return_inverse=True, return_counts=True)
    ends = np.cumsum(counts)
    return ((ends - counts + 1 + ends) / 2)[which]


def p_value(a, b):
    """The probability of rank sums as far apart as these, or farther, of two samples of one distribution, by the normal
    approximation with a correction for steps, and ties taken into account; None where a sample is empty, or all values
    are equal."""
    both, n, m = np.concatenate([a, b]), len(a), len(b)
    if not n or not m:
        return None
    count = n + m
    _, ties = np.unique(both, return_counts=True)
    spread = n * m / 12 * (count + 1 - (ties**3 - ties).sum() / (count * max(count - 1, 1)))
    if spread <= 0:
        return None
    away = abs(ranks(both)[:n].sum() - n * (count + 1) / 2)
    return math.erfc(max(away - 0.5, 0) / math.sqrt(2 * spread))
