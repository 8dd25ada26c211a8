# SPDX-License-Identifier: GPL-3.0-or-later
"""The viewport in a real window while artists work."""


def test_operators(play):
    found = play("operators")
    for pair, difference in found["same"].items():
        assert difference < 1e-5, (pair, difference)
    for pair, difference in found["other"].items():
        assert difference > 1e-4, (pair, difference)
    assert found["read of a selection"] == 0
    assert found["calm"]


def test_mouse_and_keys(play):
    found = play("events", simulate=True)
    turned, grabbed, undone = found["differences"]
    assert turned > 1e-4 and grabbed > 1e-4 and undone < 1e-5
    assert found["read to turn"] == 0 and found["read to grab"] > 0
    assert found["calm"]
