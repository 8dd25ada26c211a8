# SPDX-License-Identifier: GPL-3.0-or-later
"""The frames before and after the one that is rendered, for elision smoothed in time.

They are evaluated in the render's own depsgraph, as engines do for motion blur, also beyond the scene's range: so a
frame rendered alone is that of the animation (simulations must be baked, as there). Nothing is kept from one frame to
the next. Renders only."""

from contextlib import contextmanager

from ..scene import camera


def shown_lines(engine, depsgraph, frames, look):
    """{how many frames later another is: look() there}, over so many frames to each side. Frames at which look is None
    do not count, nor those that another camera sees: there is a cut between."""
    found, seen_by = {}, camera.chosen(engine, depsgraph).name_full
    with _other_frames(engine, depsgraph.scene) as go:
        for away in range(-frames, frames + 1):
            if away == 0:
                continue
            go(away)
            if camera.chosen(engine, depsgraph).name_full == seen_by and (lines := look()) is not None:
                found[away] = lines
    return found


@contextmanager
def _other_frames(engine, scene):
    """A function that evaluates an engine's depsgraph so many frames later; afterwards it is where it was."""
    frame, subframe = scene.frame_current, scene.frame_subframe
    try:
        yield lambda away: engine.frame_set(frame + away, subframe=subframe)
    finally:
        engine.frame_set(frame, subframe=subframe)
