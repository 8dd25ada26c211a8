# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea render`: renders frames of a file as `blender -b FILE -a` does, by its own engine,
into files that are whole and recorded (the add-on's render/whole_frames.py, which FOVEA_ATOMIC has switched on)."""

import sys
from pathlib import Path

import bpy
from bl_ext.user_default.fovea import native
from bl_ext.user_default.fovea.render import whole_frames
from bl_ext.user_default.fovea.render.whole_pictures import literal

sys.path.insert(0, str(Path(__file__).parent))

import blend_file
import ending
from command import render_options


def main(words):
    options = render_options.parse(words)
    blend_file.open_file(options.file, use_scripts=options.scripts)
    scene = bpy.context.scene
    render = scene.render
    if render.is_movie_format:
        raise ValueError(f"{options.file.name} renders a movie: choose a format of pictures in its output settings")
    if options.output:
        render.filepath = literal(Path(options.output).absolute())
    if options.frames:
        scene.frame_start, scene.frame_end = options.frames
        scene.frame_step = 1
    if options.threads:
        render.threads_mode, render.threads = "FIXED", options.threads
        native.load().limit_threads(options.threads)
    render.use_overwrite = True  # what is done is decided by FOVEA_RESUME
    whole_frames.check_place(scene)
    whole_frames.exits = False
    try:
        bpy.ops.render.render(animation=True)
    finally:
        for path in whole_frames.finished:
            ending.announce(path)
    if whole_frames.failures:
        raise ValueError(whole_frames.failures[0])


if __name__ == "__main__":
    ending.run(main)
