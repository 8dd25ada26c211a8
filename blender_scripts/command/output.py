# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that a command writes for the user: whole and written by this run, or left as they were."""

import os
import secrets
from contextlib import contextmanager
from pathlib import Path


def check(path):
    """ValueError where no file can be written as `path`, told before anything is made for it."""
    place = Path(path).resolve()
    if place.is_dir():
        raise ValueError(f"{path} is a folder: name a file in it")
    if not place.parent.is_dir():
        raise ValueError(f"there is no folder {place.parent}")
    if not os.access(place.parent, os.W_OK | os.X_OK):
        raise ValueError(f"nothing can be written to the folder {place.parent}: name another folder")
    if place.exists() and not (place.is_file() and os.access(place, os.W_OK)):
        raise ValueError(f"{path} cannot be replaced: name another file")


@contextmanager
def written(path, is_whole=Path.is_file):
    """A temporary name beside `path`, with its suffix, to write to; what is there at the end is moved onto `path` when
    is_whole(Path) says so. Where it does not, and at an OSError or RuntimeError (as Blender's operators raise),
    nothing is changed and ValueError says that `path` could not be written."""
    place = Path(path).resolve()
    fresh = place.with_name(f".{secrets.token_hex(8)}{place.suffix}")
    try:
        yield fresh
        if not is_whole(fresh):
            raise OSError
        fresh.replace(place)
    except (OSError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or "its disk did not take all of it"
        raise ValueError(f"{path} could not be written ({reason}): make room, or name another place") from error
    finally:
        fresh.unlink(missing_ok=True)
