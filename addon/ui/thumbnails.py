# SPDX-License-Identifier: GPL-3.0-or-later
"""Thumbnails of styles, and other pictures of panels, as icons."""

import bpy
import bpy.utils.previews

from ..style import style_files

_kept = {}  # "pictures" -> the preview collection, created on first use
_read = {}  # name -> (path, modification time) of the picture that was loaded


def icon_of(name):
    """Icon id of a style's thumbnail; without one, of Blender's FILE_IMAGE icon."""
    path = style_files.picture(name)
    if path is None:
        return bpy.types.UILayout.bl_rna.functions["label"].parameters["icon"].enum_items["FILE_IMAGE"].value
    return icon_of_file(path, name)


def icon_of_file(path, name=None):
    """Icon id of a picture. `name`: by which it is kept until the file changes; None: that of the file."""
    name = name or path.name
    if "pictures" not in _kept:
        _kept["pictures"] = bpy.utils.previews.new()
    pictures, file = _kept["pictures"], (path, path.stat().st_mtime_ns)
    if name in pictures and _read[name] != file:
        del pictures[name]
    if name not in pictures:
        pictures.load(name, str(path), "IMAGE", force_reload=True)
        _read[name] = file
    return pictures[name].icon_id


def forget():
    """Frees all thumbnails."""
    _read.clear()
    pictures = _kept.pop("pictures", None)
    if pictures is not None:
        bpy.utils.previews.remove(pictures)


unregister = forget
