# SPDX-License-Identifier: GPL-3.0-or-later
"""One picture from each camera of a scene."""

import os
import secrets
import tempfile
from contextlib import contextmanager, suppress
from pathlib import Path

import bpy

from .. import files
from ..scene.operator import Operator
from ..scene.problem import CannotDraw
from . import whole_pictures
from .line_operators import progress


def of(scene):
    """The cameras of a scene, by name."""
    return sorted((obj for obj in scene.objects if obj.type == "CAMERA"), key=lambda obj: obj.name_full)


def file_names(cameras):
    """What the names of files have of each camera: its name without what no file name may have, and a number where two
    were alike, even on disks that do not tell a from A."""
    found, taken = [], set()
    for camera in cameras:
        stem = name = bpy.path.clean_name(camera.name)
        number = 1
        while name.lower() in taken:
            number += 1
            name = f"{stem}_{number}"
        taken.add(name.lower())
        found.append(name)
    return found


@contextmanager
def unbound(scene):
    """Context in which no marker changes the scene's camera; afterwards the camera and the markers' are as before."""
    chosen, bound = scene.camera, [(marker, marker.camera) for marker in scene.timeline_markers]
    try:
        for marker, _ in bound:
            marker.camera = None
        yield
    finally:
        for marker, camera in bound:
            marker.camera = camera
        scene.camera = chosen


def _beside(scene):
    """The folder of a scene's pictures and what their names begin with, from its output path, where Blender fills in
    what is in braces."""
    path, mark = scene.render.filepath, secrets.token_hex(8)
    scene.render.filepath = path + mark if path.endswith(("/", "\\")) or not path else f"{path}_{mark}"
    whole = Path(scene.render.frame_path(frame=scene.frame_current))
    return whole.parent, whole.name.partition(mark)[0]


def _write(scene, path):
    """Renders to a file at `path`, with the suffix of its format, and one for each view of a stereo pair. They are
    replaced when they are whole."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=path.parent, prefix=".") as folder:
        scene.render.filepath = whole_pictures.literal(Path(folder) / path.name)
        try:
            bpy.ops.render.render(scene=scene.name, write_still=True)
        except RuntimeError as error:
            if folder not in str(error):  # else it was drawn, but not written
                raise
        for name in sorted(os.listdir(folder)) or [path.name]:
            with files.written(path.with_name(name), whole_pictures.is_whole) as fresh, suppress(FileNotFoundError):
                os.replace(f"{folder}/{name}", fresh)


class FOVEA_OT_render_cameras(Operator, bpy.types.Operator):
    """Render this frame from every camera of the scene, each to a file beside the output path with the camera's name"""

    bl_idname, bl_label = "fovea.render_cameras", "Render All Cameras"
    bl_options = {"REGISTER"}  # it leaves the scene as it was

    @classmethod
    def hindrance(cls, context):
        scene = context.scene
        if scene is None or not of(scene):
            return "The scene has no camera: add one"
        movie = scene.render.is_movie_format
        return "The output is a movie: choose an image format in the output properties" if movie else None

    def act(self, context):
        scene, cameras = context.scene, of(context.scene)
        path = scene.render.filepath
        try:
            folder, beginning = _beside(scene)
            with unbound(scene), progress(context) as tell:
                for number, (camera, name) in enumerate(zip(cameras, file_names(cameras))):
                    tell(number / len(cameras), camera.name)
                    scene.camera = camera
                    _write(scene, folder / f"{beginning}{name}")
        except (OSError, RuntimeError, files.NotWritten) as error:
            raise CannotDraw(str(error).strip().removeprefix("Error: ")) from error
        finally:
            scene.render.filepath = path
        self.report({"INFO"}, f"{len(cameras)} pictures are written beside {path or 'the file'}")
