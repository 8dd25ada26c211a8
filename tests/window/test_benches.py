# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea bench viewport` at its smallest size."""

import json
import os
import shutil

import pytest
from bench import viewport


def test_bench_viewport_tells_frames_and_idling(capfd):
    if not shutil.which("xvfb-run"):
        pytest.skip("there is no xvfb-run here to make a screen")
    words = "--scenes boxes:2 --size 480x300 --frames 1 --rest 0.2 --json".split()
    status = viewport.main(words, os.environ["FOVEA_BLENDER"], dict(os.environ), None)
    told, problems = capfd.readouterr()
    assert status == 0, problems
    (row,) = json.loads(told)
    assert set(row) == {*viewport.COLUMNS, "stages"} and row["scene"] == "boxes:2" and row["triangles"] == 48
    assert all(row[name] > 0 for name in viewport.COLUMNS if name.endswith("_ms") or name == "ratio")
    assert 0 <= row["new"] <= 1 and row["idle"] >= 0 and row["idle_solid"] >= 0 and row["idle_draws"] >= 0
    assert row["stages"] and all(ms >= 0 for ms in row["stages"].values())
    assert len(viewport.table([row]).splitlines()) == 3
