# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines as polylines in arrays."""

import numpy as np
from native_core import core  # noqa: F401 the module that the extension asks for

from addon import line_arrays


def lines(*strengths):
    """Polylines along x with points of such strengths."""
    counts = [len(of) for of in strengths]
    px = np.concatenate([np.stack([np.arange(n), np.full(n, k)], 1) for k, n in enumerate(counts)]).astype(np.float32)
    return {
        "px": px,
        "offsets": np.concatenate([[0], np.cumsum(counts)]),
        "strength": np.concatenate(strengths).astype(np.float32),
    }


def parts(found):
    px, offsets = found
    return [[tuple(map(int, point)) for point in px[a:b]] for a, b in zip(offsets, offsets[1:])]


def test_lines_are_cut_where_they_are_weak():
    seen = lines([0.0, 0.5, 0.9, 0.1, 0.7, 0.8], [0.6, 0.7], [0.1, 0.2])
    assert parts(line_arrays.strong(seen, 0.3)) == [[(1, 0), (2, 0)], [(4, 0), (5, 0)], [(0, 1), (1, 1)]]


def test_lines_of_any_strength_are_left_as_they_are():
    seen = lines([0.0, 0.5], [0.0])
    px, offsets = line_arrays.strong(seen, 0.0)
    assert px is seen["px"] and offsets is seen["offsets"]
    assert parts(line_arrays.strong(seen, 0.9)) == []
