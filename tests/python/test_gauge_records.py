# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of gauge studies: what is read of them, and what is refused in a sentence."""

import json

import pytest
from gauge_people import save, study
from gauges import records


def test_files_that_are_saved_twice_count_once(tmp_path):
    made = study(tmp_path)
    save(made, "a", "pencil", lambda n: n)
    (made.folder / "again.jsonl").write_text((made.folder / "a-0.jsonl").read_text())
    (one,) = records.read_sessions(made)
    assert len(one.gauge) == 60


@pytest.mark.parametrize(
    "change, told",
    [
        ({"study": "other"}, "of another study, other"),
        ({"stimulus": "x"}, "another picture than this study's 'pencil'"),
        ({"gauge": 90}, "no gauge 90"),
        ({"n": [0, 0, -1]}, "no unit vector"),
        ({"n": [0, 0, float("nan")]}, "no unit vector"),
        ({"n": None}, "no unit vector|not whole"),
        ({"n": [0, 1]}, "no unit vector"),
        ({"ms": float("inf")}, "ms is no time"),
        ({"participant": None, "session": "x"}, "take the file away"),
    ],
)
def test_a_line_that_is_not_of_the_study_is_named(change, told, tmp_path):
    made = study(tmp_path)
    save(made, "a", "pencil", lambda n: n)
    lines = (made.folder / "a-0.jsonl").read_text().splitlines()
    lines[3] = json.dumps(json.loads(lines[3]) | change)
    (made.folder / "a-0.jsonl").write_text("\n".join(lines))
    with pytest.raises(ValueError, match=f"a-0.jsonl, line 4: .*({told})"):
        records.read_sessions(made)


def test_a_file_that_is_no_text_is_named(tmp_path):
    made = study(tmp_path)
    (made.folder / "a.jsonl").write_bytes(b"\xff\xfe\x00\n")
    with pytest.raises(ValueError, match="a.jsonl, line 1: .*take the file away"):
        records.read_sessions(made)


def test_a_folder_without_a_study_is_refused(tmp_path):
    with pytest.raises(ValueError, match="name a folder that `fovea study make` wrote"):
        records.read_study(tmp_path)
    (tmp_path / records.STUDY).write_text("{}")
    with pytest.raises(ValueError, match="make the study again"):
        records.read_study(tmp_path)
