# SPDX-License-Identifier: GPL-3.0-or-later
"""Strings of gauges: profiles and bends of known surfaces, and what simulated people see along them."""

import json
import math

import numpy as np
import pytest
from command import study as command
from gauge_people import save, study
from gauges import analysis, formulas, observers, records, report, strings
from native_core import core

RADIUS, MIDDLE, SIZE = 300.0, (500.0, 380.0), (1024, 768)  # of a ball in the picture
RIGHT = np.array([1.0, 0.0])
NONE = core.BasRelief()


def ball_at(places):
    """(n, 3) normals of the ball at places of the picture."""
    across = (places - MIDDLE) * (1, -1) / RADIUS
    return np.concatenate([across, np.sqrt(1 - (across**2).sum(axis=1))[:, None]], axis=1)


def with_strings(tmp_path, *asked, truth_at=ball_at):
    """A study of 60 gauges on a ball and of strings (u, v, degrees), whose normals are those of truth_at(places)."""
    study(tmp_path, count=60)
    told = json.loads((tmp_path / records.STUDY).read_text())
    told["strings"] = []
    for each in asked:
        places = formulas.string(each[:2], each[2], SIZE)
        first = len(told["gauges"])
        told["gauges"] += [{"x": x, "y": y, "n": list(n)} for (x, y), n in zip(places, truth_at(places))]
        told["strings"].append([first, len(told["gauges"])])
    (tmp_path / records.STUDY).write_text(json.dumps(told))
    return records.read_study(tmp_path)


def test_a_string_is_fifteen_places_five_pixels_apart_through_its_middle():
    places = formulas.string((0.5, 0.25), 90, SIZE)
    assert places.shape == (15, 2) and places[7] == pytest.approx((512, 192))
    assert np.diff(places, axis=0) == pytest.approx(np.tile((0.0, -5.0), (14, 1))), "upwards"
    along, spacing = strings.line(formulas.string((0.3, 0.6), 30, (512, 384)))
    assert along == pytest.approx((math.cos(math.pi / 6), 0.5)) and spacing == pytest.approx(2.5)


@pytest.mark.parametrize("degrees", [0, 40, 90, 200])
def test_the_profile_along_a_string_is_that_of_the_surface(degrees):
    places = formulas.string((0.45, 0.4), degrees, SIZE)
    height = RADIUS * ball_at(places)[:, 2]
    found = strings.profile(ball_at(places), *strings.line(places))
    assert found == pytest.approx(height - height[0], abs=0.02)


def test_curvature_is_that_of_a_cylinder_also_where_it_is_hollow():
    x = np.arange(-35, 36, 5.0)
    for radius in (60.0, -90.0):
        normals = np.stack([x / radius, np.zeros(15), np.sqrt(1 - (x / radius) ** 2)], axis=1)
        assert strings.curvature(normals, RIGHT, 5.0) == pytest.approx(np.full(14, 1 / radius), rel=2e-3)
    flat = np.tile([0.6, 0.0, 0.8], (15, 1))
    assert not strings.curvature(flat, RIGHT, 5.0).any()
    assert strings.profile(flat, RIGHT, 5.0) == pytest.approx(-0.75 * 5 * np.arange(15))


def test_two_strings_are_a_session_after_those_of_evenly_spread_gauges(tmp_path):
    made = with_strings(tmp_path, (0.45, 0.4, 0), (0.5, 0.5, 90), (0.4, 0.5, 45))
    assert made.even == 60 and made.strings == [(60, 75), (75, 90), (90, 105)]
    parts = formulas.sets(len(made.truth), made.strings)
    assert [(part.start, part.stop) for part in parts] == [(0, 30), (30, 60), (60, 90), (90, 105)]
    assert formulas.sets(60) == parts[:2]


def test_what_people_see_along_strings_is_told_and_not_fitted(tmp_path):
    """A relief that people see stays in their profiles; evenly spread gauges have the same figures as without."""
    made, random = with_strings(tmp_path, (0.45, 0.4, 0), (0.5, 0.5, 90)), np.random.default_rng(3)
    relief = core.BasRelief(0.5, (0.0, 0.0))
    for person in range(40):
        save(made, f"p{person}", "pencil", lambda n: observers.settings(random, n, relief, 300, 0), 2)
    before = analysis.told(analysis.analyse(core, made, records.read_sessions(made)))
    assert before["styles"]["pencil"]["errors"] is None and before["styles"]["pencil"]["refused"] == 0
    for person in range(6):
        save(made, f"p{person}", "pencil", lambda n: observers.settings(random, n, relief, 300, 0), person % 2)
    told = json.loads(json.dumps(analysis.told(analysis.analyse(core, made, records.read_sessions(made)))))
    pencil, shaded = told["styles"]["pencil"], told["styles"]["shaded"]
    assert told["gauges"] == 60 and pencil["settings"] == 360 and shaded["strings"] == [None, None]
    assert pencil["strings"] == before["styles"]["pencil"]["strings"]
    for true, seen in zip(told["strings"], pencil["strings"]):
        assert seen["settings"] == 40 * 30 and true["spacing"] == pytest.approx(5)
        height = np.array(true["profile"])
        assert np.array(seen["profile"]) == pytest.approx(0.5 * height, abs=0.05 * np.ptp(height) + 0.5)
        assert np.mean(seen["curvature"]) == pytest.approx(0.5 * np.mean(true["curvature"]), rel=0.4)
        assert np.mean(seen["apart"]) == pytest.approx(np.degrees(math.sqrt(2 * math.log(2) / 300)), rel=0.1)
    of_strings = [each for each in pencil["sessions"] if each["of_strings"]]
    assert len(of_strings) == 40 and {each["depth"] for each in of_strings} == {None}
    assert all(each["error"] == each["fitted_error"] for each in of_strings)


def test_who_sets_all_gauges_of_a_flat_string_alike_counts_and_who_sets_them_blindly_does_not(tmp_path):
    def flat(places):
        return np.tile([0.6, 0.0, 0.8], (len(places), 1))

    made = with_strings(tmp_path, (0.5, 0.5, 0), truth_at=flat)
    random = np.random.default_rng(4)
    save(made, "careful", "pencil", lambda n: n, 2)
    save(made, "blind", "pencil", lambda n: observers.anywhere(random, len(n)), 2)
    found = analysis.told(analysis.analyse(core, made, records.read_sessions(made)))["styles"]["pencil"]
    assert {each["participant"]: bool(each["refused"]) for each in found["sessions"]} == {
        "careful": False, "blind": True
    }  # fmt: skip
    assert found["strings"][0]["error"] == pytest.approx(0, abs=1e-5)


def test_gauges_of_a_string_that_nobody_has_set_have_no_figures(tmp_path):
    made = with_strings(tmp_path, (0.45, 0.4, 0))
    save(made, "a", "pencil", lambda n: n, 2)
    path = next(tmp_path.glob("a-2.jsonl"))
    lines = [line for line in path.read_text().splitlines() if json.loads(line)["gauge"] < 70]
    path.write_text("\n".join(lines))
    told = analysis.told(analysis.analyse(core, made, records.read_sessions(made)))
    (seen,) = told["styles"]["pencil"]["strings"]
    assert seen["profile"][9] is not None and seen["profile"][10:] == [None] * 5
    json.dumps(told, allow_nan=False)


def test_the_report_has_each_string_near_by_with_its_profile(tmp_path):
    made, random = with_strings(tmp_path, (0.45, 0.4, 0), (0.5, 0.5, 90)), np.random.default_rng(5)
    for style in made.stimuli:
        (tmp_path / f"{style}.png").write_bytes(core.png_bytes(np.full((8, 8, 3), 250, np.uint8)))
        save(made, style, style, lambda n: observers.settings(random, n, NONE, 100, 0), 2)
    found = analysis.analyse(core, made, records.read_sessions(made))
    told = analysis.told(found)
    text = report.page(found, told)
    assert text.count("<h2>String") == 2 and text.count("<ellipse") == 2 * 2 * 15 and "nan" not in text
    assert text.count("<polyline") == 2 * 2 * 3 and "Curvature, convex above the line" in text
    words = report.text(told)
    assert "string 2, shaded: medians" in words and "30 settings" in words


def test_strings_are_asked_for_by_their_middle_and_angle(tmp_path, capsys):
    words = ["make", "suzanne:1", "--styles", "pencil", "-o", str(tmp_path / "s")]
    options = command.parse([*words, "--string", "0.4,0.5,90", "--string", "0.1,1,-20.5"])
    assert options.string == [(0.4, 0.5, 90.0), (0.1, 1.0, -20.5)] and command.parse(words).string == []
    for wrong in ("0.4,0.5", "2,0.5,0", "a,b,c", "0.4,0.5,nan"):
        with pytest.raises(SystemExit):
            command.parse([*words, "--string", wrong])
        assert "is not a place from the left and the top" in capsys.readouterr().err


@pytest.mark.parametrize("wrong", [[[0, 15]], [[60, 70]], [[60, 62], [62, 75]], [[60, 75], [76, 90]]])
def test_strings_that_are_not_the_last_gauges_are_refused(wrong, tmp_path):
    with_strings(tmp_path, (0.45, 0.4, 0))
    told = json.loads((tmp_path / records.STUDY).read_text())
    (tmp_path / records.STUDY).write_text(json.dumps(told | {"strings": wrong}))
    with pytest.raises(ValueError, match="strings that are not its last gauges: make the study again"):
        records.read_study(tmp_path)
