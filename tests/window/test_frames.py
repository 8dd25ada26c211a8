# SPDX-License-Identifier: GPL-3.0-or-later
"""The viewport in a real window while frames change, and during renders."""


def test_what_is_keyed_is_seen(play):
    found = play("keyed")
    assert all(difference < 1e-5 for difference in found["same"].values()), found["same"]
    assert all(difference > 1e-4 for difference in found["other"].values()), found["other"]
    assert found["calm"]


def test_renders_and_baking_beside_the_viewport(play):
    found = play("rendering")
    assert all(difference < 1e-5 for difference in found["same"].values()), found["same"]
    assert found["beside"] == 0, "the viewport changes nothing of a render"
    assert len(found["files"]) == 4 and found["job 0"] and found["job 1"], found
    assert found["image"] == [1, False] and found["strokes"] == found["mesh"] == [0, True], found
    assert found["calm"]


def test_data_can_be_written_while_an_animation_is_rendered_beside_the_viewport(play):
    assert play("animation") == {"files": 12, "calm": True}
