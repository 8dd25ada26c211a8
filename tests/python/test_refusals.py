# SPDX-License-Identifier: GPL-3.0-or-later
"""What the core refuses is a sentence for the user; what fails in Python's own code is not taken for it."""

import numpy as np
import pytest
from native_core import box, core, scene, view

from addon import native, pipeline, style


def draw(placed, **beside):
    pipeline.draw(placed, view((3, 4, 2), (0, 0, 0)), style.Style(), core.CpuBackend(), pipeline.options(), **beside)


def test_a_refused_argument_is_told_as_it_is():
    with pytest.raises(native.Refused, match="^camera: it looks in no direction; reset its location"):
        with native.refusals():
            core.View(np.zeros((4, 4)), np.eye(4), 4, 4, False, 0.1, 10.0)


def test_a_refused_step_of_a_frame_is_told_as_it_is():
    with pytest.raises(native.Refused, match="^frame: there is no scene"):
        draw(None)


def test_an_error_of_python_that_the_core_calls_stays_one():
    def broken(share, stage):
        raise ValueError("ink ran out")

    with pytest.raises(ValueError, match="ink ran out") as error:
        draw(scene([box().surface()]), progress=broken)
    assert not isinstance(error.value, native.Refused)


def test_other_errors_pass():
    with pytest.raises(KeyError), native.refusals():
        raise KeyError("ink")
