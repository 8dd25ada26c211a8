"""The viewport in a real window."""

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


def test_orbiting_keeps_the_scene_and_the_budget(play):
    found = play("orbit")
    assert found["moving"]["read"] == 0, "a camera that moves changes nothing of the scene"
    assert found["moving"]["draws"] >= 30
    assert found["moving"]["changed"] >= 10, "pictures keep coming, however slow the machine"
    assert found["moving"]["drafts"] and 0 not in found["moving"]["drafts"], "nothing is whole in a millisecond"
    assert found["plenty"] and set(found["plenty"]) == {0}, "with time enough nothing is left out"
    assert found["refined"] == 0
    assert found["idle"] == {"draws": 0, "timer": False, "threads": []}
    assert found["back"] < 1e-3, "from where it was seen before it looks as before"


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


def test_shapes_styles_playback_and_two_viewports(play):
    found = play("shapes")
    assert all(difference > 1e-4 for difference in found["differences"].values()), found
    assert found["read of a style"] == 0
    assert found["played"]["draws"] > 3 and found["played"]["read"] > 3
    assert found["after playing"] == 0
    assert found["two"] == [0, 0]
    assert found["calm"]


def test_the_gpu_draws_the_same(play):
    found = play("on_gpu")
    assert found["drawn by"] == "gpu"
    assert found["ink"] > 1e-3
    assert found["apart"] < 0.1 * found["ink"] and found["atlas apart"] < 0.3 * found["ink"], found
    assert found["back"] < 1e-5
    assert found["calm"]


def test_switching_engines_keeps_no_memory(play):
    found = play("switching")
    memory = found["memory"]
    # The first rounds load what is loaded once; what is freed is not always given back at once.
    assert min(memory[15:]) - min(memory[3:8]) < 20, memory
    assert found["calm"]


def test_disabling_while_it_draws_leaves_nothing(play):
    found = play("disabling")
    assert found["engine"] != "FOVEA"
    assert found["off"] == {"timer": False, "threads": []}
    assert found["left"] == {} and found["names"] == []
    assert found["again"] > 0
