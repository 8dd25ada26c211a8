# SPDX-License-Identifier: GPL-3.0-or-later
"""One picture from each camera of a scene."""

from contextlib import contextmanager

import bpy

from ..scene.operator import Operator
from ..scene.problem import CannotDraw
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
        beside = path if path.endswith(("/", "\\")) or not path else f"{path}_"
        try:
            with unbound(scene), progress(context) as tell:
                for number, (camera, name) in enumerate(zip(cameras, file_names(cameras))):
                    tell(number / len(cameras), camera.name)
                    scene.camera, scene.render.filepath = camera, beside + name
                    bpy.ops.render.render(scene=scene.name, write_still=True)
        except RuntimeError as error:
            raise CannotDraw(str(error)) from error
        finally:
            scene.render.filepath = path
        self.report({"INFO"}, f"{len(cameras)} pictures are written beside {path or 'the file'}")
