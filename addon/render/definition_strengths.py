# SPDX-License-Identifier: GPL-3.0-or-later
"""Visible lines of line definitions in a final render's frame, with strengths at pixels, for comparisons with
drawings."""

from functools import partial

import numpy as np

from .. import catalogue, explained_lines, line_arrays, native, pipeline
from ..scene import camera, scene
from ..scene.problem import CannotDraw
from . import as_rendered, reading

LEAST = 0.05  # of a threshold's default: the weakest lines that are looked at
THRESHOLDS = np.geomspace(0.02, 1.0, 8)  # of definitions in the image, whose strengths end at their threshold


def found(context, size, names, outer, contours, seen_by=None, given=None):
    """(definitions, outer, contours) of a final render of the context's frame and view layer with (width, height)
    pixels, as explained_lines.explain takes them. `names`: of the definitions; `outer`, `contours`: those of which the
    other two are. `seen_by`: an object, None: the scene's camera. `given`: {name: {parameter: value}}."""
    every = dict.fromkeys((*names, outer, contours), {}) | (given or {})
    return as_rendered.look(
        context, partial(_of_render, every=every, names=names, outlines=(outer, contours)), prepared(size, seen_by)
    )


def prepared(size, seen_by=None):
    """What as_rendered.look is to do with a scene for a frame of (width, height) pixels, seen by an object."""

    def prepare(made):
        render = made.render
        render.resolution_x, render.resolution_y = size
        render.resolution_percentage, render.use_border = 100, False
        if seen_by:
            as_rendered.see_from(seen_by, made)

    return prepare


def _of_render(engine, depsgraph, every, names, outlines):
    definitions = catalogue.by_name()
    read = reading.Reader().read(depsgraph, pipeline.style_of_lines(every))
    if not read.snapshot.surfaces:
        raise CannotDraw("The scene is empty: there is nothing that has lines")
    core, view = native.load(), camera.of_render(engine, depsgraph)
    seen = scene.seen(core, view)

    def drawn(name, parameters):
        return _lines(core, read, seen, name, every[name] | parameters)

    outer, contours = (_bitmap(core, view, drawn(name, {})) for name in outlines)
    return (
        {
            name: explained_lines.Definition(
                _strengths(core, view, drawn, definitions[name]),
                outer if definitions[name]["in_image"] else contours,
                definitions[name]["in_image"],
            )
            for name in names
        },
        outer,
        contours,
    )


def _lines(core, read, seen, name, parameters):
    """(px, offsets, strength) of the visible lines of a definition."""
    chosen, options = pipeline.style_of_lines({name: parameters}), pipeline.options(all_paths=True)
    frame = pipeline.frame(read.placed, seen, chosen, core.CpuBackend(), options, notes=read.notes)
    with native.refusals():
        frame.find()
        found = line_arrays.seen(frame, np.eye(4))
    return found["px"], found["offsets"], found["strength"]


def _bitmap(core, view, lines):
    return core.Bitmap.of_lines(*lines[:2], view.width, view.height)


def _strengths(core, view, drawn, definition):
    """The native Strengths of a definition, extracted once with its lowest threshold. In the image lines are cut by
    hysteresis, so there the strength is the highest of several thresholds at which a line is drawn."""
    name, known = definition["name"], {parameter["name"]: parameter for parameter in definition["parameters"]}
    size = view.width, view.height
    if "threshold" not in known:
        return core.Strengths(*drawn(name, {}), *size)
    if not definition["in_image"]:
        least = {"threshold": LEAST * known["threshold"]["default"]} | ({"low": 1.0} if "low" in known else {})
        return core.Strengths(*drawn(name, least), *size)
    parts = [(threshold, drawn(name, {"threshold": float(threshold)})) for threshold in THRESHOLDS]
    ends = np.cumsum([0, *(len(px) for _, (px, _, _) in parts)])
    offsets = [offsets[1:] + start for (_, (_, offsets, _)), start in zip(parts, ends)]
    strength = np.repeat([threshold for threshold, _ in parts], np.diff(ends)).astype(np.float32)
    px = np.concatenate([px for _, (px, _, _) in parts])
    return core.Strengths(px, np.concatenate([[0], *offsets]), strength, *size)
