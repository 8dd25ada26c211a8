# SPDX-License-Identifier: GPL-3.0-or-later
"""An earlier picture lies where the scene is seen after the camera has moved."""

import numpy as np
import pytest

from addon import moved_picture
from addon.stages import View

DEPTH = 5.0


def turned(degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c, 0, s, 0], [0, 1, 0, 0], [-s, 0, c, 0], [0, 0, 0, 1.0]])


def view(world_to_view=None, orthographic=False, shift=(0.0, 0.0)):
    lens = np.array([[2, 0, shift[0], 0], [0, 3, shift[1], 0], [0, 0, -1.02, -0.2], [0, 0, -1, 0.0]])
    flat = np.array([[0.2, 0, 0, shift[0]], [0, 0.3, 0, shift[1]], [0, 0, -0.02, -1], [0, 0, 0, 1.0]])
    pose = np.eye(4) if world_to_view is None else world_to_view
    return View(pose, flat if orthographic else lens, 300, 200, orthographic, 0.1, 100.0)


def seen(point, view):
    """Where a point of the scene is in a picture, (0, 0) to (1, 1)."""
    clip = view.view_to_clip @ view.world_to_view @ np.array([*point, 1.0])
    return (clip[:2] / clip[3] + 1) / 2


def shown(place, before, now):
    """Where a place of a picture of `before` lies in `now`: on the plane, clip coordinates are an affine map of it."""
    corners = moved_picture.on_plane(before, now, DEPTH).astype(np.float64)
    ends = np.column_stack([moved_picture.PLACES, np.ones(len(corners))]).astype(np.float64)
    affine = np.linalg.lstsq(ends, corners, rcond=None)[0]
    clip = np.array([*place, 1.0]) @ affine
    return (clip[:2] / clip[3] + 1) / 2


MOVES = {
    "nothing": np.eye(4),
    "turned": turned(12),
    "beside": np.array([[1, 0, 0, 0.4], [0, 1, 0, -0.3], [0, 0, 1, 0], [0, 0, 0, 1.0]]),
    "nearer": np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 2.0], [0, 0, 0, 1]]),
}


@pytest.mark.parametrize("orthographic", [False, True])
@pytest.mark.parametrize("move", sorted(MOVES))
def test_what_lies_on_the_plane_is_where_it_is_seen(move, orthographic):
    before, now = view(orthographic=orthographic), view(MOVES[move], orthographic, shift=(0.1, -0.2))
    for point in ((0, 0, -DEPTH), (0.7, -0.4, -DEPTH), (-1.1, 0.9, -DEPTH)):
        assert shown(seen(point, before), before, now) == pytest.approx(seen(point, now), abs=1e-5)


def test_if_only_the_direction_has_changed_so_is_all_else():
    before, now = view(), view(turned(20))
    for point in ((0, 0, -1.0), (0.7, -0.4, -3.0), (-4, 2, -20.0)):
        assert shown(seen(point, before), before, now) == pytest.approx(seen(point, now), abs=1e-5)


def test_the_depth_of_a_place_is_that_along_the_view_and_1_behind_the_eye():
    assert moved_picture.depth_of(view(MOVES["nearer"]), (3, 1, -7)) == pytest.approx(5)
    assert moved_picture.depth_of(view(), (0, 0, 7)) == 1.0
