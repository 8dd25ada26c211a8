# SPDX-License-Identifier: GPL-3.0-or-later
"""The viewport in a real window while the view, shapes and time change."""


def test_orbiting_keeps_the_scene_and_the_budget(play):
    found = play("orbit")
    assert found["moving"]["read"] == 0, "a camera that moves changes nothing of the scene"
    assert found["moving"]["draws"] >= 30
    assert found["moving"]["changed"] >= 10, "pictures keep coming, however slow the machine"
    drafts = found["moving"]["drafts"]
    # What a quality costs is measured: on a busy machine the best may now and then look as cheap as any.
    assert drafts.count(0) < len(drafts) / 4, f"hardly anything is whole in a millisecond: {drafts}"
    assert found["plenty"] and set(found["plenty"]) == {0}, "with time enough nothing is left out"
    assert found["refined"] == 0
    assert found["idle"] == {"draws": 0, "timer": False, "threads": []}
    assert found["back"] < 1e-3, "from where it was seen before it looks as before"


def test_shapes_styles_playback_and_two_viewports(play):
    found = play("shapes")
    assert all(difference > 1e-4 for difference in found["differences"].values()), found
    assert found["read of a style"] == 0
    assert found["played"]["draws"] > 3 and found["played"]["read"] > 3
    assert found["after playing"] == 0
    assert found["two"] == [0, 0]
    assert found["calm"]


def test_before_the_first_picture_there_are_words_and_an_old_one_moves_with_the_view(play):
    found = play("held_up")
    assert found["at first"] > 50, "Fovea: drawing..."
    assert found["moved"] > 20
    ink = found["ink"]
    assert min(ink["before"], ink["there"], ink["after"]) > 0.4 and ink["not there"] < 0.1


def test_no_old_picture_stands_as_it_was_under_overlays_of_objects_that_have_moved(play):
    paper = play("left_behind")
    bright = paper.pop("nothing True after")
    assert bright > 0.9
    moved = {f"{what} True" for what in ("light", "object", "mesh", "hidden")}
    faded = {name for name, value in paper.items() if value < bright - 0.1}
    assert faded == moved, paper
    assert all(abs(value - bright) < 0.02 for name, value in paper.items() if name not in moved), paper
