# SPDX-License-Identifier: GPL-3.0-or-later
"""Neighboring frames of the rendered one, for elision, visibility and marks over frames.

They are evaluated in the render's depsgraph, as engines do for motion blur, also outside the scene's frame range: so a
frame rendered alone equals that of the animation (simulations must be baked). Final renders only.

During one call of Blender's the lines of each frame are found once: they are kept for frames near it, and for itself
when its turn comes, if its content is still the same; if not, all is found again. They are let go at its end, when the
scene is edited meanwhile, and above the memory limit."""

from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from math import floor

import bpy
from bpy.app.handlers import persistent

from .. import line_files, native
from ..pipeline import Near
from ..scene import camera, kept


@dataclass
class Looked:
    """What was found of a frame."""

    content: tuple  # of `content`
    found: object  # native FoundLines; None if its lines do not answer to frames
    used: int = 0  # time of its last use, from `kept.now`

    @property
    def size(self):
        return self.found.bytes if self.found else 0


class Frames:
    """Frames that were looked at: {(scene, view layer, eye, camera, frame): Looked}. Threads other than that of the
    render let frames go."""

    def __init__(self):
        self.looked = {}

    def items(self, _needed):
        """As kept.Items."""
        return [
            kept.Item(looked.used, looked.size, partial(self.looked.pop, key, None))
            for key, looked in list(self.looked.items())
        ]

    def keep(self, key, looked):
        kept.add_cache(self, native.load())
        looked.used = kept.now()
        self.looked[key] = looked

    def get(self, key):
        if looked := self.looked.get(key):
            looked.used = kept.now()
        return looked

    def leave(self, key, first, last):
        """Lets go those that are of the same scene, view layer and eye as a key, but not between these offsets in
        frames from it."""
        for other in list(self.looked):
            if other[:3] == key[:3] and not first <= other[-1] - key[-1] <= last:
                self.looked.pop(other, None)

    def clear(self):
        self.looked.clear()


_frames = Frames()
_rendering = False  # whether a render is in progress, during which a scene changes by the frame alone


def near(engine, depsgraph, offsets, look, kept=()):
    """The Near of the frame that is rendered, of the frames at these offsets, ascending. look() gives the Looked of the
    frame that the depsgraph is evaluated at. Left out are frames whose lines do not answer to others, and those with
    another active camera, which are beyond a cut. `kept`: offsets of frames that stay, too."""
    lines, own = {}, _key(engine, depsgraph)
    _frames.leave(own, min(*offsets, *kept, 0), max(*offsets, *kept, 0))
    with other_frames(engine, depsgraph.scene) as go:
        for away in offsets:
            key = (*own[:-1], own[-1] + away)
            looked = _frames.get(key)
            if looked is None:
                go(away)
                if _key(engine, depsgraph)[:-1] != key[:-1]:
                    continue
                looked = look()
                _keep(key, looked)
            if looked.found:
                lines[away] = looked.found.near_lines
    return Near(lines)


def beside(engine, depsgraph, look):
    """{-1: of the frame before the one that is rendered, 1: of the one after it}: what look() gives of the frame that
    the depsgraph is evaluated at. Without those that have another active camera."""
    found, seen_by = {}, camera.chosen(engine, depsgraph)
    with other_frames(engine, depsgraph.scene) as go:
        for away in (-1, 1):
            go(away)
            if camera.chosen(engine, depsgraph) == seen_by:
                found[away] = look()
    return found


def changed(engine, depsgraph, content_now):
    """Whether the frame that is rendered was looked at when its content was another one: then all is forgotten."""
    looked = _frames.get(_key(engine, depsgraph))
    if looked is None or looked.content == content_now:
        return False
    _frames.clear()
    return True


def with_itself(engine, depsgraph, near, content_now):
    """A Near of the frame that is rendered and has not `changed`, also with what was found of the frame itself."""
    key = _key(engine, depsgraph)
    near = replace(near, lines={away: lines for away, lines in near.lines.items() if away})
    if looked := _frames.get(key):
        return replace(near, same=looked.found)
    return replace(near, keep=lambda found: _keep(key, Looked(content_now, found)))


def content(read, seen, chosen, options, backend):
    """What the lines of a frame depend on, to be compared: of a Read scene, a native View, a Style, native Options, a
    backend."""
    scene = native.load().content_of(read.placed, seen, read.notes)
    return scene, chosen, line_files.stamp(chosen), options, backend.name


def _keep(key, looked):
    if _rendering:
        _frames.keep(key, looked)


def _key(engine, depsgraph):
    scene, seen_by = depsgraph.scene, camera.chosen(engine, depsgraph)
    eye, frame = engine.active_view_get(), scene.frame_current + scene.frame_subframe
    return scene.name_full, depsgraph.view_layer.name, eye, seen_by.name_full, frame


@contextmanager
def other_frames(engine, scene):
    """Context with a function go(offset) that evaluates the engine's depsgraph so many frames, or parts of one, later;
    restores it after."""
    frame, subframe = scene.frame_current, scene.frame_subframe
    gone = []

    def go(away):
        gone.append(away)
        whole, part = divmod(subframe + (away - floor(away)), 1)
        engine.frame_set(frame + floor(away) + int(whole), subframe=part)

    try:
        yield go
    finally:
        if gone:
            engine.frame_set(frame, subframe=subframe)


@persistent
def forget(*_):
    _frames.clear()


@persistent
def _begin(*_):
    global _rendering
    _frames.clear()
    _rendering = True


@persistent
def _end(*_):
    global _rendering
    _frames.clear()
    _rendering = False


HANDLERS = {"render_init": _begin, "render_complete": _end, "render_cancel": _end, "depsgraph_update_post": forget}


def register():
    for name, handler in HANDLERS.items():
        getattr(bpy.app.handlers, name).append(handler)


def unregister():
    for name, handler in HANDLERS.items():
        getattr(bpy.app.handlers, name).remove(handler)
    _end()
