# SPDX-License-Identifier: GPL-3.0-or-later
"""Motion blur of lines: the ink of several moments while the scene's shutter is open, averaged
(native/fovea/draw/exposure.h). They are evaluated in the render's depsgraph, as neighboring frames are. Final renders
only.

The shutter is that of Blender's other engines: its time, its position and its curve."""

from .. import native
from ..scene import camera, followed
from .near_frames import other_frames

OPENS = {"START": 0.0, "CENTER": -0.5, "END": -1.0}  # position of the shutter -> when, in its times, from the frame


def is_on(depsgraph, animation):
    """Whether a final render of a depsgraph's scene has it, for a style's Animation."""
    return animation.motion_blur and followed.evaluated(depsgraph).render.use_motion_blur


def moments(render, samples):
    """[(frames from the frame itself, weight)]: the middles of so many equal parts of the shutter's time."""
    curve, opens = render.motion_blur_shutter_curve, OPENS[render.motion_blur_position]
    curve.initialize()
    shares = [(number + 0.5) / samples for number in range(samples)]
    weighted = [(render.motion_blur_shutter * (opens + at), curve.evaluate(curve.curves[0], at)) for at in shares]
    return [(away, weight) for away, weight in weighted if weight > 0.0]


def exposure(engine, depsgraph, samples, look):
    """The native Exposure of the frame that a final render's depsgraph is evaluated at; None: the shutter is never
    open. look(number) gives (content, to be compared; native Frame) of the moment that it is evaluated at. Moments with
    another active camera are left out, as the film is cut there."""
    made, last, seen_by = native.load().Exposure(), None, camera.chosen(engine, depsgraph)
    with other_frames(engine, depsgraph.scene) as go:
        for number, (away, weight) in enumerate(moments(followed.evaluated(depsgraph).render, samples), start=1):
            go(away)
            if camera.chosen(engine, depsgraph) != seen_by:
                continue
            content, moment = look(number)
            with native.refusals():
                if content == last:
                    made.again(weight)
                else:
                    made.add(moment, weight)
            last = content
    return None if made.empty else made
