# SPDX-License-Identifier: GPL-3.0-or-later
"""Neighboring frames of the rendered one, for elision smoothed in time.

They are evaluated in the render's depsgraph, as engines do for motion blur, also outside the scene's frame range: so a
frame rendered alone equals that of the animation (simulations must be baked). Nothing is cached between frames. Final
renders only."""

from contextlib import contextmanager

from ..scene import camera


def shown_lines(engine, depsgraph, frames, look):
    """{frame offset: look()} for the offsets -frames .. frames except 0, with the depsgraph evaluated at that frame.
    Left out are frames where look() is None and those with another active camera, which are beyond a cut."""
    found, seen_by = {}, camera.chosen(engine, depsgraph).name_full
    with other_frames(engine, depsgraph.scene) as go:
        for away in range(-frames, frames + 1):
            if away == 0:
                continue
            go(away)
            if camera.chosen(engine, depsgraph).name_full == seen_by and (lines := look()) is not None:
                found[away] = lines
    return found


@contextmanager
def other_frames(engine, scene):
    """Context with a function go(offset) that evaluates the engine's depsgraph at another frame; restores it after."""
    frame, subframe = scene.frame_current, scene.frame_subframe
    try:
        yield lambda away: engine.frame_set(frame + away, subframe=subframe)
    finally:
        engine.frame_set(frame, subframe=subframe)
