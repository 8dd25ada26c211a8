# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene that a command draws: opened, imported, or built. Runs inside Blender."""

from pathlib import Path

import blend_file
import bmesh
import bpy
import ending
import framing
import numpy as np
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


def seen_by(name):
    """The object of --camera; None without one. ValueError if there is none of the name."""
    if not name:
        return None
    found = bpy.context.scene.objects.get(name)
    if found is None:
        raise ValueError(f"--camera {name}: there is no such object in the scene")
    return found


def import_model(path):
    """Imports a model with Blender's own importer, up axis and scale as it sets them. ValueError if this Blender has
    none for such files, or it imports nothing."""
    suffix = model_files.suffix(path)
    importers = filter(None, map(operator, model_files.IMPORTERS[suffix]))
    importer = next(importers, None)
    if not importer:
        raise ValueError(f"{path.name}: this Blender imports no {suffix} files")
    refused = f"{path.name}: Blender cannot import this file"
    try:
        done = importer(filepath=str(path), **model_files.OPTIONS.get(suffix, {})) == {"FINISHED"}
    except RuntimeError as error:  # with a traceback where the importer is written in Python
        raise ValueError(f"{refused}: {ending.sentence(str(error)).rpartition('; ')[2]}") from error
    if not done:
        raise ValueError(refused)
    if suffix in model_files.APART:
        for mesh in bpy.data.meshes:
            weld(mesh)
    if not len(framing.visible_points(bpy.context.evaluated_depsgraph_get())):
        raise ValueError(f"{path.name}: there is nothing in this file to draw")


def weld(mesh):
    """Merges the vertices of a mesh that are in the same place: where faces share none, their sides would be borders.
    Normals of corners stay."""
    farthest = np.abs(_read(mesh.vertices, "co")).max(initial=0.0)
    normals = mesh.attributes.new("normals", "FLOAT_VECTOR", "CORNER")
    normals.data.foreach_set("vector", _read(mesh.corner_normals, "vector"))
    name, welded = normals.name, bmesh.new()
    welded.from_mesh(mesh)
    # Blender 4.3 misses neighbors nearer than the precision of their coordinates.
    bmesh.ops.remove_doubles(welded, verts=welded.verts, dist=1e-6 * farthest)
    welded.to_mesh(mesh)
    welded.free()
    normals = _read(mesh.attributes[name].data, "vector")
    mesh.attributes.remove(mesh.attributes[name])
    mesh.normals_split_custom_set(normals.reshape(-1, 3))


def _read(elements, name):
    """(3 n,) of an attribute of a mesh's elements."""
    values = np.empty(3 * len(elements), np.float32)
    elements.foreach_get(name, values)
    return values


def operator(name):
    """The operator "module.name"; None if this Blender has none of the name."""
    module, _, function = name.partition(".")
    found = getattr(getattr(bpy.ops, module), function)
    try:
        found.get_rna_type()
    except KeyError:
        return None
    return found
