# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares a drawing with its reference.

Drawings are mostly paper, so a share of all pixels would be insensitive; two measures of the ink are used instead:

- `share`: of the pixels that have ink in either picture, the share that differs at all. Detects changes of tone, width,
  color or style.
- `cluster`: the most pixels in a small window that have lost, gained or changed half of their ink or more. Detects one
  short line that is missing, new or moved, in a drawing with thousands. Slightly different antialiasing changes pixels
  by less than half, and rounding differences are scattered.

The limits are three times the differences between Blender 4.3 and 5.2 (mainly at the outlines of letters);
test_golden.py shows differences that exceed them.
"""

from dataclasses import dataclass, field

import numpy as np

LEVEL = 0.016  # differences up to here are none: as in Blender's own render tests, four levels of 8 bits
MOST_SHARE = 0.03
WINDOW = 16  # pixels
MOST_CLUSTER = 6  # pixels: half of a window's width, as a line one pixel wide


@dataclass(frozen=True)
class Comparison:
    share: float
    cluster: int  # pixels, of the worst window
    difference: np.ndarray = field(repr=False)  # (H, W, 3): gray ink is in both, red was lost, blue was gained

    @property
    def passed(self):
        return self.share <= MOST_SHARE and self.cluster <= MOST_CLUSTER

    def __str__(self):
        return (
            f"{self.share:.2%} of the ink differs (at most {MOST_SHARE:.0%}), "
            f"{self.cluster} px changed in one place (at most {MOST_CLUSTER})"
        )


def compare(reference, new):
    """Of two pictures (H, W, 4) with straight alpha. Pictures of two sizes have nothing in common."""
    if reference.shape != new.shape:
        return Comparison(1.0, reference.shape[0] * reference.shape[1], np.ones((1, 1, 3), np.float32))
    one, other = _premultiplied(reference), _premultiplied(new)
    paper = np.median(one.reshape(-1, 4), axis=0)
    ink_one, ink_other = _distance(one, paper), _distance(other, paper)
    apart = _distance(one, other)
    ink = np.maximum(ink_one, ink_other)
    differs = apart > LEVEL
    share = differs.sum() / max((ink > LEVEL).sum(), 1)
    changed = differs & (apart >= 0.5 * ink)
    return Comparison(float(share), _most_in_a_window(changed), _difference(ink_one, ink_other, changed))


def _premultiplied(picture):
    return np.concatenate([picture[..., :3] * picture[..., 3:], picture[..., 3:]], axis=2)


def _distance(one, other):
    """(H, W) of the channel that is farthest off."""
    return np.abs(one - other).max(axis=2)


def _most_in_a_window(mask):
    """The most pixels of a mask (H, W) in any square of WINDOW pixels."""
    sums = np.pad(mask, WINDOW).cumsum(axis=0).cumsum(axis=1)
    rows = sums[WINDOW:] - sums[:-WINDOW]
    return int((rows[:, WINDOW:] - rows[:, :-WINDOW]).max())


def _difference(ink_one, ink_other, changed):
    """What is in both in a light gray, what changed in full color, so that it is seen at a glance."""
    picture = np.repeat(1 - 0.3 * np.minimum(ink_one, ink_other)[..., None], 3, axis=2)
    picture[changed & (ink_one >= ink_other)] = (0.9, 0.1, 0.0)
    picture[changed & (ink_one < ink_other)] = (0.0, 0.2, 0.9)
    return picture.astype(np.float32)
