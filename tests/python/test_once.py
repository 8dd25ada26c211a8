# SPDX-License-Identifier: GPL-3.0-or-later
"""Passes shared by several stages of a picture give the same results as if each stage computed its own."""

import json

import numpy as np
import pytest
from native_core import box, core, scene, view

from addon import pipeline, style

AWAY = {"pen": {"width": 3}, "pen_away": {"width": 3, "opacity": 0.1}}


def frame(model, **options):
    matrices = np.array([np.eye(4), np.eye(4)])
    matrices[0][0, 3], matrices[1][0, 3] = -2, 2
    placed, seen = scene([box().surface()] * 2, matrices), view((0, -12, 3), (0, 0, 0))
    focus = {"model": model, "points": [{"object": "A", "at": [-2, 0, 0], "near": 0.5, "far": 3}]}
    sets = [{"kinds": {"contour": {}, "crease": {}}, **AWAY}]
    chosen = style.parse(json.dumps({"schema": style.SCHEMA, "line_sets": sets, "focus": focus}))
    notes = core.Overrides(objects=(("A",), ("B",)), objects_of_placement=np.arange(2, dtype=np.uint32))
    return pipeline.frame(placed, seen, chosen, core.CpuBackend(), pipeline.options(**options), notes=notes)


def passes(model, **options):
    made = frame(model, **options)
    made.picture()
    return made.passes()


@pytest.mark.parametrize("model", ["object", "scene"])
def test_depth_and_focus_drawn_with_a_picture_are_those_made_alone(model):
    together = passes(model, with_depth=True, with_focus=True)
    alone = frame(model)
    assert together["focus"].min() < 0.5 and together["focus"].max() == 1
    np.testing.assert_array_equal(together["focus"], alone.focus_of_pixels())
    np.testing.assert_array_equal(together["depth"], passes(model, with_depth=True)["depth"])


@pytest.mark.parametrize("model", ["object", "scene"])
def test_a_picture_without_passes_has_the_same_lines(model):
    with_passes, lines_alone = passes(model, with_depth=True, with_focus=True), passes(model)
    assert lines_alone["depth"] is None and lines_alone["focus"] is None
    np.testing.assert_array_equal(with_passes["lines"], lines_alone["lines"])
