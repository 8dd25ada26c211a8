# SPDX-License-Identifier: GPL-3.0-or-later
"""Folders for temporary files, each held by one process: what a killed process left goes when the next one begins.
Without Blender and the rest of the add-on, because the commands of a checkout use it, too."""

import contextlib
import os
import shutil
import tempfile
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows: what a killed process left stays
    fcntl = None

LOCK = ".lock"


@contextlib.contextmanager
def held_folder(place, prefix="", remove=shutil.rmtree):
    """Context with (a new folder in `place`, the descriptor of its lock). The lock ends with the last process that has
    the descriptor. Entries of `place` with the prefix that nobody holds go by remove(Path)."""
    place.mkdir(parents=True, exist_ok=True)
    with (place / LOCK).open("w") as all_folders:
        lock(all_folders)
        for left in place.iterdir():
            if left.name != LOCK and left.name.startswith(prefix) and not _is_held(left):
                remove(left)
        own = Path(tempfile.mkdtemp(dir=place, prefix=prefix))
        held = (own / LOCK).open("w")
        lock(held)
    os.set_inheritable(held.fileno(), True)  # of a program that takes the place of this process
    try:
        yield own, held.fileno()
    finally:
        held.close()
        remove(own)


def lock(file):
    """Waits until no other process has a lock of this open file, which ends as the file is closed. Windows and file
    systems without locks have none, and _is_held says of all folders there that they are held."""
    if fcntl:
        with contextlib.suppress(OSError):
            fcntl.flock(file, fcntl.LOCK_EX)


def _is_held(left):
    if not fcntl:
        return True
    try:
        with (left / LOCK).open("r+") as file:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (FileNotFoundError, NotADirectoryError):
        return False  # no held folder, or one that a process had hardly begun
    except OSError:
        return True
    return False
