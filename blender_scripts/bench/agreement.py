# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea bench agreement`: how far depth-buffer visibility agrees with exact visibility.

blender -b -P agreement.py -- OUT.json SCENE [WORDS OF fovea draw]: one frame, every atlas sample judged both ways.
"""

import json
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import bpy
import draw
import ending
from bl_ext.user_default.fovea import native, pipeline, visibility
from bl_ext.user_default.fovea.backend import cpu
from command import draw_options

from bench import quality

METHODS = ((1, 1), (1, 2), (4, 2), (9, 1), (9, 2), (16, 2), (16, 3))  # probes, depth scale


class BothWays(visibility.Exact):
    """Exact visibility, which on its way compares sampled visibility with it."""

    def __init__(self, scene):
        self.scene, self.rows = scene, []

    def runs(self, frame, backend, cancel):
        runs = cpu.exact(frame, cancel)
        truth = quality.Truth(native.load(), frame, runs)
        for probes, scale in METHODS:
            start = time.perf_counter()
            depth = native.load().draw_depth(frame.scene, frame.view, scale)
            seen = native.load().sampled_visibility(frame.clipped, depth, probes)
            ms = round(1000 * (time.perf_counter() - start))
            row = {"scene": self.scene, "probes": probes, "depth_scale": scale, "ms": ms}
            self.rows.append({**row, **truth.compare(seen)})
        return runs, None


def main(out, *words):
    options = draw_options.parse(words)
    draw.open_scene(options.scene)
    draw.set_size(bpy.context.scene, options)
    draw.set_camera(bpy.context.scene, options)
    draw.set_drawing(bpy.context.scene, options)
    bpy.context.scene.fovea.visibility = "EXACT"
    pipeline.METHODS["exact"] = both_ways = BothWays(options.scene)
    bpy.ops.render.render()
    Path(out).write_text(json.dumps(both_ways.rows))


if __name__ == "__main__":
    ending.run(lambda words: main(*words))
