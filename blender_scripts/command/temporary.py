# SPDX-License-Identifier: GPL-3.0-or-later
"""Temporary files of runs: each has a folder of its own in the cache, which goes with it. What a killed run left there
goes with the next one: the lock on a folder ends with the last process that holds it."""

import contextlib
import fcntl
import os
import shutil
import tempfile
from pathlib import Path

LOCK = ".lock"
CRASH = ".crash.txt"  # end of the names of Blender's reports of crashes, which stay


@contextlib.contextmanager
def folder(place):
    """Context with a new folder in `place` for the temporary files of this process and its children. Children that are
    to hold it, too, get the yielded descriptor."""
    place.mkdir(parents=True, exist_ok=True)
    with (place / LOCK).open("w") as all_runs:
        fcntl.flock(all_runs, fcntl.LOCK_EX)
        for left in place.iterdir():
            if left.name != LOCK and not _is_held(left):
                _remove(left)
        own = Path(tempfile.mkdtemp(dir=place))
        held = (own / LOCK).open("w")
        fcntl.flock(held, fcntl.LOCK_EX)
    os.set_inheritable(held.fileno(), True)  # of a Blender that takes the place of this process
    os.environ["TMPDIR"], tempfile.tempdir = str(own), None
    try:
        yield held.fileno()
    finally:
        held.close()
        _remove(own)


def _is_held(left):
    try:
        with (left / LOCK).open() as file:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    except OSError:
        pass  # no run's folder, or one that a run had hardly begun
    return False


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
