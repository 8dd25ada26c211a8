# SPDX-License-Identifier: GPL-3.0-or-later
"""Atomic writing of output files: they are complete and from this run, or unchanged."""

import os
import secrets
from contextlib import contextmanager
from pathlib import Path


def check(path):
    """ValueError if no file can be written to `path`; call it before doing the work."""
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
    """Context with a temporary path beside `path`, with its suffix, to write to; at the end it is moved to `path` if
    is_whole(Path). If not, or on an OSError or RuntimeError (as Blender's operators raise), `path` is left unchanged
    and ValueError is raised."""
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
