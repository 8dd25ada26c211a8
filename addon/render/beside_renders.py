# SPDX-License-Identifier: GPL-3.0-or-later
"""Vectors or layers with every render: a file beside each frame that F12, animations and `blender -b` draw, with its
number. It is written before the picture, and it is whole or not there; without it there is no picture either."""

from pathlib import Path

import bpy

from .. import files
from ..scene.problem import CannotDraw
from . import vector_settings, vectors, whole_frames


def write(engine, depsgraph, frame):
    """Writes the file beside the picture of a final render from its native Frame, if the scene asks for one."""
    settings = depsgraph.scene.fovea.vectors
    if settings.kind == vector_settings.OFF[0]:
        return
    kind = settings.kind.lower()
    path = whole_frames.in_place(_path(engine, depsgraph)).with_suffix(f".{kind}")
    asked = vectors.options(**vector_settings.values(settings, vector_settings.VECTORS))
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        vectors.write(vectors.made(frame, kind, asked), path)
    except (OSError, files.NotWritten) as error:
        raise CannotDraw(str(error)) from error
    engine.report({"INFO"}, f"Saved: {path}")


def _path(engine, depsgraph):
    """Where Blender writes the picture of this frame, with the frame's number, as stills have none, and with the view
    layer's name if several are rendered."""
    scene, render = depsgraph.scene, depsgraph.scene.render
    view = engine.active_view_get() if render.use_multiview else ""
    path = Path(bpy.path.abspath(render.frame_path(frame=scene.frame_current, view=view)))
    number = f"{scene.frame_current:04d}"
    if render.is_movie_format:
        path = path.with_stem(f"{path.stem}_{number}")
    elif path.stem.endswith(doubled := f"{render.file_extension}{number}"):  # the name of a still, with its suffix
        path = path.with_stem(f"{path.stem.removesuffix(doubled)}_{number}")
    several = not render.use_single_layer and sum(layer.use for layer in scene.view_layers) > 1
    return path.with_stem(f"{path.stem}_{bpy.path.clean_name(depsgraph.view_layer.name)}") if several else path
