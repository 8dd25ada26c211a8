# SPDX-License-Identifier: GPL-3.0-or-later
"""The viewport in a real window in different modes and error states."""


def test_every_mode(play):
    found = play("modes")
    assert all(difference < 1e-5 for difference in found["same"].values()), found["same"]
    assert found["sculpted"] > 1e-4
    assert found["calm"]


def test_what_cannot_be_drawn_and_can_be_again(play):
    found = play("troubles")
    assert found["empty"] == [True, True], "an empty scene shows nothing, and nothing goes on trying"
    assert found["panoramic"] and found["no camera"] and found["all gone"]
    assert all(difference < 1e-5 for difference in found["same"].values()), found["same"]
    assert all(difference > 1e-4 for difference in found["other"].values()), found["other"]
    assert found["calm"]
