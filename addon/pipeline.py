# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of native scenes: what the core's Frame (native/fovea/draw/frame.h) makes of Python's records."""

from functools import lru_cache
from pathlib import Path

from . import native, style
from .stages import Image

FOLDER = Path(__file__).parent  # with the textures and papers that ship


def options(**given):
    """The native Options: numbers of the method that are not the style's, the others as by default."""
    return native.load().Options(**given)


def frame(scene, view, chosen, backend, asked, *, notes=None, colors=None, near=None, progress=None, cancel=None):
    """A native Frame: one picture of a native Scene as a native View sees it, in a Style, none of it made yet.

    `asked`: native Options. `notes`: native Overrides, what the artist says of the scene's placements. `colors`: its
    native ColorSources, where the style has a color layer. `near`: where `frames_near` asks for them, {how many frames
    later another is: its native ShownLines}. `progress(share, stage)` is called before each stage."""
    core = native.load()
    return core.Frame(
        scene,
        view,
        chosen,
        options=asked,
        assets=_assets(core),
        backend=backend,
        overrides=notes,
        colors=colors,
        near=near or {},
        cancel=cancel,
        progress=progress,
    )


def style_of_lines(kinds, corner_angle=60.0, with_hidden=False):
    """A Style of one line set, {definition: {parameter: value}}: every line of it, however short, and with `with_hidden`
    what surfaces hide, told apart by how many."""
    many = style.MOST_SURFACES
    hidden = (style.Hidden(last=many - 1), style.Hidden(first=many)) if with_hidden else ()
    lines = style.LineSet(kinds=kinds, corner_angle=corner_angle, least_length=0.0, hidden=hidden)
    return style.Style(line_sets=(lines,))


def draw(scene, view, chosen, backend, asked, **beside):
    """The Image of a scene; all as for `frame`."""
    made = frame(scene, view, chosen, backend, asked, **beside)
    made.picture()
    statistics = {
        "stages": made.stages,
        "strokes": made.strokes.count,
        "samples": made.clipped.samples,
        "backend": backend.name,
        "visibility": made.visibility_in_words,
    }
    return Image(**made.passes(), statistics=statistics)


def frames_near(chosen, asked):
    """Over how many frames before and after it a frame is smoothed in time."""
    return chosen.elision.frames if chosen.elision.enabled and asked.visibility != "spine" else 0


@lru_cache(maxsize=1)
def _assets(core):
    return core.Assets(FOLDER)
