# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea bench ink`: what the visible lines of a style are made of, per model.

blender -b -P ink.py -- OUT.json STYLE MODEL...: a row per model with the number of its objects of each shape, the ink
of its lines, and each definition's share of that. Ink is length in the image times strength and what elision leaves; an
edge of several definitions counts for the first of them in the registry.
"""

import json
import sys
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import bpy
import draw
import drawing_settings
import ending
import numpy as np
import scene_source
from bl_ext.user_default.fovea import catalogue, pipeline
from bl_ext.user_default.fovea.render import session
from command import draw_options

SIZE = "1280x960"


def of_kinds(polylines, names):
    """{definition: ink in pixels} of a native Frame's polylines."""
    step = np.hypot(*np.diff(polylines.px, axis=0).T) if len(polylines.px) > 1 else np.zeros(0)
    run = np.repeat(np.arange(len(polylines.offsets) - 1), np.diff(polylines.offsets.astype(np.int64)))
    inside = run[1:] == run[:-1]
    inside &= polylines.invisibility[run[1:]] == 0
    ink = (step * polylines.shown[run[1:]] * 0.5 * (polylines.strength[1:] + polylines.strength[:-1]))[inside]
    kinds = polylines.kinds[:-1][inside].astype(np.uint64)
    first = np.log2((kinds & (~kinds + np.uint64(1))).astype(np.float64)).astype(int)
    total = np.bincount(first, ink, minlength=len(names))
    return {name: float(total[i]) for i, name in enumerate(names) if total[i] > 0}


def measured(model, style):
    """The row of a model, or of a scene's file or name."""
    bpy.ops.wm.read_homefile()
    options = draw_options.parse([model, "--style", style, "--size", SIZE])
    scene_source.open_scene(options.scene)
    draw.set_size(bpy.context.scene, options)
    draw.set_camera(bpy.context.scene, options)
    drawing_settings.set_drawing(bpy.context.scene, options)
    frames, make = [], pipeline.frame

    def kept(*args, **words):
        frames.append(make(*args, **words))
        return frames[-1]

    pipeline.frame = kept
    try:
        bpy.ops.render.render()
    finally:
        pipeline.frame = make
    frame = frames[-1]
    shapes = Counter(shape for shape, _ in session.last_statistics()["shape"].values())
    ink = of_kinds(frame.polylines(), [definition["name"] for definition in catalogue.definitions()])
    total = sum(ink.values())
    shares = {name: round(amount / total, 4) for name, amount in ink.items()} if total else {}
    return {"model": Path(model).stem, "style": style, "shapes": dict(shapes), "ink": round(total), "of": shares}


def main(out, style, *models):
    Path(out).write_text(json.dumps([measured(model, style) for model in models]))


if __name__ == "__main__":
    ending.run(lambda words: main(*words))
