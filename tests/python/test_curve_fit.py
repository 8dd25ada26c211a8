# SPDX-License-Identifier: GPL-3.0-or-later
"""Points for response curves: few, and close to the curve that they approximate."""

import numpy as np
import pytest
from native_core import core

from addon import curve_fit

PLACES = 257
X = np.linspace(0, 1, PLACES)


def fitted(y, kept=(), corners=(), most=32):
    return np.array(curve_fit.fewest(tuple(zip(X.tolist(), y.tolist())), tuple(kept), tuple(corners), most))


def off(y, chosen):
    return np.abs(core.monotone_cubic(np.stack([X[chosen], y[chosen]], axis=1), X) - y).max()


def test_transfer_functions_follow_the_monotone_cubic():
    points = np.array([(0.0, 0.1), (0.2, 0.7), (0.45, 0.3), (0.5, 0.3), (0.9, 1.0)], np.float32)
    x = np.linspace(0, 1, 65)
    transfer = core.Transfer(0.0, 1.0, 1.0, points)
    assert np.allclose(core.monotone_cubic(points, x), transfer(x), atol=1e-6)
    assert np.allclose(core.monotone_cubic(points, points[:, 0]), points[:, 1], atol=1e-7)


def test_a_monotone_cubic_needs_points_and_is_constant_with_one():
    assert (core.monotone_cubic([(0.5, 0.25)], X) == 0.25).all()
    for points in ([], [(0.5, 0), (0.5, 1)], [(0.5, 0), (0.2, 1)]):
        with pytest.raises(ValueError, match="ascending x"):
            core.monotone_cubic(np.reshape(points, (-1, 2)), X)


CURVES = {
    "wave": 0.5 + 0.4 * np.sin(7 * X),
    "root": np.sqrt(X),
    "corners": np.interp(X, [0, 0.25, 0.5, 1], [0, 1, 0.25, 1]),
    "flat": np.full(PLACES, 0.5),
    "straight": X,
}


@pytest.mark.parametrize("name", CURVES)
def test_few_points_keep_to_the_curve(name):
    y = CURVES[name]
    chosen = fitted(y)
    assert off(y, chosen) <= curve_fit.TOLERANCE and len(chosen) <= 28
    for i in chosen[1:-1]:
        assert off(y, chosen[chosen != i]) > curve_fit.TOLERANCE, "one of them was not needed"


def test_a_straight_line_has_two_points():
    assert list(fitted(X)) == [0, PLACES - 1]


def test_corners_take_three_points_and_stay():
    y = CURVES["corners"]
    chosen = fitted(y, kept=(0, 64, 128, 256), corners=(0, 64, 128, 256))
    assert {0, 64, 128, 256} <= set(chosen.tolist()) and len(chosen) <= 8
    assert off(y, chosen) <= curve_fit.TOLERANCE


def test_there_are_never_more_points_than_a_file_may_have():
    y = 0.5 + 0.5 * np.sign(np.sin(60 * X))
    assert len(fitted(y, most=32)) == 32
