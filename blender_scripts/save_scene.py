# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea scene NAME[:N] -o OUT.blend`: builds a scene with Fovea as its engine and saves it."""

import argparse
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))

import ending
import scenes
from command import output
from command.target import SHARED


def main(words):
    parser = argparse.ArgumentParser("fovea scene")
    parser.add_argument("scene")
    parser.add_argument("-o", "--output", type=Path, required=True)
    options = parser.parse_args(words)
    bpy.ops.wm.read_homefile(use_empty=True)
    scenes.build(options.scene, SHARED if SHARED.is_dir() else None)
    bpy.context.scene.render.engine = "FOVEA"
    bpy.context.scene.view_settings.view_transform = "Standard"
    with output.written(options.output) as fresh:
        bpy.ops.wm.save_as_mainfile(filepath=str(fresh))
    ending.announce(options.output.absolute())


if __name__ == "__main__":
    ending.run(main)
