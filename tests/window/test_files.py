# SPDX-License-Identifier: GPL-3.0-or-later
"""The viewport in a real window while files are saved and loaded."""

SIZE = (480, 320)  # charcoal costs by the pixel


def test_files_are_drawn_as_they_were_saved(play):
    found = play("loading", size=SIZE)
    for pair, (state, apart) in found["same"].items():
        assert state and apart < 1e-5, (pair, state, apart)
    state, apart = found["other"]
    assert not state and apart > 1e-3
    begun, under_way = found["under way"]
    assert found["stays"] == "RENDERED", "a file without its screens is drawn at once"
    assert begun and under_way == 1, "a picture was on its way when the other file came"
    assert found["stopped"] == [[], False]
    assert found["calm"]


def test_reverted_recovered_and_left_files(play):
    found = play("coming_back", size=SIZE)
    for pair, (state, apart) in found["same"].items():
        assert state and apart < 1e-5, (pair, state, apart)
    assert all(apart > 1e-3 for apart in found["other"].values()), found["other"]
    assert found["left for"] == ["SOLID", True]
    assert found["calm"]
