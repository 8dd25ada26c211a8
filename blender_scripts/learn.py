# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea learn`: OUT.json and its words. Learns a model of lines from drawings of the scene, or
draws the scene by one."""

import json
import sys
import time
from pathlib import Path

import bpy
import numpy as np
from bl_ext.user_default.fovea import comparison, files, learned_lines, native
from bl_ext.user_default.fovea.render import local_properties
from bl_ext.user_default.fovea.scene import camera

sys.path.insert(0, str(Path(__file__).parent))

import draw
import ending
import scene_source
from command import draw_options, learn


def main(words):
    options, start = learn.parse(words[1:]), time.perf_counter()
    drawings = [comparison.read(path) for path in options.drawings]
    model = learned_lines.read(options.model) if options.predict else None
    size = ["--size", "{}x{}".format(*options.size)] if options.size else []
    scene = draw.opened(draw_options.parse([options.scene, *size]))
    size = comparison.frame_for(drawings, camera.frame_size(scene.render), options.register)
    judges_of = comparison.judges_of(drawings, size, options.register, options.tolerance)
    view, opened = (bpy.context, size, scene_source.seen_by(options.camera)), time.perf_counter()
    known = [local_properties.of_render(*view)] if model else local_properties.with_judges(*view, judges_of)
    seen = time.perf_counter()
    found = predicted(options, model, *known) if model else learned(options, *known)
    seconds = {"scene": opened - start, "properties": seen - opened, "model": time.perf_counter() - seen}
    Path(words[0]).write_text(json.dumps(found | {"seconds": seconds}), encoding="utf-8")


def learned(options, properties, judges, outlines):
    made = learned_lines.learn(properties, judges, options.kind, options.tolerance, outlines)
    with files.written(options.output) as fresh:
        fresh.write_text(made.model.json(), encoding="utf-8")
    return made.found | {"model": str(options.output)}


def predicted(options, model, properties):
    probability, lines = learned_lines.drawn(model, properties, options.threshold)
    share = probability if options.probability else lines.pixels
    gray = np.rint(255 * (1 - share)).astype(np.uint8)
    with files.written(options.output) as fresh:
        fresh.write_bytes(native.load().png_bytes(np.repeat(gray[..., None], 3, axis=2)))
    threshold = model.threshold if options.threshold is None else options.threshold
    return {"picture": str(options.output), "threshold": threshold, "pixels": int(lines.pixels.sum())}


if __name__ == "__main__":
    ending.run(main)
