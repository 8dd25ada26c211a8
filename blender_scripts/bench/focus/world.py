# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a scene repeatedly through the pipeline and keeps the intermediate results."""

from contextlib import contextmanager
from dataclasses import dataclass

import bpy
import numpy as np
from bl_ext.user_default.fovea import native, pipeline, style
from bl_ext.user_default.fovea.scene import camera, line_filters, painted, scene
from bl_ext.user_default.fovea.style import style_data

from .places import places_of


@dataclass(frozen=True)
class Drawn:
    """One picture and the Frame it was drawn from."""

    image: object
    view: object  # stages.View
    style: object
    frame: object  # native Frame
    shown: np.ndarray  # (samples,) opacity factor of elision

    def places(self):
        return places_of(self.frame.clipped, self.frame.drawn, self.shown, self.view)

    def ink(self, shown):
        """(H, W) coverage by strokes with the given opacity factors, (samples,)."""
        frame, view = self.frame, self.frame.view
        strokes = frame.strokes_with(shown)
        return strokes.raster(frame.pens, frame.textures, view.width, view.height)[..., 3]


class World:
    """The arguments that a render passed to `pipeline.draw`."""

    def __init__(self, placed, view, options, given):
        self._placed, self.view, self._options, self._given = placed, view, options, given

    def draw(self, style_, view=None, backend=None):
        """The Drawn for a Style and a stages.View; None: the scene's."""
        view, kept = view or self.view, []
        seen = scene.seen(native.load(), view)
        with kept_results(pipeline, "frame", kept):
            image = pipeline.draw(
                self._placed, seen, style_, backend or native.load().CpuBackend(), self._options, **self._given
            )
        (frame,) = kept
        shown = np.ones(frame.clipped.samples, np.float32) if frame.shown is None else frame.shown
        return Drawn(image, view, style_, frame, shown)


def measure(work, size, named="watercolor"):
    """Returns work(World) for the open scene, called inside a render. `named`: the scene's style; colors are read only
    if it has a color layer."""
    draw, views, outcome = pipeline.draw, [], []

    def measured(placed, seen, style_, backend, options, **given):
        if not views:  # the self-test of the GPU, before the render has a view
            return draw(placed, seen, style_, backend, options, **given)
        pipeline.draw = draw
        outcome.append(work(World(placed, views[-1], options.replace(with_depth=True), given)))
        return draw(placed, seen, plain(), backend, options, **given)

    render = bpy.context.scene.render
    render.engine, (render.resolution_x, render.resolution_y) = "FOVEA", size
    render.resolution_percentage = 100
    bpy.context.scene.fovea.backend = "CPU"
    style_data.use(bpy.context.scene, named)
    of_render, of_sets, remarks = camera.of_render, line_filters.of, painted.Gathering.remarks

    def of_render_kept(*arguments):
        views.append(of_render(*arguments))
        return views[-1]

    pipeline.draw, camera.of_render = measured, of_render_kept
    # The styles drawn here have other line sets than the scene's, without filters.
    line_filters.of, painted.Gathering.remarks = lambda *_: {"placements": []}, lambda *_: []
    try:
        bpy.ops.render.render()
    finally:
        pipeline.draw, camera.of_render = draw, of_render
        line_filters.of, painted.Gathering.remarks = of_sets, remarks
    return outcome[0]


@contextmanager
def kept_results(module, name, kept):
    """Context in which the result of every call of a module's function is appended to `kept`."""
    function = getattr(module, name)

    def call(*arguments, **named):
        kept.append(function(*arguments, **named))
        return kept[-1]

    setattr(module, name, call)
    try:
        yield
    finally:
        setattr(module, name, function)


def named_style(name):
    return style.load(name)


def plain():
    """The style that is fastest to draw."""
    return named_style("plain").replace(elision=style.Elision(enabled=False))


def evenly_spaced(distance):
    """pen_and_ink without focus and distance effects, with a line spacing of `distance` reference pixels."""
    base = named_style("pen_and_ink")
    sets = tuple(s.replace(pen=s.pen.replace(spacing=distance), pen_away=None) for s in base.line_sets)
    elision = base.elision.replace(enabled=True, cut=0.0)
    return base.replace(line_sets=sets, focus=style.Focus(), distance=style.Distance(), elision=elision)
