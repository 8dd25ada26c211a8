# SPDX-License-Identifier: GPL-3.0-or-later
"""Atomic writing of files: they are complete and from this run, or unchanged. Without Blender and the rest of the
add-on, because the commands of a checkout write by it, too."""

import os
import secrets
from contextlib import contextmanager, suppress
from pathlib import Path

MORE = 1 << 20  # bytes that a disk with room takes at the end of a file that broke off


class NotWritten(ValueError):
    """A file could not be written; the message names it and the cause."""


@contextmanager
def written(path, is_whole=Path.is_file):
    """Context with a temporary path beside `path`, with its suffix, to write to; at the end it is moved to `path` if
    is_whole(Path). If not, or on an OSError or RuntimeError (as Blender's operators raise), `path` is left unchanged
    and NotWritten is raised."""
    place = Path(path).resolve()
    fresh = place.with_name(f".{secrets.token_hex(8)}{place.suffix}")
    try:
        with _told(path, fresh):
            yield fresh
            _move(fresh, place, is_whole)
    finally:
        with suppress(OSError):  # a folder that has become read-only says so even of a file that is not there
            fresh.unlink(missing_ok=True)


def move(fresh, place, is_whole):
    """Moves a file that is written to its place in the same file system, as `written` does at its end."""
    with _told(place, fresh):
        _move(fresh, place, is_whole)


def _move(fresh, place, is_whole):
    if not is_whole(fresh):
        raise OSError
    with fresh.open("rb+") as file:
        os.fsync(file.fileno())  # a full disk may be told only now
    fresh.replace(place)


@contextmanager
def _told(path, fresh):
    """Context that raises NotWritten, about `path`, for errors of writing `fresh`."""
    try:
        yield
    except (OSError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or _hindrance(fresh)
        raise NotWritten(f"{path} could not be written ({reason}): make room, or name another place") from error


def _hindrance(path):
    """Why a file broke off, in the system's words: what it says of writing more to its end."""
    try:
        with path.open("ab") as file:
            file.write(bytes(MORE))
            file.flush()
            os.fsync(file.fileno())
    except OSError as error:
        return error.strerror
    return "it broke off"
