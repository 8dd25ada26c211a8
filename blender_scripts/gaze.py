# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea gaze SCENE`: JSON (out, heat, strengthen, draw). Draws a scene and tells where the eye
goes in it."""

import json
import sys
from pathlib import Path

import bpy
from bl_ext.user_default.fovea import gaze
from bl_ext.user_default.fovea.render import gaze_check

sys.path.insert(0, str(Path(__file__).parent))

import draw
import drawing_settings
import ending
from command import draw_options


def main(words):
    asked = json.loads(words[0])
    options = draw_options.parse(asked["draw"])
    scene = draw.opened(options)
    drawing_settings.set_drawing(scene, options)
    emphasis, checked = looked(asked["strengthen"])
    if asked["heat"]:
        gaze.write(checked.gaze, Path(asked["heat"]))
    told, sentence = checked.told, checked.sentence
    if emphasis is not None:
        told, sentence = told | {"emphasis": emphasis}, f"Emphasis {emphasis:.2f}. {sentence}"
    Path(asked["out"]).write_text(json.dumps({"told": told, "sentence": sentence}), encoding="utf-8")


def looked(strengthen):
    """(emphasis, Checked) of the scene; the emphasis is None unless it is to be strengthened."""
    return gaze_check.strengthen(bpy.context) if strengthen else (None, gaze_check.check(bpy.context))


if __name__ == "__main__":
    ending.run(main)
