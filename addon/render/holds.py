# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings on twos and threes: which frame's drawing a final render shows (native/fovea/style/animation.h). It is
evaluated in the render's depsgraph, as neighboring frames are, so that below lines over its render another engine has
the frame itself."""

from contextlib import contextmanager

from ..scene import followed
from .near_frames import other_frames


def frame_of(depsgraph, animation):
    """The frame whose drawing a final render shows at the frame that its depsgraph is evaluated at, for a style's
    Animation. A drawing also begins where markers change the camera."""
    scene, frame = followed.of(depsgraph.scene), depsgraph.scene.frame_current
    held, camera = animation.held(frame), followed.seen_by(scene, frame)
    cuts = (number for number in range(frame, held, -1) if followed.seen_by(scene, number - 1) != camera)
    return next(cuts, held)


@contextmanager
def held(engine, depsgraph, animation):
    """Context in which a final render's depsgraph is evaluated at that frame."""
    with other_frames(engine, depsgraph.scene) as go:
        if away := frame_of(depsgraph, animation) - depsgraph.scene.frame_current:
            go(away)
        yield
