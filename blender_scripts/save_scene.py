# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea scene NAME[:N] -o OUT.blend`: builds a scene with Fovea as its engine and saves it."""

import argparse
import struct
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
    save(options.output)
    ending.announce(options.output.absolute())


def save(path):
    """Saves the open file to `path`, which is replaced only when the file is complete. Uncompressed: of a compressed
    file, Blender reports success when the disk is full."""
    with output.written(path, is_whole) as fresh:
        bpy.ops.wm.save_as_mainfile(filepath=str(fresh), compress=False)


def is_whole(path):
    """Whether an uncompressed .blend exists and is not truncated: it is a chain of blocks, each with its code and size
    in its head, up to an empty one at the end of the file. No code begins with 0, as a hole in the file does."""
    if not path.is_file():
        return False
    data = path.read_bytes()
    at, head, size_at, size_type = (17, 32, 16, "<q") if data[7:9].isdigit() else (12, 24, 4, "<i")
    while data[at : at + 4] != b"ENDB":
        if at + head > len(data) or not data[at]:
            return False
        if (size := struct.unpack_from(size_type, data, at + size_at)[0]) < 0:
            return False
        at += head + size
    return at + head == len(data)


if __name__ == "__main__":
    ending.run(main)
