# SPDX-License-Identifier: GPL-3.0-or-later
"""Gauge sessions in Blender, without a window: what the pointer and keys do, and that the analysis of what is saved
knows what people saw who are simulated drag by drag."""

import hashlib
import json
import math
import random as randoms

import numpy as np
import pytest
from gauge_people import GAUGES, save, study
from gauges import analysis, formulas, observers, records
from native_core import core

from addon import files, gauge_practice, gauge_session, gauges

DEVICE = {"pointer": "mouse"}


class Clock:
    seconds = 0.0

    def __call__(self):
        return self.seconds


def session(tmp_path, number=0, count=GAUGES):
    """A Session of a study, by a clock of its own."""
    study(tmp_path, count=count)
    made = gauge_session.read(tmp_path / "study.json")
    return gauge_session.Session(made, made.stimuli[0], "me", number, DEVICE, randoms.Random(3), Clock())


def pointer_at(shown, n):
    """Where the pointer is dragged to, in pixels from the upper left, to set the gauge that is shown to a normal."""
    slant, tilt = math.acos(min(n[2], 1.0)), math.atan2(n[1], n[0])
    far = 2 * shown.study.radius * math.sin(min(slant * 90 / gauges.STEEPEST, math.pi / 2))
    x, y = shown.place
    return x + far * math.cos(tilt), y - far * math.sin(tilt)


def set_by(hand, n, key="SPACE"):
    """Drags a gauge to a normal as a hand does, and goes on; what the last event did."""
    at = pointer_at(hand.session, n)
    assert hand.take("MOUSEMOVE", "NOTHING", at) is None, "the button is up"
    near = [a + 0.7 * (b - a) for a, b in zip(hand.session.place, at)]
    events = ("LEFTMOUSE", "PRESS", near), ("MOUSEMOVE", "NOTHING", at), ("LEFTMOUSE", "RELEASE", at)
    assert [hand.take(*event) for event in events] == ["turned", "turned", None]
    hand.session.now.seconds += 2.5
    return hand.take(key, "PRESS", at)


def people(tmp_path, relief, kappa):
    """Every set of a study's gauges, set by simulated people of one style; those are saved beside it."""
    made, random = gauge_session.read(tmp_path / "study.json"), np.random.default_rng(11)
    truth = records.read_study(tmp_path).truth
    for number in range(len(gauges.sets(len(made.places)))):
        shown = gauge_session.Session(
            made, made.stimuli[0], f"p{number}", number, DEVICE, randoms.Random(number), Clock()
        )
        hand = gauge_session.Hand(shown)
        while not shown.done:
            seen = relief.of_normals(truth[shown.steps[shown.at].gauge][None])
            seen = seen if kappa is None else observers.around(random, seen, kappa)
            set_by(hand, observers.settable(seen)[0])
        shown.save()


def test_what_people_see_who_set_gauges_by_drags_is_what_the_analysis_finds(tmp_path):
    study(tmp_path)
    people(tmp_path, core.BasRelief(), None)
    read = records.read_study(tmp_path)
    told = analysis.told(analysis.analyse(core, read, records.read_sessions(read)))["styles"]["pencil"]
    assert told["settings"] == 2 * GAUGES and told["refused"] == 0
    assert told["errors"]["mean"] < 0.01 and told["fitted_errors"]["mean"] < 0.01
    assert [each["seconds"] for each in told["sessions"]] == [2.5] * 3


def test_a_relief_that_people_see_is_found_beside_the_noise_of_their_hands(tmp_path):
    study(tmp_path)
    people(tmp_path, core.BasRelief(0.7, (0.1, -0.05)), 200)
    read = records.read_study(tmp_path)
    found = analysis.told(analysis.analyse(core, read, records.read_sessions(read)))["styles"]["pencil"]
    assert np.mean([each["depth"] for each in found["sessions"]]) == pytest.approx(0.7, rel=0.05)
    slopes = np.mean([each["slope"] for each in found["sessions"]], axis=0)
    assert slopes == pytest.approx((0.1, -0.05), abs=0.02)
    noise = math.degrees(math.sqrt(math.pi / 2 / 200))
    assert found["fitted_errors"]["mean"] < 1.6 * noise < found["errors"]["mean"]


def test_each_set_comes_twice_in_orders_of_their_own_and_begins_anywhere(tmp_path):
    shown = session(tmp_path, number=1)
    order = [step.gauge for step in shown.steps]
    assert sorted(order[:30]) == sorted(order[30:]) == list(range(30, 60)) and order[:30] != order[30:] != order
    assert [step.repeat for step in shown.steps] == [0] * 30 + [1] * 30
    starts = np.array([gauges.anywhere(randoms.Random(i)) for i in range(3000)])
    assert starts[:, 2].min() >= math.cos(math.radians(88))
    assert np.quantile(starts[:, 2], (0.25, 0.75)) == pytest.approx((0.27, 0.76), abs=0.04)
    assert np.abs(starts.mean(axis=0)[:2]).max() < 0.05


def test_a_gauge_that_is_not_touched_is_not_set_and_one_can_go_back(tmp_path):
    shown = session(tmp_path)
    hand = gauge_session.Hand(shown)
    start = shown.normal
    assert hand.take("SPACE", "PRESS", (0, 0)) == "told" and hand.told == gauge_session.FIRST
    assert hand.take("BACK_SPACE", "PRESS", (0, 0)) == "told" and shown.at == 0 and not hand.told
    for key in ("SPACE", "RET", "NUMPAD_ENTER"):
        assert set_by(hand, formulas.normal(0.4, 1.0), key) == "moved"
    assert shown.at == shown.count == 3 and not np.allclose(shown.steps[0].n, start)
    assert hand.take("BACK_SPACE", "PRESS", (0, 0)) == "moved" and shown.at == 2
    assert np.allclose(shown.normal, formulas.normal(0.4, 1.0)), "it is as it was left"
    assert set_by(hand, formulas.normal(0.9, 1.0)) == "moved" and shown.steps[2].ms == pytest.approx(5000)
    assert json.loads(shown.lines().splitlines()[2])["n"] == pytest.approx(formulas.normal(0.9, 1.0), abs=1e-6)
    for kind, value in (("A", "PRESS"), ("SPACE", "RELEASE"), ("ESC", "RELEASE"), ("RIGHTMOUSE", "PRESS")):
        assert hand.take(kind, value, (0, 0)) is None and shown.at == 3


def test_escape_keeps_what_is_set_and_the_session_goes_on_where_it_was_left(tmp_path):
    shown = session(tmp_path)
    hand = gauge_session.Hand(shown)
    shown.save()
    assert not shown.path.exists(), "nothing is set yet"
    for _ in range(4):
        set_by(hand, formulas.normal(0.5, 2.0))
    at = pointer_at(shown, formulas.normal(0.5, 0.1))
    hand.take("LEFTMOUSE", "PRESS", at)
    assert hand.take("ESC", "PRESS", at) == "end"
    shown.pause()
    shown.save()
    assert len(shown.path.read_text().splitlines()) == 4, "the one that was held has not been taken"
    shown.now.seconds += 1000
    shown.resume()
    hand, done = gauge_session.Hand(shown), None
    while done != "end":
        done = set_by(hand, formulas.normal(0.5, 2.0))
    shown.save()
    assert shown.done and max(step.ms for step in shown.steps) == pytest.approx(2500)
    (one,) = records.read_sessions(records.read_study(tmp_path))
    assert len(one.gauge) == 60 and [path.name for path in tmp_path.glob("*.jsonl")] == ["ball-me-0.jsonl"]


def test_lines_are_those_of_the_page(tmp_path):
    shown = session(tmp_path)
    set_by(gauge_session.Hand(shown), formulas.normal(0.3, 0.2))
    told = json.loads(shown.lines())
    words = "study build stimulus style model participant session order gauge x y repeat n ms start device"
    assert list(told) == words.split() and told["device"] == DEVICE
    assert (told["study"], told["style"], told["participant"], told["ms"]) == ("test", "pencil", "me", 2500)


def test_pictures_with_fewer_sessions_are_likelier_and_a_person_sees_one(tmp_path):
    made = study(tmp_path)
    for number in range(3):
        save(made, f"p{number}", "shaded", lambda n: n)
    (tmp_path / "broken.jsonl").write_text("{\n[1]\n" + '{"stimulus": 3}\n')
    shown = gauge_session.read(tmp_path / "study.json")
    assert gauge_session.counts(shown) == [0, 3]
    random = randoms.Random(1)
    first = [gauge_session.begun(shown, None, DEVICE, random) for _ in range(2000)]
    share = np.mean([each.stimulus["style"] == "pencil" for each in first])
    assert share == pytest.approx(0.8, abs=0.03) and len({each.participant for each in first}) == 2000
    second = gauge_session.begun(shown, first[0], DEVICE, random)
    third = gauge_session.begun(shown, second, DEVICE, random)
    assert [each.number for each in (first[0], second, third)] == [0, 1, 2]
    assert third.stimulus == first[0].stimulus and third.participant == first[0].participant
    with pytest.raises(ValueError, match="has set all gauges of the study: choose Another Person"):
        gauge_session.begun(shown, third, DEVICE, random)


def test_what_is_no_study_or_has_other_pictures_is_refused_in_a_sentence(tmp_path):
    study(tmp_path)
    path = tmp_path / "study.json"
    made = gauge_session.read(path)
    with pytest.raises(ValueError, match="not the picture that the study was made with"):
        made.picture(made.stimuli[0])
    (tmp_path / "pencil.png").write_bytes(b"other")
    with pytest.raises(ValueError, match="not the picture that the study was made with"):
        made.picture(made.stimuli[0])
    own = {**made.stimuli[0], "sha256": hashlib.sha256(b"other").hexdigest()}
    assert made.picture(own) == tmp_path / "pencil.png"
    with pytest.raises(ValueError, match="name the study.json of a folder that `fovea study make` wrote"):
        gauge_session.read(tmp_path / "pencil.png")
    whole = json.loads(path.read_text())
    for change in ({"gauges": []}, {"stimuli": []}, {"radius": 0}, {"size": None}, {"gauges": [{"x": 1}]}):
        path.write_text(json.dumps(whole | change))
        with pytest.raises(ValueError, match="make the study again"):
            gauge_session.read(path)


def test_a_folder_that_cannot_be_written_to_is_named(tmp_path, monkeypatch):
    shown = session(tmp_path)
    set_by(gauge_session.Hand(shown), formulas.normal(0.3, 0.2))

    def full(*_words):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(files, "_move", full)
    with pytest.raises(files.NotWritten, match="ball-me-0.jsonl could not be written .No space left"):
        shown.save()
    assert not list(tmp_path.glob("*.jsonl"))


def test_a_practice_tells_how_far_off_gauges_are_and_ends_after_its_last_one():
    practice = gauge_practice.Practice(randoms.Random(1))
    hand = gauge_session.Hand(practice)
    assert practice.words == gauge_practice.FIRST and hand.take("SPACE", "PRESS", (0, 0)) == "told"
    for k, place in enumerate(gauges.EXAMPLE["places"]):
        truth = gauges.normal_of_example(place)
        assert practice.place == place and not practice.is_good
        practice.turn(np.array((truth[1], -truth[0], truth[2])))
        off = gauges.angles(practice.normal, truth)
        assert practice.words == f"Not yet: it is {off:.0f} degrees off" and off > 15
        practice.turn(truth)
        assert practice.is_good and practice.words == gauge_practice.GOOD
        assert hand.take("SPACE", "PRESS", (0, 0)) == ("moved" if k < 3 else "end")
    assert practice.done and hand.take("BACK_SPACE", "PRESS", (0, 0)) == "told"


def test_the_shape_that_is_practiced_on_is_the_half_of_an_ellipsoid():
    for place in gauges.EXAMPLE["places"]:
        n, step = gauges.normal_of_example(place), 1e-4
        (a, b, c), middle = gauges.EXAMPLE["axes"], gauges.EXAMPLE["middle"]
        height = lambda x, y: c * math.sqrt(1 - ((x - middle[0]) / a) ** 2 - ((y - middle[1]) / b) ** 2)  # noqa: E731
        across = height(place[0] + step, place[1]) - height(place[0] - step, place[1])
        up = height(place[0], place[1] - step) - height(place[0], place[1] + step)
        assert n[:2] / n[2] == pytest.approx((-across / (2 * step), -up / (2 * step)), rel=1e-4)
    shown = gauge_practice.picture()
    assert shown.shape == gauges.EXAMPLE["size"][::-1] and shown[0, 0] == 1.0
    inside = shown < 0.99
    assert inside.sum() == pytest.approx(math.pi * a * b, rel=0.01) and shown[inside].min() < 0.4 < 0.9 < shown.max()
