# SPDX-License-Identifier: GPL-3.0-or-later
"""The viewport in a real window while engines and shadings are switched and the add-on is disabled."""

from statistics import mean


def test_switching_engines_keeps_no_memory(play):
    found = play("switching")
    memory = found["memory"]
    # The first rounds load what is loaded once; what is freed is given back sooner or later, by 30 MB from round to
    # round.
    assert mean(memory[15:]) - mean(memory[3:8]) < 20, memory
    assert found["calm"]


def test_disabling_while_it_draws_leaves_nothing(play):
    found = play("disabling")
    assert found["engine"] != "FOVEA"
    assert found["off"] == {"timer": False, "threads": []}
    assert found["left"] == {} and found["names"] == []
    assert found["again"] > 0
