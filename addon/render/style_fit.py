# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits a style to drawings of what a final render's frame has in view."""

import numpy as np

from .. import fitted_hand, fitted_style, line_arrays, native, pipeline
from ..scene import camera, scene
from ..scene.problem import CannotDraw
from . import as_rendered, definition_strengths, reading, session


def fit(context, size, names, base, judges_of, tolerance=None, beta=1.0, pens=True, seen_by=None):
    """The fitted_style.Fitted, arguments as there, of a final render of the context's frame and view layer with (width,
    height) pixels. `seen_by`: an object, None: the scene's camera. CannotDraw if the user cancels it."""
    core = native.load()

    def take(engine, depsgraph):
        cancel, every = core.Cancel(), fitted_style.style_with(base, dict.fromkeys(names, fitted_style.ON))
        with session.watched(engine, cancel), cancel:
            try:
                find = finder(engine, depsgraph, every, cancel)
                draw, how = _drawing(find), (tolerance, beta, pens)
                return fitted_style.fit(draw, size, names, base, judges_of, *how, _tracing(find, size))
            except core.Cancelled as stopped:
                raise CannotDraw("Stopped before the style was fitted") from stopped

    return as_rendered.look(context, take, definition_strengths.prepared(size, seen_by))


def drawer(engine, depsgraph, chosen, cancel=None):
    """A function that gives (px, offsets) of the visible lines of a Style with the line sets of `chosen`, which draws
    no hidden ones, or of those that have at least some strength. `cancel`: a native Cancel, or None."""
    return _drawing(finder(engine, depsgraph, chosen, cancel))


def _drawing(find):
    def draw(wanted, least=0.0):
        return line_arrays.strong(find(wanted), least)

    return draw


def _tracing(find, size):
    return lambda wanted: fitted_hand.ended(find(wanted), size)


def finder(engine, depsgraph, chosen, cancel=None):
    """A function that gives the line_arrays.seen of a Style with the line sets of `chosen`."""
    read = reading.Reader().read(depsgraph, chosen, cancel=cancel)
    if not read.snapshot.surfaces:
        raise CannotDraw("The scene is empty: there is nothing that has lines")
    core = native.load()
    seen = scene.seen(core, camera.of_render(engine, depsgraph))

    def find(wanted):
        beside = {"notes": read.notes, "cancel": cancel}
        frame = pipeline.frame(read.placed, seen, wanted, core.CpuBackend(), pipeline.options(), **beside)
        with native.refusals():
            frame.find()
            return line_arrays.seen(frame, np.eye(4))

    return find
