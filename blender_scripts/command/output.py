# SPDX-License-Identifier: GPL-3.0-or-later
"""Output files of commands: checked before the work, and written by the add-on's module, which needs no Blender."""

import os
import tempfile
from pathlib import Path

from . import addon_files

written = addon_files.loaded("files").written


def check(*paths):
    """ValueError if a file cannot be written to one of the paths; call it before doing the work."""
    places = [Path(path).resolve() for path in paths]
    for path, place in zip(paths, places, strict=True):
        if place.is_dir():
            raise ValueError(f"{path} is a folder: name a file in it")
        if place.exists() and not (place.is_file() and os.access(place, os.W_OK)):
            raise ValueError(f"{path} cannot be replaced: name another file")
    for folder in dict.fromkeys(place.parent for place in places):
        if not folder.is_dir():
            raise ValueError(f"there is no folder {folder}")
        _check_room(folder)


def check_folder(path):
    """As `check`, for a folder of files, which may be made together with those above it."""
    place = Path(path).resolve()
    there = next(each for each in (place, *place.parents) if each.exists())
    if not there.is_dir():
        raise ValueError(f"{there} is a file: name a folder")
    _check_room(there)


def _check_room(folder):
    try:
        tempfile.TemporaryFile(dir=folder).close()
    except OSError as error:
        refused = f"nothing can be written to the folder {folder} ({error.strerror}): name another folder"
        raise ValueError(refused) from error
