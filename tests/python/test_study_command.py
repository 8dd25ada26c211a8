# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea study`: what it asks for, what it refuses, and what it writes besides the pictures."""

import json
from pathlib import Path

import numpy as np
import pytest
from command import actions, study
from command.target import StepFailed
from gauges import analysis, observers, records, report
from native_core import core


def made(tmp_path, *words):
    return study.parse(["make", "suzanne:3", *(words or ("--styles", "pencil,shaded")), "-o", str(tmp_path / "s")])


def test_make_takes_the_words_of_draw(tmp_path):
    options = made(tmp_path, "--styles", "pencil,my_own.json", "--azimuth", "10", "--no-elision", "--seed", "4")
    assert options.names == {"pencil": "pencil", "my_own.json": "my_own"} and options.seed == 4
    assert options.draw[:6] == ["suzanne:3", "--size", "1024x768", "--azimuth", "10", "--no-elision"]
    assert options.gauges == 90 and not (tmp_path / "s").exists()


@pytest.mark.parametrize(
    "words, told",
    [
        (["--styles", "pencil,pencil"], "two have the same name"),
        (["--styles", "pencil,sub/pencil.json"], "two have the same name"),
        (["--styles", "a b"], "no name of letters and digits"),
        (["--styles", "pencil", "--gauges", "2"], "not a number of gauges from 3 to 1000"),
        (["--styles", "pencil", "--seed", "-1"], "not a whole number"),
        (["--styles", "pencil", "--frames", "1-3"], "--frames is for fovea draw"),
        (["--styles", "pencil", "--style", "brush"], "--style is for fovea draw"),
        (["--styles", "pencil", "--cameras", "all"], "--cameras is for fovea draw"),
        (["--styles", "pencil", "--blue"], "unrecognized arguments: --blue"),
        (["--azimuth", "10"], "--styles"),
    ],
)
def test_make_refuses_what_a_study_cannot_be_made_of(words, told, tmp_path, capsys):
    with pytest.raises(SystemExit):
        made(tmp_path, *words)
    assert told in capsys.readouterr().err


def test_a_study_is_not_made_over_another_one(tmp_path, capsys):
    (tmp_path / "s").mkdir()
    made(tmp_path)
    (tmp_path / "s" / "a.jsonl").write_text("")
    with pytest.raises(SystemExit):
        made(tmp_path)
    assert "is not empty: name a new folder" in capsys.readouterr().err


def test_a_place_that_takes_no_study_is_told_before_anything_is_drawn(capsys):
    with pytest.raises(SystemExit):
        study.parse(["make", "suzanne:3", "--styles", "pencil", "-o", "/proc/s"])
    assert "nothing can be written to the folder /proc" in (said := capsys.readouterr().err)
    assert said.endswith("name another folder\n")


@pytest.fixture(params=["new", "empty"])
def drawing(request, tmp_path, monkeypatch):
    """A folder for a study, and a Blender that draws it as `drawing.picture`, or raises `drawing.error`."""

    class Drawing:
        folder, picture, error = tmp_path / "s", core.png_bytes(np.full((768, 1024, 3), 250, np.uint8)), None

        def in_blender(self, target, sentence, script, words):
            asked = json.loads(words[0])
            for path in asked["pictures"].values():
                Path(path).write_bytes(self.picture)
            gauges = [{"x": 1, "y": i, "n": [0, 0, 1], "object": "A"} for i in range(3)]
            Path(asked["out"]).write_text(json.dumps({"gauges": gauges, "tried": 9, "blender": "5.2.0"}))
            if self.error:
                raise self.error

        def make(self):
            study.make(None, made(tmp_path))

        def left(self):
            return [path for path in tmp_path.rglob("*") if not path.is_relative_to(tmp_path / "tmp")]

    drawn = Drawing()
    (tmp_path / "tmp").mkdir()
    monkeypatch.setenv("TMPDIR", str(tmp_path / "tmp"))
    monkeypatch.setattr(actions, "check_style", lambda target, style: None)
    monkeypatch.setattr(actions.extension, "install", lambda target: None)
    monkeypatch.setattr(actions, "in_blender", drawn.in_blender)
    if request.param == "empty":
        drawn.folder.mkdir()
    return drawn


def test_a_study_is_a_folder_of_its_pictures_and_its_page(drawing, capsys):
    drawing.make()
    paths = [drawing.folder / name for name in ("pencil.png", "shaded.png", records.STUDY, study.PAGE)]
    assert capsys.readouterr().out.splitlines() == list(map(str, paths))
    assert sorted(drawing.left()) == sorted([drawing.folder, *paths])
    assert records.read_study(drawing.folder).folder == drawing.folder


@pytest.mark.parametrize("error", [StepFailed("no gauges"), KeyboardInterrupt()])
def test_a_study_that_could_not_be_drawn_leaves_nothing(drawing, error):
    before, drawing.error = drawing.left(), error
    with pytest.raises(type(error)):
        drawing.make()
    assert drawing.left() == before


@pytest.mark.parametrize("how", ["write_bytes", "rename"])
@pytest.mark.parametrize(
    "error, raised, told",
    [
        (OSError(28, "No room"), ValueError, r"/s could not be written \(No room\): make room, or name another place"),
        (KeyboardInterrupt(), KeyboardInterrupt, ""),
    ],
)
def test_a_study_that_could_not_be_written_leaves_nothing(drawing, monkeypatch, how, error, raised, told):
    before, do = drawing.left(), getattr(Path, how)

    def breaks_off(path, *words):
        if path.name == study.PAGE or path.is_dir():  # the last one
            raise error
        return do(path, *words)

    monkeypatch.setattr(Path, how, breaks_off)
    with pytest.raises(raised, match=told):
        drawing.make()
    assert drawing.left() == before


@pytest.mark.parametrize(
    "words, told", [(["-o", "a.txt"], "a report is a .html"), (["--deep"], "analyse takes folders")]
)
def test_analyse_refuses_what_it_does_not_know(words, told, tmp_path, capsys):
    with pytest.raises(SystemExit):
        study.parse(["analyse", str(tmp_path), *words])
    assert told in capsys.readouterr().err


def written(tmp_path):
    """A study as `make` writes it, of a saddle, in two styles, with sessions of two people in each."""
    options = made(tmp_path)
    random = np.random.default_rng(3)
    slopes = random.uniform(-1, 1, (40, 2))
    truth = np.concatenate([-slopes, np.ones((40, 1))], axis=1)
    truth /= np.linalg.norm(truth, axis=1, keepdims=True)
    gauges = [{"x": 10.0 * i, "y": 5.0 * i, "n": list(n), "object": "Saddle"} for i, n in enumerate(truth)]
    picture = core.png_bytes(np.full((768, 1024, 3), 250, np.uint8))
    pictures = dict.fromkeys(("pencil", "shaded"), picture)
    told = study.described(options, {"gauges": gauges, "tried": 99, "blender": "5.2.0"}, pictures)
    options.output.mkdir()
    (options.output / records.STUDY).write_text(json.dumps(told))
    for style in pictures:
        (options.output / f"{style}.png").write_bytes(picture)
        for person in "ab":
            settings = observers.settings(random, np.tile(truth[:20], (2, 1)), core.BasRelief(), 100, 0)
            lines = [
                {"study": told["study"], "stimulus": told["stimuli"][0]["sha256"], "style": style, "gauge": i % 20,
                 "participant": person + style, "session": 0, "repeat": i // 20, "n": list(n), "ms": 3000}
                for i, n in enumerate(settings)
            ]  # fmt: skip
            text = "\n".join(map(json.dumps, lines))
            (options.output / f"{person}-{style}.jsonl").write_text(text)
    return records.read_study(options.output)


def test_studies_of_other_places_or_pictures_have_other_names(tmp_path):
    options, found = made(tmp_path), {"gauges": [{"x": 1}], "tried": 1, "blender": "5.2"}
    names = {
        study.described(options, found, {"a": b"1"})["study"],
        study.described(options, found, {"a": b"2"})["study"],
        study.described(options, found | {"gauges": [{"x": 2}]}, {"a": b"1"})["study"],
    }
    again = study.described(options, found, {"a": b"1"})["study"]
    assert len(names) == 3 and again in names


def test_a_report_is_one_page_with_every_style_and_its_gauges(tmp_path):
    of = written(tmp_path)
    found = analysis.analyse(core, of, records.read_sessions(of))
    told = analysis.told(found)
    text = report.page(found, told)
    assert text.count("data:image/png;base64,") == 2 and "http" not in text and "nan" not in text
    assert text.count("<ellipse") == 2 * 20, "only gauges that were set"
    words = report.text(told)
    assert "suzanne-3: 40 gauges" in words and "pencil" in words and "not count" not in words
    assert 4 < told["styles"]["pencil"]["fitted_errors"]["mean"] < 9
    assert told["model"] == "suzanne-3" and len(told["p_values"]) == 1


def test_a_style_that_nobody_saw_has_no_figures(tmp_path):
    of = written(tmp_path)
    for path in of.folder.glob("*-shaded.jsonl"):
        path.unlink()
    found = analysis.analyse(core, of, records.read_sessions(of))
    told = analysis.told(found)
    assert told["styles"]["shaded"]["errors"] is None and told["p_values"] == []
    assert "shaded" in report.text(told) and report.page(found, told).count("data:image") == 1


def test_errors_are_blue_near_the_truth_and_red_far_from_it():
    assert report.color(0) == "rgb(30 90 200)" and report.color(90) == report.color(60) == "rgb(220 50 30)"
    assert report.color(20) == "rgb(60 180 120)"
