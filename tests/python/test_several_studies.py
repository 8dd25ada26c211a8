# SPDX-License-Identifier: GPL-3.0-or-later
"""Gauge studies of several scenes in one table."""

import json

import numpy as np
import pytest
from command import study as command
from gauge_people import save, study
from gauges import analysis, observers, records, report, several
from native_core import core

NONE = core.BasRelief()


def scene(folder, number, kappas, people=6):
    """A study in a folder, with people who set gauges as far off as each style's kappa says."""
    folder.mkdir()
    made, random = study(folder, tuple(kappas)), np.random.default_rng(number)
    told = json.loads((folder / records.STUDY).read_text())
    (folder / records.STUDY).write_text(json.dumps(told | {"study": f"study {number}", "model": folder.name}))
    made = records.read_study(folder)
    for style, kappa in kappas.items():
        for person in range(people):
            save(made, f"{style}{person}", style, lambda n: observers.settings(random, n, NONE, kappa, 0), person % 3)
    return analysis.analyse(core, made, records.read_sessions(made))


def test_each_scene_has_a_row_and_each_style_a_column(tmp_path):
    easy = scene(tmp_path / "easy", 1, {"pencil": 100, "shaded": 300})
    hard = scene(tmp_path / "hard", 2, {"pencil": 20, "shaded": 60})
    told = several.told([easy, hard])
    json.dumps(told, allow_nan=False)
    for measure, rows in told["rows"].items():
        assert [row["scene"] for row in rows] == ["easy", "hard", "all"]
        for of, row in zip(told["scenes"], rows):
            assert row["styles"] == {style: found[measure] for style, found in of["styles"].items()}
            assert row["blind"] == of["floors"]["random"].get(measure)
        of_all = np.concatenate([getattr(found.styles["pencil"], measure) for found in (easy, hard)])
        assert rows[2]["styles"]["pencil"]["mean"] == pytest.approx(of_all.mean())
        assert rows[2]["styles"]["pencil"]["sd"] == pytest.approx(of_all.std())
    rows = told["rows"]["fitted_errors"]
    for row in rows:
        assert row["styles"]["shaded"]["mean"] < row["styles"]["pencil"]["mean"] < row["blind"]["mean"]
    lines = several.text(told).splitlines()
    assert lines[0].split()[-3:] == ["pencil", "shaded", "blind"]
    assert [line.split()[0] for line in lines[1:4]] == ["easy", "hard", "all"]
    assert f"{rows[1]['styles']['pencil']['mean']:.1f} +- {rows[1]['styles']['pencil']['sd']:.1f}" in lines[2]


def test_a_style_that_a_scene_lacks_is_not_in_the_row_of_all(tmp_path):
    one = scene(tmp_path / "one", 3, {"pencil": 60, "shaded": 60})
    other = scene(tmp_path / "other", 4, {"pencil": 60, "brush": 60})
    told = several.told([one, other])
    assert told["styles"] == ["pencil", "shaded", "brush"]
    first, second, of_all = told["rows"]["errors"]
    assert first["styles"]["brush"] is None and second["styles"]["shaded"] is None
    assert of_all["styles"]["pencil"] and of_all["styles"]["brush"] is None and of_all["styles"]["shaded"] is None
    pairs = [each["styles"] for each in told["p_values"]]
    assert pairs == [["pencil", "shaded"], ["pencil", "brush"]], "nobody saw the others in one scene"


def test_who_saw_the_harder_scene_does_not_tell_styles_apart(tmp_path):
    """Both styles are alike, and the first one has most of its sessions in the harder scene."""
    scenes = []
    for number, (name, kappa, more) in enumerate((("easy", 200, "shaded"), ("hard", 15, "pencil"))):
        folder = tmp_path / name
        scene(folder, 5 + number, {"pencil": kappa, "shaded": kappa}, 3)
        made, random = records.read_study(folder), np.random.default_rng(number)
        for person in range(9):
            save(made, f"more{person}", more, lambda n: observers.settings(random, n, NONE, kappa, 0), person % 3)
        scenes.append(analysis.analyse(core, made, records.read_sessions(made)))
    told = several.told(scenes)
    (found,) = told["p_values"]
    assert found["by_setting"] > 0.01 and found["by_session"] > 0.01
    pooled = [np.concatenate([each.styles[s].fitted_errors for each in scenes]) for s in ("pencil", "shaded")]
    assert pooled[0].mean() > 1.5 * pooled[1].mean(), "their means alone would"


def test_scenes_of_the_same_name_are_told_apart_and_no_study_counts_twice(tmp_path):
    for number, folder in enumerate("ab", start=8):
        scene(tmp_path / folder, number, {"pencil": 60})
    for folder in "ab":
        told = json.loads((tmp_path / folder / records.STUDY).read_text()) | {"model": "office"}
        (tmp_path / folder / records.STUDY).write_text(json.dumps(told))
    studies = [records.read_study(tmp_path / folder) for folder in "ab"]
    both = [analysis.analyse(core, made, records.read_sessions(made)) for made in studies]
    assert [row["scene"] for row in several.told(both)["rows"]["errors"]] == ["office (a)", "office (b)", "all"]
    with pytest.raises(ValueError, match="are the same study: name each once"):
        several.check([studies[0], studies[1], studies[0]])


def test_a_page_has_the_table_of_all_scenes_and_those_of_each(tmp_path):
    found = [scene(tmp_path / name, 10 + i, {"pencil": 60, "shaded": 60}) for i, name in enumerate(("cup", "arm"))]
    for each in found:
        for style in each.study.stimuli:
            (each.study.folder / f"{style}.png").write_bytes(core.png_bytes(np.full((8, 8, 3), 250, np.uint8)))
    told = several.told(found)
    text = several.page(found, told)
    assert text.count("<h1>") == 3 and "Gauges on 2 scenes" in text and "Gauges on arm" in text
    assert text.count("data:image/png;base64,") == 4 and "http" not in text and "nan" not in text
    assert report.page(found[0], analysis.told(found[0])).count("<h1>") == 1


def test_the_command_takes_one_folder_or_several(tmp_path, capsys):
    assert command.parse(["analyse", str(tmp_path)]).folders == [tmp_path]
    assert len(command.parse(["analyse", str(tmp_path), str(tmp_path / "b"), "--json"]).folders) == 2
