# SPDX-License-Identifier: GPL-3.0-or-later
"""The interface is never blocked: tested without clocks, to be independent of the machine. `fovea bench viewport`
measures the times of draws of large scenes."""


def test_no_draw_waits_for_a_picture_that_takes_long(play):
    found = play("long_pictures")
    assert found["patience"] < 0.5
    for name in ("turned", "moved", "restyled"):
        told = found[name]
        assert told["begun"] >= 1 and told["threads"] == 1, (name, told)
        assert len(told["waits"]) >= 4, (name, told)
        assert max(told["waits"]) <= found["patience"] + 1e-3, (name, told)
        assert any("held up 25%" in text for text in told["said"]), (name, told)
    assert found["back"] < 1e-3
    assert found["gave way"] == [True, True]
    assert found["quality"] == 0 and found["calm"]
