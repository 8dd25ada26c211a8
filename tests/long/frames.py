# SPDX-License-Identifier: GPL-3.0-or-later
"""An animation to render: a file of it, and an undisturbed run. Also the script that makes the file, inside Blender."""

import os
import subprocess
import sys
from pathlib import Path

FRAMES = 24
TARGET = os.environ["FOVEA_TARGET"].split("\n")  # the words of main.py before the sub-command
BLENDER = TARGET[3]


def saved(folder):
    """An animation of FRAMES frames, each of its own."""
    file = folder / "boxes.blend"
    subprocess.run([BLENDER, "-b", "--python-exit-code", "1", "-P", __file__, "--", file], check=True)
    return file


def undisturbed(file, folder):
    """Renders all frames at once to FOLDER/box_####.png."""
    words = [BLENDER, "-b", file, "-o", folder / "box_####", "-a"]
    subprocess.run(words, check=True, env=os.environ | {"FOVEA_ATOMIC": "1"})
    return folder


def same(*folders):
    """Whether all frames are there, whole, as recorded, and equal; what differs is printed."""
    words = [BLENDER, "--command", "fovea_check", *folders, "--frames", f"1-{FRAMES}"]
    return subprocess.run(words).returncode == 0


def make(file):
    import bpy

    sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))
    import scenes

    bpy.ops.wm.read_homefile(use_empty=True)
    scenes.build("boxes:3", None)
    scene = bpy.context.scene
    render = scene.render
    render.engine, render.resolution_x, render.resolution_y, render.resolution_percentage = "FOVEA", 640, 360, 100
    render.image_settings.file_format = "PNG"
    scene.frame_start, scene.frame_end = 1, FRAMES
    for frame in (1, FRAMES):
        scene.camera.location.x += 1.0
        scene.camera.keyframe_insert("location", frame=frame)
    bpy.ops.wm.save_as_mainfile(filepath=file)


if __name__ == "__main__":
    make(sys.argv[-1])
