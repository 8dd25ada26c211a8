# SPDX-License-Identifier: GPL-3.0-or-later
"""Style files: the bundled ones, and the user's in the extension's user folder. User styles cannot have bundled
names."""

import logging
import re
import struct
from functools import lru_cache
from pathlib import Path

import bpy

from .. import files, line_files, native, style
from ..scene.own_preferences import ADDON, own
from . import style_picture

LARGEST = 1024  # pixels along a side of a thumbnail that is shown
_log = logging.getLogger(__package__)


def user_folder(create=False):
    """Folder of the user's styles. ValueError if the add-on was not installed as an extension."""
    return Path(bpy.utils.extension_path_user(ADDON, path="styles", create=create))


def user_names():
    try:
        return sorted(path.stem for path in user_folder().glob("[!.]*.json"))  # hidden: of a killed Blender
    except ValueError:
        return []


@lru_cache(maxsize=1)
def shipped_names():
    return tuple(style.names())


def names():
    """Names of all styles: first the default of the preferences, which New uses, then the bundled, then the user's."""
    found = [*shipped_names(), *(name for name in user_names() if name not in shipped_names())]
    wished = own().default_style if own() else style.DEFAULT
    return sorted(found, key=lambda name: name != wished)


def load(name):
    """The Style of that name. StyleError if it does not exist or is invalid."""
    if name in shipped_names():
        return style.load(name)
    if name not in user_names():
        raise style.StyleError(f"there is no style '{name}'; there are: {', '.join(names())}")
    return style.read(user_folder() / f"{name}.json")


def file_name(title):
    """A safe file name for a user's style. StyleError if none is possible or it is that of a bundled style."""
    name = re.sub(r"\W+", "_", title, flags=re.ASCII).strip("_").lower()
    if not name:
        raise style.StyleError("a style's name needs letters or digits")
    if name in shipped_names():
        raise style.StyleError(f"'{name}' ships with Fovea; save the style by another name")
    return name


def save(name, wanted):
    """Writes a Style and its thumbnail to the user's folder, replacing one of the same name; returns its path."""
    path = user_folder(create=True) / f"{name}.json"
    for old in (path, _picture_of(path)):
        if old.is_symlink():  # nothing outside the folder is written
            old.unlink()
    write(path, wanted)
    _draw(_picture_of(path), wanted)
    return path


def write(path, wanted):
    """Writes a Style to a file atomically: on an error the old file stays. NotWritten if it cannot be written.
    StyleError if a file that its lines are given cannot be brought beside it."""
    try:
        wanted = line_files.beside(wanted, Path(path).parent)
    except files.NotWritten:
        raise
    except ValueError as error:
        raise style.StyleError(str(error)) from error
    with files.written(path) as fresh:
        fresh.write_bytes(style.dump(wanted).encode())


def rename(name, fresh):
    """Renames a user's style and its thumbnail. StyleError if the new name is taken."""
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
    """Path of a style's thumbnail, or None. Those of the user are none if they are links, or large, by their header."""
    if name in shipped_names():
        path = style.FOLDER / f"{name}.jpg"
        return path if path.is_file() else None
    path = _picture_of(user_folder() / f"{name}.json") if name in user_names() else None
    return path if path and path.is_file() and not path.is_symlink() and _is_small(path) else None


def _is_small(path):
    """Whether a file has the header of a PNG of at most LARGEST pixels along each side."""
    with path.open("rb") as file:
        header = file.read(24)
    sizes = struct.unpack(">II", header[16:]) if len(header) == 24 and header[1:4] == b"PNG" else (LARGEST + 1,)
    return max(sizes) <= LARGEST


def _of_user(name):
    if name not in user_names():
        raise style.StyleError(f"there is no preset '{name}' of yours")
    return user_folder() / f"{name}.json"


def _picture_of(path):
    return path.with_suffix(".png")


def _draw(path, wanted):
    """Writes a style's thumbnail; if that fails, removes the old one, which would be of another style."""
    try:
        drawn = style_picture.png(style_picture.draw(wanted))
        with files.written(path) as fresh:
            fresh.write_bytes(drawn)
    except (native.Unavailable, ValueError) as error:
        _log.warning("no thumbnail of %s: %s", path.stem, error)
        path.unlink(missing_ok=True)
