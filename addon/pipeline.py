# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders native scenes: builds the core's Frame (native/fovea/draw/frame.h) and its Options from Python's records."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from . import line_files, native, style
from .stages import Image

FOLDER = Path(__file__).parent  # contains the bundled textures and papers


@dataclass(frozen=True)
class Near:
    """What is known of the frames near one, and of that one, of an animation whose lines answer to them."""

    lines: dict  # {frame offset: native NearLines}; at 0 those of the frame whose moment is drawn
    since_key: int = 0  # how many frames earlier the last key of marks is
    marks: object = None  # (n,) float64 marks of the frame that are baked; None: they are handed on
    same: object = None  # native FoundLines of the frame itself; None: its lines are to be found
    keep: Callable | None = None  # called with its FoundLines when its picture is made


def options(**given):
    """Native Options: the method's settings that are not in the style. Those not given have their defaults."""
    return native.load().Options(**given)


def frame(
    scene,
    view,
    chosen,
    backend,
    asked,
    *,
    notes=None,
    colors=None,
    near=None,
    poses=None,
    exposure=None,
    progress=None,
    cancel=None,
):
    """A native Frame for a native Scene, a native View and a Style; no stage of it has run yet.

    `asked`: native Options. `notes`: native Overrides, per placement. `colors`: native ColorSources, needed if the
    style has a color layer. `near`: a Near, needed if there are `frames_near`. `poses`: {-1: native Pose of the frame
    before, 1: of the one after}, needed for line vectors. `exposure`: a native Exposure, whose ink it has in place of
    its own.
    `progress(share, stage)` is called before each stage, with the share done in [0, 1]. `cancel`: native Cancel."""
    core = native.load()
    with native.refusals():
        made = core.Frame(
            scene,
            view,
            chosen,
            options=asked,
            assets=_assets(core),
            backend=backend,
            overrides=notes,
            colors=colors,
            near=near.lines if near else {},
            since_key=near.since_key if near else 0,
            baked_marks=near.marks if near else None,
            poses=poses or {},
            exposure=exposure,
            files=line_files.contents(chosen),
            cancel=cancel,
            progress=progress,
        )
        if near and near.same:
            made.take_over(near.same)
    return made


def style_of_lines(kinds, corner_angle=60.0, with_hidden=False):
    """A Style of one line set with the kinds {definition: {parameter: value}} and no minimum length. `with_hidden`:
    also the hidden runs, split by quantitative invisibility."""
    many = style.MOST_SURFACES
    hidden = (style.Hidden(last=many - 1), style.Hidden(first=many)) if with_hidden else ()
    lines = style.LineSet(kinds=kinds, corner_angle=corner_angle, least_length=0.0, hidden=hidden)
    return style.Style(line_sets=(lines,))


def draw(scene, view, chosen, backend, asked, near=None, also=None, **beside):
    """Renders a scene to an Image; arguments as for `frame`. `also(frame)` is called after all of its steps."""
    made = frame(scene, view, chosen, backend, asked, near=near, **beside)
    with native.refusals():
        made.picture()
        if near and near.keep:
            near.keep(made.found_lines())
    if also:
        also(made)
    statistics = {
        "stages": made.stages,
        "strokes": made.strokes.count,
        "samples": made.clipped.samples,
        "backend": backend.name,
        "visibility": made.visibility_in_words,
    }
    return Image(**made.passes(), statistics=statistics)


def frames_near(chosen, asked, frame, itself=False, keys=True):
    """Offsets of the frames near a frame that its lines answer to, ascending: by elision, by visibility, and, with
    `keys`, by the marks of lines of the view, from the key before it to the one after it, if a pen fixes any to paths.
    `itself`: also 0, where there are such marks. None with the spine test."""
    if asked.visibility == "spine":
        return ()
    animation, elision, marks = chosen.animation, chosen.elision, chosen.fixes_marks()
    most = max(elision.frames if elision.enabled else 0, animation.visibility_frames)
    since = animation.since_key(frame) if keys and marks else 0
    ahead = animation.marks_frames - since if since else 0
    itself = itself and marks and (animation.marks_frames > 0 or animation.marks_baked)
    return tuple(away for away in range(-max(most, since), max(most, ahead) + 1) if away or itself)


@lru_cache(maxsize=1)
def _assets(core):
    return core.Assets(FOLDER)
