"""Pictures of styles, as icons."""

import bpy.utils.previews

from .. import style_files

_kept = {}  # "styles": the collection, while there is an interface to show it


def icon_of(name):
    """The icon of a style's picture; 0 where it has none."""
    path = style_files.picture(name)
    if path is None:
        return 0
    pictures = _kept.setdefault("styles", None) or bpy.utils.previews.new()
    _kept["styles"] = pictures
    if name not in pictures:
        pictures.load(name, str(path), "IMAGE")
    return pictures[name].icon_id


def forget():
    pictures = _kept.pop("styles", None)
    if pictures is not None:
        bpy.utils.previews.remove(pictures)
