# SPDX-License-Identifier: GPL-3.0-or-later
"""Gauges of a study that are set in an image editor of a real window."""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).parents[2] / "blender_scripts"))

from gauges import formulas, records

OFFSETS = [(12, 5), (-18, -9), (3, 25), (0, -30), (22, -22), (-33, 2)]  # as of the scenario


def test_gauges_are_set_by_drags_kept_at_escape_and_saved_for_the_analysis(play, tmp_path):
    found = play("session", file="gauge_scenarios.py", simulate=True)
    assert found["begun"] == ["RUNNING_MODAL"] and found["untouched"] == 0 and found["back"] == 2
    assert found["stopped"] == [3, 0, 3] and found["same"], "one goes on where it was left"
    assert found["end"] == [6, 0] and len(found["files"]) == 1
    n, scale = formulas.dragged(OFFSETS[0], 20), found["scale"]
    disc, pin = formulas.lines(n, 20 * scale)
    low, high = found["seen"]
    both = np.concatenate([disc, pin])
    assert low == pytest.approx(both.min(axis=0), abs=3) and high == pytest.approx(both.max(axis=0), abs=3)
    (session,) = records.read_sessions(records.read_study(tmp_path))
    assert sorted(session.gauge) == [0, 0, 1, 1, 2, 2]
    for line, offset in zip(found["lines"], OFFSETS):
        assert formulas.angles(np.array(line["n"]), formulas.dragged(offset, 20)) < 3, "to whole pixels of the window"
        assert line["ms"] > 0 and line["device"]["program"] == "Blender"


def test_someone_new_practices_until_gauges_lie_on_a_shape_and_nothing_of_it_is_kept(play):
    found = play("practice", file="gauge_scenarios.py", simulate=True)
    assert found["begun"] == ["RUNNING_MODAL"] and found["stopped"] == [["plain.png"], []], "a new person again"
    assert found["size"] == [400, 280]
    assert found["seen"] == [[False, True], [True, False]] * 4, "orange while off, green on the surface"
    assert found["session"] == [0, 0, "plain.png"] and found["images"] == ["plain.png"]
    (line,) = found["lines"]
    assert 0 < line["ms"] < 5000, "without the time of the practice"
