"""Runs inside Blender for `fovea scene NAME[:N] -o OUT.blend`: builds a scene, ready to be drawn, and saves it."""

import argparse
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))

import scenes
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
    bpy.ops.wm.save_as_mainfile(filepath=str(options.output.absolute()))


if __name__ == "__main__":
    main(sys.argv[sys.argv.index("--") + 1 :])
