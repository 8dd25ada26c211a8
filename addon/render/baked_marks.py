# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks of lines of the view that are handed on through a whole shot, baked to a file: from its first frame, or the
first one after a change of the camera, to the last. Each frame takes its own from the file, if its lines are those
that were baked; so frames depend on the scene and on this file, and on no other frame."""

import zipfile
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from urllib.parse import quote

import bpy
import numpy as np

from .. import files
from . import as_rendered

SCHEMA = 1
MOST_PX = 1e9
MOST_BYTES = 4 << 30  # of what a file unpacks to: 500 million places of marks


@dataclass(frozen=True)
class Baked:
    """n frames, ascending by number; the marks of frame i are marks[offsets[i]:offsets[i + 1]], in pixels."""

    frames: np.ndarray  # (n,) int64
    contents: np.ndarray  # (n,) uint64: native NearLines.marks_content of their lines
    offsets: np.ndarray  # (n + 1,) int64
    marks: np.ndarray  # (m,) float64

    def of(self, frame):
        """(content, (m,) marks) of a frame; None: it is not there."""
        i = np.searchsorted(self.frames, frame)
        if i == len(self.frames) or self.frames[i] != frame:
            return None
        return int(self.contents[i]), self.marks[self.offsets[i] : self.offsets[i + 1]]


def place(scene, layer):
    """Path of the file of a scene's view layer; None: the Blender file is not saved."""
    if not bpy.data.filepath:
        return None
    names = "+".join(quote(name, safe="") for name in (as_rendered.name_of(scene), layer.name))
    return Path(bpy.data.filepath).with_suffix(".fovea") / f"marks_{names}.npz"


def of(scene, layer, frame):
    """(content, (m,) marks) of a frame of a scene's view layer; None: they are not baked."""
    path = place(scene, layer)
    baked = path and read(path)
    return baked and baked.of(frame)


def read(path):
    """The Baked of a file; None: there is none, or it is not one."""
    try:
        found = path.stat()
    except OSError:
        return None
    return _read(path, found.st_mtime_ns, found.st_size)


@lru_cache(maxsize=1)
def _read(path, _changed, _size):
    with suppress(Exception):  # whatever numpy and zlib make of a broken file
        with zipfile.ZipFile(path) as packed:
            if sum(each.file_size for each in packed.infolist()) > MOST_BYTES:
                return None
        with np.load(path, allow_pickle=False) as file:
            if int(file["schema"]) != SCHEMA:
                return None
            kinds = {"frames": np.int64, "contents": np.uint64, "offsets": np.int64, "marks": np.float64}
            made = Baked(**{name: file[name].astype(kind, casting="safe") for name, kind in kinds.items()})
        return made if _is_sound(made) else None
    return None


def _is_sound(baked):
    count = len(baked.frames)
    return (
        all(column.ndim == 1 for column in vars(baked).values())
        and len(baked.contents) == count
        and len(baked.offsets) == count + 1
        and (np.diff(baked.frames) > 0).all()
        and (np.diff(baked.offsets) >= 0).all()
        and baked.offsets[0] == 0
        and baked.offsets[-1] == len(baked.marks)
        and (np.abs(baked.marks) < MOST_PX).all()
    )


def write(path, frames):
    """Writes a file of {frame number: (content, (m,) marks)}. files.NotWritten if it cannot be."""
    numbers = sorted(frames)
    marks = [np.asarray(frames[number][1], np.float64) for number in numbers]
    columns = {
        "schema": np.int64(SCHEMA),
        "frames": np.array(numbers, np.int64),
        "contents": np.array([frames[number][0] for number in numbers], np.uint64),
        "offsets": np.cumsum([0, *map(len, marks)], dtype=np.int64),
        "marks": np.concatenate([np.zeros(0), *marks]),
    }
    try:
        path.parent.mkdir(exist_ok=True)
    except OSError as error:
        raise files.NotWritten(
            f"{path.parent} could not be made ({error.strerror}): make room, or save elsewhere"
        ) from error
    with files.written(path, lambda fresh: _read(fresh, 0, 0) is not None) as fresh, fresh.open("wb") as file:
        np.savez_compressed(file, **columns)
    _read.cache_clear()
