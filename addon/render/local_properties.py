# SPDX-License-Identifier: GPL-3.0-or-later
"""Local properties of the pixels of a final render's frame."""

from .. import fitted_style, native, pipeline, style
from ..scene import camera, scene
from ..scene.problem import CannotDraw
from . import as_rendered, definition_strengths, reading, style_fit

OUTLINES_OF = "plain"  # style by whose outlines scans are registered, and from which importance keeps away


def of_render(context, size, seen_by=None):
    """The native LocalProperties of a final render of the context's frame and view layer with (width, height) pixels.
    `seen_by`: an object, None: the scene's camera."""
    return as_rendered.look(context, _properties, definition_strengths.prepared(size, seen_by))


def with_judges(context, size, seen_by, judges_of):
    """(native LocalProperties, Bitmaps of drawings, Bitmap of the scene's outlines) of the same. `judges_of`: as
    comparison.judges_of gives it."""

    def take(engine, depsgraph):
        properties, base = _properties(engine, depsgraph), style.load(OUTLINES_OF)
        outlines = fitted_style.drawn_outlines(style_fit.drawer(engine, depsgraph, base), size, base)
        return properties, [laid.bitmap for laid in judges_of(lambda: outlines)], outlines

    return as_rendered.look(context, take, definition_strengths.prepared(size, seen_by))


def _properties(engine, depsgraph):
    read = reading.Reader().read(depsgraph, pipeline.style_of_lines({}))
    if not read.snapshot.surfaces:
        raise CannotDraw("The scene is empty: there is nothing that has lines")
    core = native.load()
    with native.refusals():
        return core.LocalProperties(read.placed, scene.seen(core, camera.of_render(engine, depsgraph)))
