# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea compare --scene`: OUT.json and its words. Compares the drawings, and tells which line
definitions of the scene explain those that judge."""

import json
import sys
from dataclasses import replace
from pathlib import Path

import bpy
from bl_ext.user_default.fovea import catalogue, comparison, comparison_report, explained_lines, line_files
from bl_ext.user_default.fovea.render import definition_strengths

sys.path.insert(0, str(Path(__file__).parent))

import draw
import ending
import scene_source
from command import compare, draw_options

# What is compared where no lines are named, and what each is compared with: Cole 2009, 3.2.
NAMES = "ridge", "valley", "apparent_ridge", "suggestive_contour", "crease", "image_edge"
OUTLINES = "silhouette", "contour"


def main(words):
    options = compare.parse(words[1:])
    names = catalogue.named(options.lines) if options.lines else NAMES
    given = line_files.parameters(names, options.given)
    compared = compare.of_files(comparison, options)
    height, width = compared.a.pixels.shape
    scene_source.open_scene(options.scene)
    scene = bpy.context.scene
    draw.set_camera(scene, draw_options.parse([options.scene, "--size", f"{width}x{height}"]))
    seen_by = scene_source.seen_by(options.camera)
    of_scene = definition_strengths.found(bpy.context, (width, height), names, *OUTLINES, seen_by, given)
    explained = explained_lines.explain(*of_scene, compared.judges, compared.found["tolerance_px"])
    compared = replace(compared, found=compared.found | {"definitions": explained})
    if options.output:
        comparison_report.write(compared, options.output)
    Path(words[0]).write_text(json.dumps(compare.finite(compared.found)), encoding="utf-8")


if __name__ == "__main__":
    ending.run(main)
