# SPDX-License-Identifier: GPL-3.0-or-later
"""Vectors or layers with every render: a file beside each frame that F12, animations and `blender -b` draw, with its
number. It is written before the picture, and it is whole or not there; without it there is no picture either. Of lines
over another engine's picture it lies beside that, which is rendered without them, too."""

from pathlib import Path

import bpy

from .. import files
from ..scene import followed
from ..scene.problem import CannotDraw
from . import lines_scenes, vector_settings, vectors, whole_frames


def write(engine, depsgraph, frame):
    """Writes the file beside the picture of a final render from its native Frame, if the scene asks for one."""
    scene = followed.of(depsgraph.scene)
    settings = scene.fovea.vectors
    if settings.kind == vector_settings.OFF[0]:
        return
    kind = settings.kind.lower()
    path = whole_frames.in_place(_path(engine, depsgraph)).with_suffix(f".{kind}")
    asked = vectors.options_of(scene, **vector_settings.values(settings, vector_settings.VECTORS))
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        vectors.write(vectors.made(frame, kind, asked), path)
    except (OSError, files.NotWritten) as error:
        raise CannotDraw(str(error)) from error
    engine.report({"INFO"}, ". ".join(filter(None, (f"Saved: {path}", vectors.remark(asked)))))


def _path(engine, depsgraph):
    """Where Blender writes the picture of this frame, with the frame's number, as stills have none, and with the view
    layer's name if several have files."""
    scene, frame = followed.of(depsgraph.scene), depsgraph.scene.frame_current
    render, layer = scene.render, _layer(scene, depsgraph)
    view = engine.active_view_get() if render.use_multiview else ""
    path = Path(bpy.path.abspath(render.frame_path(frame=frame, view=view)))
    number = f"{frame:04d}"
    if render.is_movie_format:
        path = path.with_stem(f"{path.stem}_{number}")
    elif path.stem.endswith(doubled := f"{render.file_extension}{number}"):  # the name of a still, with its suffix
        path = path.with_stem(f"{path.stem.removesuffix(doubled)}_{number}")
    return path.with_stem(f"{path.stem}_{bpy.path.clean_name(layer.name)}") if layer else path


def _layer(scene, depsgraph):
    """The view layer whose file it is, or None if there is but one file."""
    if followed.follows(depsgraph.scene):
        return lines_scenes.layer_of(depsgraph.scene)
    several = not scene.render.use_single_layer and sum(layer.use for layer in scene.view_layers) > 1
    return depsgraph.view_layer if several else None
