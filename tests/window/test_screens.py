# SPDX-License-Identifier: GPL-3.0-or-later
"""The viewport in a real window: its settings, and other viewports and windows beside it."""


def test_switches_of_a_viewport(play):
    """X-ray changes nothing, as in EEVEE and Cycles: Blender has it for Solid and Wireframe shading, and in a drawing
    hidden lines are the style's."""
    found = play("switches")
    for pair, difference in found["same"].items():
        assert difference < 1e-5, (pair, difference)
    for pair, difference in found["other"].items():
        assert difference > 1e-4, (pair, difference)
    assert found["calm"]


def test_a_camera_that_is_locked_to_the_view(play):
    found = play("locked_camera", simulate=True)
    assert found["unlocked"] == ["PERSP", True] and found["locked"] == ["CAMERA", True]
    assert found["read"] == 0, "a camera that moves changes nothing of the scene"
    left, moved, back = found["differences"]
    assert left > 1e-4 and moved > 1e-4 and back < 1e-5
    assert found["calm"]


def test_four_views_and_a_second_window(play):
    found = play("many")
    assert found["four"] == 4, "each view has a picture of its own"
    assert found["second window"] == 0
    assert found["placed"] == [2, 1], "each window shows its own view layer"
    same, alone, moved = found["differences"]
    assert same < 1e-5 and alone < 1e-5 and moved > 1e-4
    assert found["windows"] == 1 and found["calm"]


def test_local_view_beside_the_whole_scene(play):
    found = play("local")
    assert sorted(found["placed"][0]) == sorted(found["placed"][1]) == [1, 2]
    assert found["placed"][2] == [2, 2]
    assert found["calm"]
