# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines over what other engines show in viewports, in a real window."""

SIZE = 640, 400


def test_lines_lie_over_every_shading_but_wireframe_in_the_colors_of_their_pens(play):
    found = play("views", size=SIZE)
    assert found["solid"] > 100 and found["rendered differs"] < 1e-3
    assert found["off"] == found["kept while off"] == found["wireframe"] == 0
    left, left_of_border, right, right_of_border = found["border"]
    assert min(left, right, left_of_border) > 50 and right_of_border == 0 and left_of_border > 0.9 * left
    assert found["zoomed"] > 50 and found["orthographic"] > 100
    assert found["quad"] == 4 and found["one again"] == 1 and found["by Fovea"] == 0
    assert "panoramic" in found["problem"] and found["letters"] > 20 and not found["no problem"]
    assert found["calm"]


def test_lines_follow_objects_undo_frames_and_the_view_and_leave_nothing(play):
    found = play("changes", size=SIZE)
    differ = found["differ"]
    assert differ["undone"] == differ["back"] == 0
    assert min(differ["moved"], differ["turned"]) > 100 and found["played as moved"] == 0
    assert found["gone"] == [0, 0] and found["again"] > 100 and found["lines"] > 100
    assert found["calm"]
