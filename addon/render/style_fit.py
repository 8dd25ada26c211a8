# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits a style to a drawing of what a final render's frame has in view."""

import numpy as np

from .. import fitted_style, line_arrays, native, pipeline
from ..scene import camera, scene
from ..scene.problem import CannotDraw
from . import as_rendered, definition_strengths, reading


def fit(context, size, names, base, judge_of, tolerance=None, beta=1.0, seen_by=None):
    """The fitted_style.Fitted, arguments as there, of a final render of the context's frame and view layer with (width,
    height) pixels. `seen_by`: an object, None: the scene's camera."""

    def take(engine, depsgraph):
        draw = drawer(engine, depsgraph, fitted_style.style_with(base, dict.fromkeys(names, fitted_style.ON)))
        return fitted_style.fit(draw, size, names, base, judge_of, tolerance, beta)

    return as_rendered.look(context, take, definition_strengths.prepared(size, seen_by))


def drawer(engine, depsgraph, chosen):
    """A function that gives (px, offsets) of the visible lines of a Style with the line sets of `chosen`."""
    read = reading.Reader().read(depsgraph, chosen)
    if not read.snapshot.surfaces:
        raise CannotDraw("The scene is empty: there is nothing that has lines")
    core = native.load()
    seen = scene.seen(core, camera.of_render(engine, depsgraph))

    def draw(wanted):
        frame = pipeline.frame(read.placed, seen, wanted, core.CpuBackend(), pipeline.options(), notes=read.notes)
        with native.refusals():
            frame.find()
            found = line_arrays.seen(frame, np.eye(4))
        return found["px"], found["offsets"]

    return draw
