# SPDX-License-Identifier: GPL-3.0-or-later
"""Output files of commands: checked before the work, and written by the add-on's module, which needs no Blender."""

import importlib.util
import os
import tempfile
from pathlib import Path

from .target import PROJECT

# By its file, because the package `addon` is the staged one, with the native module, where it is imported at all.
_spec = importlib.util.spec_from_file_location("fovea_files", PROJECT / "addon" / "files.py")
_files = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(_files)
written = _files.written


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
        try:
            tempfile.TemporaryFile(dir=folder).close()
        except OSError as error:
            refused = f"nothing can be written to the folder {folder} ({error.strerror}): name another folder"
            raise ValueError(refused) from error
