# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea fit`: OUT.json and its words. Fits a style to drawings of the scene."""

import json
import sys
import time
from dataclasses import asdict
from pathlib import Path

import bpy
from bl_ext.user_default.fovea import catalogue, comparison, fitted_style, style
from bl_ext.user_default.fovea.render import style_fit
from bl_ext.user_default.fovea.scene import camera
from bl_ext.user_default.fovea.style import style_files

sys.path.insert(0, str(Path(__file__).parent))

import draw
import ending
import scene_source
from command import compare, draw_options, fit


def main(words):
    options, start = fit.parse(words[1:]), time.perf_counter()
    drawings, base = [comparison.read(path) for path in options.drawings], style.named(options.style)
    names = catalogue.named(options.lines) if options.lines else fitted_style.names_of(base)
    scene = draw.opened(draw_options.parse([options.scene]))
    size = comparison.frame_for(drawings, camera.frame_size(scene.render), options.register)
    tolerance = comparison.tolerance_in(drawings, size, options.register, compare.tolerance_of(comparison, options))
    judges_of = comparison.judges_of(drawings, size, options.register, tolerance)
    seen_by = scene_source.seen_by(options.camera)
    opened = time.perf_counter()
    how = tolerance, options.beta, not options.keep_pens, seen_by
    found = style_fit.fit(bpy.context, size, names, base, judges_of, *how)
    style_files.write(options.output, found.style)
    end = time.perf_counter()
    told = found.found | {
        "thresholds": found.thresholds,
        "before": found.before,
        "cross_validated_f1": found.held_out["f1"],
        "judged_by": [{"name": d.name} | of for d, of in zip(drawings, found.of_each)],
        "pens": [asdict(look) for look in found.looks],
        "hands": [asdict(hand) for hand in found.hands],
        "tolerance_px": found.tolerance,
        "style": str(options.output),
        "drawings": found.drawings,
        "seconds": {"scene": opened - start, "drawing": found.seconds, "fitting": end - opened - found.seconds},
    }
    Path(words[0]).write_text(json.dumps(told), encoding="utf-8")


if __name__ == "__main__":
    ending.run(main)
