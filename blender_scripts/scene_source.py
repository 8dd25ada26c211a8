# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene that a command draws: opened, imported, or built. Runs inside Blender."""

from pathlib import Path

import blend_file
import bpy
import ending
import framing
import scenes
from command import model_files
from command.target import SHARED


def open_scene(spec):
    """Opens a .blend, or imports a model or builds a named scene in an empty file. The add-on stays enabled."""
    if model_files.is_blend(spec):
        blend_file.open_file(Path(spec).absolute())
        return
    bpy.ops.wm.read_homefile(use_empty=True)
    if model_files.is_model(spec):
        import_model(Path(spec).absolute())
    else:
        scenes.build(spec, SHARED if SHARED.is_dir() else None)


def import_model(path):
    """Imports a model with Blender's own importer, up axis and scale as it sets them. ValueError if this Blender has
    none for such files, or it imports nothing."""
    suffix = model_files.suffix(path)
    name = next(filter(operator, model_files.IMPORTERS[suffix]), None)
    if not name:
        raise ValueError(f"{path.name}: this Blender imports no {suffix} files")
    refused = f"{path.name}: Blender cannot import this file"
    try:
        done = operator(name)(filepath=str(path), **model_files.OPTIONS.get(name, {})) == {"FINISHED"}
    except RuntimeError as error:  # with a traceback where the importer is written in Python
        raise ValueError(f"{refused}: {ending.sentence(str(error)).rpartition('; ')[2]}") from error
    if not done:
        raise ValueError(refused)
    if not len(framing.visible_points(bpy.context.evaluated_depsgraph_get())):
        raise ValueError(f"{path.name}: there is nothing in this file to draw")


def operator(name):
    """The operator "module.name"; None if this Blender has none of the name."""
    module, _, function = name.partition(".")
    found = getattr(getattr(bpy.ops, module), function)
    try:
        found.get_rna_type()
    except KeyError:
        return None
    return found
