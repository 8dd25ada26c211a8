# SPDX-License-Identifier: GPL-3.0-or-later
"""Style files: those that ship, and the user's own, in the extension's folder for them. Their names differ."""

import logging
import re
from functools import lru_cache
from pathlib import Path

import bpy

from .. import native, style
from ..scene.own_preferences import ADDON, own
from . import style_picture

_log = logging.getLogger(__package__)


def user_folder(create=False):
    """Where the user's styles are. ValueError where the add-on was not installed as an extension."""
    return Path(bpy.utils.extension_path_user(ADDON, path="styles", create=create))


def user_names():
    try:
        return sorted(path.stem for path in user_folder().glob("*.json"))
    except ValueError:
        return []


@lru_cache(maxsize=1)
def shipped_names():
    return tuple(style.names())


def names():
    """The one that the user prefers, with which New begins, then those that ship, then the user's."""
    found = [*shipped_names(), *(name for name in user_names() if name not in shipped_names())]
    wished = own().default_style if own() else style.DEFAULT
    return sorted(found, key=lambda name: name != wished)


def load(name):
    """The Style of that name; StyleError says what is wrong."""
    if name in shipped_names():
        return style.load(name)
    if name not in user_names():
        raise style.StyleError(f"there is no style '{name}'; there are: {', '.join(names())}")
    return style.read(user_folder() / f"{name}.json")


def file_name(title):
    """A name for a user's style that is safe as that of a file. StyleError where there is none."""
    name = re.sub(r"\W+", "_", title, flags=re.ASCII).strip("_").lower()
    if not name:
        raise style.StyleError("a style's name needs letters or digits")
    if name in shipped_names():
        raise style.StyleError(f"'{name}' ships with Fovea; save the style by another name")
    return name


def save(name, wanted):
    """Writes a Style to the user's folder, over one that has the name, and its thumbnail beside it: its path."""
    path = user_folder(create=True) / f"{name}.json"
    write(path, wanted)
    _draw(_picture_of(path), wanted)
    return path


def write(path, wanted):
    """All of the file or, where that fails, nothing of it."""
    _write(Path(path), style.dump(wanted).encode())


def rename(name, fresh):
    """A user's style and its thumbnail have another name, which no style has."""
    if fresh in user_names():
        raise style.StyleError(f"there is a style '{fresh}' already")
    path, target = _of_user(name), user_folder() / f"{fresh}.json"
    path.rename(target)
    if _picture_of(path).exists():
        _picture_of(path).replace(_picture_of(target))


def delete(name):
    path = _of_user(name)
    path.unlink()
    _picture_of(path).unlink(missing_ok=True)


def picture(name):
    """The thumbnail of a style, or None."""
    if name in shipped_names():
        path = style.FOLDER / f"{name}.jpg"
    else:
        path = _picture_of(user_folder() / f"{name}.json") if name in user_names() else None
    return path if path and path.is_file() and not path.is_symlink() else None


def _of_user(name):
    if name not in user_names():
        raise style.StyleError(f"there is no saved style '{name}' of yours")
    return user_folder() / f"{name}.json"


def _picture_of(path):
    return path.with_suffix(".png")


def _draw(path, wanted):
    """A style without a thumbnail is better than one with the thumbnail of another."""
    try:
        _write(path, style_picture.png(style_picture.draw(wanted)))
    except (native.Unavailable, ValueError) as error:
        _log.warning("no thumbnail of %s: %s", path.stem, error)
        path.unlink(missing_ok=True)


def _write(path, data):
    fresh = path.with_name(f"{path.name}.new")
    fresh.write_bytes(data)
    fresh.replace(path)
