# SPDX-License-Identifier: GPL-3.0-or-later
"""What a person practices setting gauges on before a session of a study: a simple shape, which tells how far off they
are. Without Blender."""

import random as randoms
from dataclasses import dataclass

import numpy as np

from . import gauges

GOOD, NOT_YET, FIRST = "Good: it lies on the surface", "Not yet: it is {:.0f} degrees off", "Drag the gauge"
# As the gradient in the page of studies: where the shape is lightest, and how far it fades, in sizes of its bounds from
# their upper left corner; and gray values at shares of that.
LIGHT, FADE = (0.4, 0.32), 0.75
TONES = (0.0, 0.55, 1.0), (0.957, 0.667, 0.267)


@dataclass(frozen=True)
class Shape:
    """The part of a Study that a gauge is drawn by."""

    size: tuple = gauges.EXAMPLE["size"]
    radius: float = gauges.EXAMPLE["radius"]


class Practice:
    """Gauges on the shape, one after the other: what a gauge_session.Session is to a Hand. Nothing of it is kept."""

    study = Shape()
    steps = gauges.EXAMPLE["places"]

    def __init__(self, random=None):
        self._random, self.at = random or randoms.SystemRandom(), 0
        self._show()

    def _show(self):
        self.normal, self.is_turned = gauges.anywhere(self._random), False

    @property
    def done(self):
        return self.at == len(self.steps)

    @property
    def place(self):
        return self.steps[self.at]

    def turn(self, n):
        self.normal, self.is_turned = n, True

    def next(self):
        """Goes on; False: the gauge has not been touched."""
        if self.done or not self.is_turned:
            return False
        self.at += 1
        self._show()
        return True

    def back(self):
        return False

    @property
    def is_good(self):
        return self.is_turned and self._off < gauges.EXAMPLE["good"]

    @property
    def _off(self):
        """Degrees."""
        return gauges.angles(self.normal, gauges.normal_of_example(self.place))

    @property
    def words(self):
        if self.is_good:
            return GOOD
        return NOT_YET.format(self._off) if self.is_turned else FIRST


def picture():
    """(H, W) float32 gray values of the shape in [0, 1] as displayed, bottom row first."""
    (width, height), (a, b, _), (x, y) = (gauges.EXAMPLE[key] for key in ("size", "axes", "middle"))
    column, row = np.arange(width) + 0.5 - x, (np.arange(height) + 0.5 - y)[:, None]
    away = np.hypot(0.5 + column / (2 * a) - LIGHT[0], 0.5 + row / (2 * b) - LIGHT[1])
    reach = np.hypot(column / a, row / b)
    inside = np.clip((1 - reach) * min(a, b) + 0.5, 0, 1)  # the outline's pixels are mixed
    shown = 1 + inside * (np.interp(away / FADE, *TONES) - 1)
    return shown[::-1].astype(np.float32)
