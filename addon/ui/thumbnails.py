# SPDX-License-Identifier: GPL-3.0-or-later
"""Thumbnails of styles, as icons."""

import bpy
import bpy.utils.previews

from ..style import style_files

_kept = {}  # "styles" -> the preview collection, created on first use
_read = {}  # style -> (path, modification time) of the thumbnail that was loaded


def icon_of(name):
    """Icon id of a style's thumbnail; without one, of Blender's FILE_IMAGE icon."""
    path = style_files.picture(name)
    if path is None:
        return bpy.types.UILayout.bl_rna.functions["label"].parameters["icon"].enum_items["FILE_IMAGE"].value
    if "styles" not in _kept:
        _kept["styles"] = bpy.utils.previews.new()
    pictures, file = _kept["styles"], (path, path.stat().st_mtime_ns)
    if name in pictures and _read[name] != file:
        del pictures[name]
    if name not in pictures:
        pictures.load(name, str(path), "IMAGE", force_reload=True)
        _read[name] = file
    return pictures[name].icon_id


def forget():
    """Frees all thumbnails."""
    _read.clear()
    pictures = _kept.pop("styles", None)
    if pictures is not None:
        bpy.utils.previews.remove(pictures)


unregister = forget
