# SPDX-License-Identifier: GPL-3.0-or-later
"""The focus tools in a real window."""

import pytest

FILE, OVERLAY = "focus_scenarios.py", "overlay_scenarios.py"


def test_focus_is_picked_by_a_click(play):
    found = play("picking", file=FILE, simulate=True)
    assert found["missed"] == found["before"], "a miss changes nothing"
    hit, added = found["hit"], found["added"]
    assert hit["model"] == "SCENE" and hit["objects"] == found["before"]["objects"] + 1
    assert hit["places"] == [pytest.approx([0.5, 0.5, 1], abs=0.03)]
    assert added["places"] == [hit["places"][0], pytest.approx([4, 0, 1], abs=0.03)]
    assert found["left"] == added, "escape changes nothing, and a click then is no pick"
    assert found["undone"] == found["before"]


def test_the_tool_of_the_toolbar_picks_with_each_click(play):
    found = play("tool", file=FILE, simulate=True)
    assert found["tool"] == "fovea.pick_focus_tool", "Alt F"
    assert found["clicked"]["model"] == "SCENE" and len(found["clicked"]["places"]) == 1
    assert found["clicked"]["places"][0] == pytest.approx([0.5, 0.5, 1], abs=0.1)
    assert len(found["added"]["places"]) == 2
    assert found["missed"] == found["added"], "nothing is under the pointer there"


def test_the_place_in_the_image(play):
    found = play("in_camera", file=FILE, simulate=True)
    assert found["picked"] == pytest.approx([0.25, 0.5], abs=0.005)
    assert found["moved"] == pytest.approx([0.5, 0.25], abs=0.005)
    assert found["near"] == pytest.approx(0.2, abs=0.005)
    assert found["undone"] == pytest.approx(0.1)


def test_rings(play):
    found = play("rings", file=FILE, simulate=True)
    assert found["far"] == pytest.approx(5, abs=0.05) and found["near"] == pytest.approx(1, abs=0.05)
    assert found["location"] == pytest.approx([1, 0, 0], abs=0.05)
    assert found["shown again"] > 300
    assert found["no overlays"] == found["other engine"] == 0


def test_focus_as_colors(play):
    found = play("heat", file=OVERLAY)
    assert found["here"] > 0.2 and found["there"] < -0.1 and abs(found["plain"]) < 0.05
    assert found["idle"] == 0
    here, there = found["moved"]
    assert here < -0.1 and there > 0.2
    assert found["sunk"] < -0.1
    assert found["off"] < 1e-3 and found["kept"] == 0


def test_what_search_finds(play):
    found = play("searched", file=FILE, simulate=True)
    assert found["model"] == "SCENE" and found["places"] == [pytest.approx([0.5, 0.5, 1], abs=0.03)]
    assert "Fovea Report" in found["texts"]


def test_focus_over_the_drawing(play):
    found = play("rendered", file=OVERLAY, words=["demo"])
    assert found["model"] == "SCENE" and 0 < found["radii"][0] < found["radii"][1]
    assert found["reads"] == {"rendered": 0, "solid": 1}, "the scene is not read again for what is drawn anyway"
    assert found["finest"] == 1 and found["coarse"] == [0.25], "whole at rest, coarse where there is no time"
    assert min(found["cool"]) > 0.1, "it is there in each picture of a view that turns"
