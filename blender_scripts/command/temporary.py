# SPDX-License-Identifier: GPL-3.0-or-later
"""Temporary files of runs: each has a folder of its own in the cache, which goes with it, or, of a killed run, with the
next one."""

import contextlib
import os
import shutil
import tempfile

from . import addon_files

CRASH = ".crash.txt"  # end of the names of Blender's reports of crashes, which stay

_held_folder = addon_files.loaded("held_folder").held_folder


@contextlib.contextmanager
def folder(place):
    """Context with a new folder in `place` for the temporary files of this process and its children. Children that are
    to hold it, too, get the yielded descriptor."""
    with _held_folder(place, remove=_remove) as (own, held):
        os.environ["TMPDIR"], tempfile.tempdir = str(own), None
        yield held


def _remove(left):
    """Removes a file or a folder, and leaves reports of crashes."""
    if left.is_dir() and not left.is_symlink():
        for inner in left.iterdir():
            if not inner.name.endswith(CRASH):
                shutil.rmtree(inner) if inner.is_dir() and not inner.is_symlink() else inner.unlink(missing_ok=True)
        with contextlib.suppress(OSError):
            left.rmdir()
    elif not left.name.endswith(CRASH):
        left.unlink(missing_ok=True)
