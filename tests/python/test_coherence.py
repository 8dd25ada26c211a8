# SPDX-License-Identifier: GPL-3.0-or-later
"""The measures of `fovea bench coherence`, on strokes whose motion is known."""

from dataclasses import replace

import numpy as np
import pytest
from bench.coherence import PERIOD, measures
from bench.coherence.strokes import Strokes, divided, mixed, sampled

PX_OF_UNIT = 50.0  # pixels of a unit of the scene, which is seen from above


def lines(*ends, shift=0.0, whole_px=PERIOD, octaves=False, opacity=1.0):
    """Strokes along y = 0, 1, ... from x0 to x1 each, whose dashes are moved by `shift` pixels."""
    world = np.array([(x, y, 0.0) for y, pair in enumerate(ends) for x in pair], float).reshape(-1, 3)
    offsets = np.arange(0, 2 * len(ends) + 1, 2)
    along = (PX_OF_UNIT * world[:, 0] + shift) / whole_px
    ones = np.ones(len(world))
    return Strokes(offsets, PX_OF_UNIT * world[:, :2], world, ones, along, whole_px * ones, octaves, opacity * ones)


def seen(points, by=0.0):
    moved = points + (by, 0.0, 0.0)
    return PX_OF_UNIT * moved[:, :2], np.ones(len(points))


def figures(*frames, by=0.0):
    steady = measures.Steadiness()
    for strokes in frames:
        steady.see(strokes, lambda points: seen(points, by))
    return steady.figures()


def test_strokes_that_stay_neither_slide_nor_pop_nor_blink():
    told = figures(*[lines((0, 4), (1, 5))] * 4)
    assert told["slide_p95_px"] == pytest.approx(0, abs=1e-9) and told["stretch_p95"] == 0
    assert told["popping"] == told["blinks_per_1000"] == told["changes_per_frame"] == 0


def test_changes_of_strokes_are_unexplained_where_the_number_of_whole_lines_changes():
    one, two = lines((0, 4)), lines((0, 4), (1, 5))
    frames = [replace(one, lines=2), replace(two, lines=2), replace(one, lines=1), replace(one, lines=2)]
    told = figures(*frames)
    assert told["changes_per_frame"] == pytest.approx(2 / 3, abs=1e-4)
    assert told["unexplained_per_frame"] == pytest.approx(1 / 3, abs=1e-4)
    assert figures(one, two)["unexplained_per_frame"] is None


def test_dashes_that_move_with_a_moving_line_hold_still():
    step = 0.04
    frames = [lines((k * step, 4 + k * step), shift=-PX_OF_UNIT * k * step) for k in range(4)]
    assert figures(*frames, by=step)["slide_p95_px"] == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize(("shift", "slide"), [(3.0, 3.0), (-5.0, 5.0), (PERIOD, 0.0), (PERIOD - 2.0, 2.0)])
def test_slide_is_the_way_of_dashes_to_the_nearest_ones(shift, slide):
    told = figures(*[lines((0, 4), shift=k * shift) for k in range(3)])
    assert told["slide_median_px"] == pytest.approx(slide, abs=1e-6)
    assert (told["popping"] > 0) == (slide > 0)


def test_stretch_is_that_of_the_level_that_has_most_of_the_ink():
    for octave, stretch in ((0.0, 0.0), (0.25, 0.25), (0.5, 0.5), (0.75, 0.25), (1.0, 0.0), (3.25, 0.25)):
        told = figures(lines((0, 4), whole_px=PERIOD * 2**octave, octaves=True))
        assert told["stretch_median"] == pytest.approx(stretch, abs=1e-4), octave


def test_a_line_without_dashes_pops_by_what_its_opacity_changes():
    def plain(opacity):
        dashed = lines((0, 4), opacity=opacity)
        return replace(dashed, along=np.full_like(dashed.along, measures.MIDDLE))

    told = figures(plain(1.0), plain(0.75), plain(0.5), by=0.013)
    assert told["popping"] == pytest.approx(0.25, abs=1e-3)
    assert told["slide_p95_px"] == told["stretch_p95"] == 0


def test_of_what_has_no_dashes_neither_slide_nor_stretch_is_told():
    steady = measures.Steadiness()
    for _ in range(2):
        steady.see(lines((0, 4)), seen)
    told = steady.figures(dashed=False)
    assert told["slide_median_px"] is told["slide_p95_px"] is told["stretch_median"] is told["stretch_p95"] is None
    assert told["popping"] == 0


def test_levels_blend_without_a_jump_in_ink():
    along = np.linspace(0, 1, 999)
    whole = PERIOD * np.array([2 - 1e-9, 2 + 1e-9])
    before, after = (measures.ink(along, np.full(999, each), True) for each in whole)
    assert np.abs(before - after).max() < 1e-6


def test_points_move_with_the_triangles_that_they_lie_on():
    random = np.random.default_rng(5)
    before, after = random.uniform(-1, 1, (2, 3, 20, 3))
    shares = random.dirichlet((1, 1, 1), 20).T[:, :, None]
    on, becomes = (shares * before).sum(axis=0), (shares * after).sum(axis=0)
    assert measures.carried(on, before, after) == pytest.approx(becomes)
    beside = on + 0.1 * np.cross(before[1] - before[0], before[2] - before[0])
    assert measures.carried(beside, before, after) == pytest.approx(becomes + beside - on)


def test_dashes_that_begin_at_a_point_do_not_pop_by_rounding():
    for octaves in (False, True):
        frames = [lines((0, 0.08), whole_px=3 * PERIOD, shift=shift - 2.0, octaves=octaves) for shift in (-1e-4, 1e-4)]
        assert figures(*frames)["popping"] < 1e-3, octaves


def test_a_dash_has_its_share_of_ink():
    along, whole = np.linspace(0, 1, 999, endpoint=False), np.full(999, float(PERIOD))
    found = measures.ink(along, whole, False)
    assert found.mean() == pytest.approx(measures.INKED, abs=1e-3)
    assert found.min() == pytest.approx(0, abs=1e-9) and found.max() == pytest.approx(1)
    one_pixel = ((found > 0.01) & (found < 0.99)).mean() * PERIOD
    assert one_pixel == pytest.approx(2, abs=0.1)  # at both ends


def test_a_stroke_of_two_frames_is_a_blink_and_one_of_three_is_not():
    one, both = lines((0, 4)), lines((0, 4), (0, 4))
    blink = figures(one, both, both, one, one)
    assert blink["blinks_per_1000"] == pytest.approx(1000 / 7, abs=1e-3) and blink["changes_per_frame"] == 0.5
    assert figures(one, both, both, both, one, one)["blinks_per_1000"] == 0
    assert figures(one, one, one, both, both)["blinks_per_1000"] == 0  # nobody knows how long it lives


def test_ink_where_no_line_is_left_counts_as_gone():
    told = figures(lines((0, 4), (0, 4)), lines((0, 4)))
    assert told["popping"] == pytest.approx(measures.INKED / 2, abs=0.02)


def test_ink_that_grows_fainter_pops_by_what_it_loses():
    told = figures(lines((0, 4)), lines((0, 4), opacity=0.75))
    assert told["popping"] == pytest.approx(measures.INKED / 4, abs=0.01)


def test_lines_are_divided_evenly_in_the_image_and_keep_their_points():
    px = np.array([(0, 0), (10, 0), (10, 1), (50, 5), (50, 9)], float)
    offsets, point, t, s = divided(np.array([0, 3, 5]), px, np.array([1.0, 3.0, 1.0, 1.0, 1.0]), 4.0)
    assert offsets.tolist() == [0, 5, 7] and point.tolist() == [0, 0, 0, 1, 2, 3, 4]
    assert mixed(px, point, t)[:, 0] == pytest.approx([0, 10 / 3, 20 / 3, 10, 10, 50, 50])
    assert s[1] == pytest.approx((1 / 3) / (3 - 2 / 3)) and s[3:].tolist() == [0, 0, 0, 0]


def test_samples_lie_in_the_middles_of_equal_parts_in_the_image_and_in_space():
    strokes = lines((0, 2))
    found = sampled(strokes, 10.0)
    assert found.px[:, 0] == pytest.approx(np.arange(5, 100, 10.0))
    near = replace(strokes, depth=np.array([1.0, 3.0]))
    depth = sampled(near, 100.0).depth  # one sample, in the middle of the image
    assert depth == pytest.approx(1.5)  # where 1 / depth is the mean of those of the ends
