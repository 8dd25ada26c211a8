# SPDX-License-Identifier: GPL-3.0-or-later
"""Gauge studies: formulas of gauges, and the analysis of participants that are simulated, whose reliefs, noise and
lapses are known."""

import itertools
import json
import math

import numpy as np
import pytest
from gauge_people import ball, save, study
from gauges import analysis, formulas, observers, rank_sum, records
from native_core import core

RELIEF = core.BasRelief(0.7, (0.1, -0.05))


def session(settings_of, truth):
    """A Session of gauges with these true normals, set twice."""
    count = len(truth)
    normals = np.concatenate([settings_of(truth) for _ in (0, 1)])
    gauge, repeat = np.tile(np.arange(count), 2), np.repeat([0, 1], count)
    return records.Session("p", 0, "pencil", gauge, repeat, normals, np.full(2 * count, 4.0))


def test_a_gauge_that_is_dragged_leans_to_the_pointer_and_its_ellipse_tells_its_normal_again():
    radius = 20.0
    assert formulas.dragged((0, 0), radius) == pytest.approx((0, 0, 1))
    assert formulas.dragged((radius, 0), radius)[0] == pytest.approx(math.sin(math.radians(30 * 88 / 90)))
    for x, y in itertools.product((-90, -21, 3, 17, 40), (-50, -8, 0, 12, 39)):
        n = formulas.dragged((x, y), radius)
        assert np.linalg.norm(n) == pytest.approx(1) and n[2] >= math.cos(math.radians(88.001))
        major, minor, angle, pin = formulas.ellipse(n, radius)
        slant = math.acos(minor / major)
        assert formulas.normal(slant, angle) == pytest.approx(n, abs=1e-7)
        assert np.allclose(pin, 1.2 * radius * n[:2]) and n[0] * x >= 0 and n[1] * y >= 0
        assert slant == pytest.approx(math.asin(min(math.hypot(x, y) / 40, 1)) * 88 / 90)


def test_the_disc_that_is_drawn_is_the_projection_of_one_with_the_normal():
    n = formulas.normal(0.9, 2.2)
    disc, pin = formulas.lines(n, 20)
    height = -(disc @ n[:2]) / n[2]  # of the disc's points before the picture
    assert np.hypot(np.hypot(*disc.T), height) == pytest.approx(20) and np.allclose(pin, [(0, 0), 24 * n[:2]])


def test_halton_numbers_are_digits_in_reverse():
    assert formulas.halton(1, 7, 2).tolist() == [1 / 2, 1 / 4, 3 / 4, 1 / 8, 5 / 8, 3 / 8, 7 / 8]
    assert formulas.halton(1, 4, 3) == pytest.approx([1 / 3, 2 / 3, 1 / 9, 4 / 9])
    assert np.array_equal(formulas.halton(20, 5, 3), formulas.halton(18, 7, 3)[2:])


def test_places_lie_evenly_also_where_only_the_first_ones_are_taken():
    for count in (90, 180, 720):
        places = formulas.places(formulas.SKIP, count, (6, 6))
        tiles = np.histogram2d(*places.T, bins=3, range=[[0, 6]] * 2)[0]
        assert np.abs(tiles - count / 9).max() <= 4


def test_sets_share_out_all_gauges():
    for count, sizes in ((90, [30] * 3), (31, [16, 15]), (7, [7])):
        parts = [np.arange(count)[part] for part in formulas.sets(count)]
        assert sorted(map(len, parts), reverse=True) == sizes
        assert np.concatenate(parts).tolist() == list(range(count))


def test_normals_of_a_relief_are_those_of_its_surface():
    """Of the surface z = f(x, y), by differences."""

    def normal(z, x, y, h=1e-6):
        slope = (z(x + h, y) - z(x - h, y)) / (2 * h), (z(x, y + h) - z(x, y - h)) / (2 * h)
        return np.array([-slope[0], -slope[1], 1]) / math.hypot(*slope, 1)

    def surface(x, y):
        return math.sin(1.3 * x) + 0.4 * x * y

    def relief(x, y):
        return 0.7 * surface(x, y) + 0.1 * x - 0.05 * y

    for x, y in itertools.product((-1.2, 0.1, 0.9), repeat=2):
        assert RELIEF.of_normals([normal(surface, x, y)])[0] == pytest.approx(normal(relief, x, y), abs=1e-8)
    back = RELIEF.inverse().of_normals(RELIEF.of_normals([normal(surface, 0.3, 0.2)]))
    assert back[0] == pytest.approx(normal(surface, 0.3, 0.2), abs=1e-8)


def test_a_relief_is_found_again_also_beside_lapses():
    random = np.random.default_rng(2)
    truth = ball(random, 60)
    seen = RELIEF.of_normals(truth)
    seen[:12] = observers.anywhere(random, 12)
    found = core.BasRelief.fitted(truth, seen)
    assert found.depth == pytest.approx(0.7, abs=1e-3) and found.slope == pytest.approx((0.1, -0.05), abs=1e-3)
    flat = core.BasRelief.fitted(truth, np.tile([0.0, 0.0, 1.0], (60, 1)))
    assert flat.depth == pytest.approx(core.BasRelief.least_depth, rel=1e-3)
    with pytest.raises(ValueError, match="three pairs"):
        core.BasRelief.fitted(truth[:2], seen[:2])


def test_reliefs_of_simulated_participants_are_those_they_see():
    """60 settings with noise of about 10 degrees and 5 % lapses tell the depth of one session within about 7 %, and its
    slope within about .04, so many sessions are needed to tell that neither is off on the average."""
    random, found = np.random.default_rng(4), []
    for _ in range(150):
        truth = ball(random, 30)
        both = np.concatenate([truth, truth])
        relief = core.BasRelief.fitted(both, observers.settings(random, both, RELIEF))
        found.append((relief.depth, *relief.slope))
    mean, spread = np.mean(found, axis=0), np.std(found, axis=0)
    assert mean[0] == pytest.approx(0.7, rel=0.05) and mean[1:] == pytest.approx((0.1, -0.05), abs=0.02)
    assert spread[0] < 0.08 and spread[1:].max() < 0.06


def test_errors_after_the_fit_come_down_to_noise():
    random = np.random.default_rng(6)
    made = [ball(random, 30) for _ in range(40)]
    noise = [formulas.angles(observers.settings(random, n, core.BasRelief(), lapses=0), n).mean() for n in made]
    before, after = [], []
    for truth in made:
        each = session(lambda n: observers.settings(random, n, core.BasRelief(0.8, (0.4, -0.3)), lapses=0), truth)
        told = analysis.judged(core, type("Study", (), {"truth": truth, "even": len(truth)}), each)
        before.append(told.errors.mean())
        after.append(told.fitted_errors.mean())
    assert np.mean(before) > 1.5 * np.mean(noise) and np.mean(after) < 1.25 * np.mean(noise)
    assert np.mean(noise) == pytest.approx(np.degrees(np.sqrt(np.pi / 2 / 30)), rel=0.07)


def test_blind_participants_are_refused_and_careful_ones_count():
    random, careful, blind = np.random.default_rng(7), 0, 0
    for _ in range(300):
        truth = ball(random, 30)
        as_seen = session(lambda n: observers.settings(random, n, RELIEF), truth)
        careful += analysis.near_share(as_seen) >= analysis.LEAST_NEAR
        blind += analysis.near_share(session(lambda n: observers.anywhere(random, len(n)), truth)) < analysis.LEAST_NEAR
        assert analysis.spread(as_seen.normals) > 2 * analysis.LEAST_SPREAD
        turned = observers.anywhere(random, 1)
        constant = session(lambda n: np.tile(turned, (len(n), 1)), truth)
        assert analysis.spread(constant.normals) < analysis.LEAST_SPREAD
    assert blind >= 298 and careful >= 270


def test_blind_settings_have_the_errors_that_they_have_on_a_ball():
    """On a ball, 67.3 +- 32.0 degrees of every direction, and 45 of those to the viewer: the means over its picture."""
    random = np.random.default_rng(8)
    found = analysis.floors(core, random.permutation(whole_ball(360)))
    blind, facing = found["random"], found["facing"]
    assert blind["errors"].mean() == pytest.approx(67.3, abs=1.0)
    assert blind["errors"].std() == pytest.approx(32.0, abs=1.0)
    assert facing["errors"].mean() == pytest.approx(45.0, abs=1.5)
    assert blind["fitted_errors"].mean() < 50 and facing["fitted_errors"].mean() <= facing["errors"].mean()


def whole_ball(count):
    far, turn = np.sqrt((np.arange(count) + 0.5) / count), 2.399963 * np.arange(count)
    return np.stack([far * np.cos(turn), far * np.sin(turn), np.sqrt(1 - far**2)], axis=1)


def test_the_median_is_the_setting_nearest_to_the_others():
    normals = np.array([formulas.normal(math.radians(slant), 0.3) for slant in (0, 10, 14, 50, 80)])
    assert analysis.median(normals).tolist() == normals[2].tolist()
    found = analysis.medians(normals, np.array([1, 1, 1, 3, 3]), 4)
    assert found[1].tolist() == normals[1].tolist() and np.isnan(found[[0, 2]]).all()


def test_the_rank_sum_test_is_that_of_all_orders():
    a, b = [1.0, 4.0, 6.0, 9.0, 11.0, 12.0], [2.0, 3.0, 5.0, 7.0, 8.0]
    both = np.array(a + b)
    middle = len(a) * (len(both) + 1) / 2
    away = abs(rank_sum.ranks(both)[: len(a)].sum() - middle)
    sums = [abs(sum(order) - middle) for order in itertools.combinations(range(1, len(both) + 1), len(a))]
    exact = np.mean([each >= away for each in sums])
    assert rank_sum.p_value(a, b) == pytest.approx(exact, abs=0.05)
    assert rank_sum.ranks(np.array([5.0, 1.0, 5.0, 9.0])).tolist() == [2.5, 1, 2.5, 4]
    random = np.random.default_rng(9)
    found = [rank_sum.p_value(random.integers(0, 9, 40), random.integers(0, 9, 60)) for _ in range(800)]
    assert np.mean(np.array(found) < 0.1) == pytest.approx(0.1, abs=0.035)
    assert rank_sum.p_value([1, 2], [1000] * 50) < 0.05
    assert rank_sum.p_value([], a) is None and rank_sum.p_value([1, 1], [1]) is None


def test_an_analysis_tells_styles_apart_and_who_was_refused(tmp_path):
    made, random = study(tmp_path), np.random.default_rng(10)
    for number in range(6):
        for style, kappa in (("pencil", 60), ("shaded", 200)):
            save(made, f"{style}{number}", style, lambda n: observers.settings(random, n, RELIEF, kappa), number % 3)
    save(made, "blind", "pencil", lambda n: observers.anywhere(random, len(n)))
    save(made, "lazy", "shaded", lambda n: np.tile([0.0, 0.0, 1.0], (len(n), 1)))
    found = analysis.told(analysis.analyse(core, made, records.read_sessions(made)))
    told = json.loads(json.dumps(found, allow_nan=False))
    pencil, shaded = (told["styles"][style] for style in ("pencil", "shaded"))
    assert pencil["settings"] == shaded["settings"] == 360 and pencil["refused"] == shaded["refused"] == 1
    why = {each["participant"]: each["refused"] for each in pencil["sessions"] + shaded["sessions"]}
    assert "set alike twice" in why["blind"] and "all settings are alike" in why["lazy"]
    assert (
        shaded["fitted_errors"]["mean"] < pencil["fitted_errors"]["mean"] < told["floors"]["random"]["errors"]["mean"]
    )
    assert shaded["from_median"]["mean"] < pencil["from_median"]["mean"]
    (compared,) = told["p_values"]
    assert compared["styles"] == ["pencil", "shaded"] and compared["by_setting"] < 1e-4
    assert compared["by_session"] < 0.05
