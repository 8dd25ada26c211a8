# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea bench agreement`: measures how often sampled visibility agrees with exact visibility.

blender -b -P agreement.py -- OUT.json SCENE [OPTIONS OF fovea draw]: one frame, every atlas sample by both methods.
"""

import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import bpy
import draw
import drawing_settings
import ending
import scene_source
from bl_ext.user_default.fovea import native, pipeline
from command import draw_options

from bench import quality

METHODS = ((1, 1), (1, 2), (4, 2), (9, 1), (9, 2), (16, 2), (16, 3))  # probes, depth scale


def compared(scene, make, asked):
    """One row per entry of METHODS: its agreement with exact visibility. `make(native Options)` returns a native
    Frame."""
    rows, exact = [], make(asked.replace(visibility="exact"))
    exact.see()
    truth = quality.Truth(exact)
    for probes, scale in METHODS:
        frame = make(asked.replace(visibility="atlas", probes=probes, depth_scale=scale))
        frame.see()
        row = {"scene": scene, "probes": probes, "depth_scale": scale, "ms": round(frame.stages["visibility"])}
        rows.append({**row, **truth.compare(frame.samples)})
    return rows


def main(out, *words):
    options = draw_options.parse(words)
    scene_source.open_scene(options.scene)
    draw.set_size(bpy.context.scene, options)
    draw.set_camera(bpy.context.scene, options)
    drawing_settings.set_drawing(bpy.context.scene, options)
    bpy.context.scene.fovea.visibility = "EXACT"
    rows, frame = [], pipeline.frame

    def judged(placed, seen, chosen, backend, asked, **beside):
        def make(asked):
            return frame(placed, seen, chosen, native.load().CpuBackend(), asked, **beside)

        rows.extend(compared(options.scene, make, asked))
        return frame(placed, seen, chosen, backend, asked, **beside)

    pipeline.frame = judged
    try:
        bpy.ops.render.render()
    finally:
        pipeline.frame = frame
    Path(out).write_text(json.dumps(rows))


if __name__ == "__main__":
    ending.run(lambda words: main(*words))
