# SPDX-License-Identifier: GPL-3.0-or-later
"""The viewport in a real window compared with the final render, and with itself drawn by other means."""

import pytest


def test_camera_view_is_the_final_render(play):
    found = play("camera_view")
    wider, coarse = found.pop("wider"), found.pop("coarse")
    assert coarse["quality"] == 4
    assert coarse["ink"][0] == pytest.approx(coarse["ink"][1], rel=0.5), coarse
    assert 1.5 * coarse["apart"][0] < min(coarse["apart"][1:]), coarse
    assert found.pop("outside") < 0.1, "the passepartout is there"
    for name, told in found.items():
        assert told["frame"][2:] == pytest.approx([640, 360], abs=0.05), name
        assert told["ink"][1] > 0.002, f"{name}: there is hardly a line"
        assert told["mean"] < 5e-4 and told["apart"] < 1e-3, (name, told)
    # So that the tolerance is no blindness.
    assert wider["apart"] > 1.5e-3, wider


def test_the_gpu_draws_the_same(play):
    found = play("on_gpu")
    assert found["drawn by"] == "gpu"
    assert found["ink"] > 1e-3
    assert found["apart"] < 0.1 * found["ink"] and found["atlas apart"] < 0.3 * found["ink"], found
    assert found["back"] < 1e-5
    assert found["calm"]
