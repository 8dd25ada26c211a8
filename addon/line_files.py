# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that line definitions are given, as models of learned lines. Without Blender.

In a Style a file is a path, absolute where it was read from a style file or from Blender. In style files it is relative
to the style's folder, which it may not leave. What cannot be read finds no lines; `remarks` says so."""

import hashlib
import shutil
from functools import cache, lru_cache
from pathlib import Path

from . import catalogue, files, learned_lines

BESIDE = "models"  # folder beside a style file, for copies of those from elsewhere
KEPT = 8  # files


def contents(chosen):
    """{path: native FileContent} of the files of a Style that can be read."""
    return {path: found for path in _paths(chosen) if not isinstance(found := _content(path), str)}


def remarks(chosen):
    """A sentence for each file of a Style that cannot be read, and for each definition that lacks its file."""
    told = {}
    for label, parameter, path in _given(chosen):
        if not path:
            told[f"{label} draws nothing: name its file under {parameter}"] = None
        elif isinstance(problem := _content(path), str):
            told[f"{label} draws nothing: {problem}"] = None
    return list(told)


def parameters(names, path):
    """{name: {parameter: path}} of the definitions among those named that are given a file, which `path` is; None:
    there is no file. ValueError if it cannot be read, if one lacks it, or if none needs it."""
    wanted = {name: definition["file"]["name"] for name in names if (definition := _definitions().get(name))}
    if path is None and wanted:
        raise ValueError(f"{', '.join(wanted)}: name the file that it is given by --model")
    if path is None:
        return {}
    if not wanted:
        raise ValueError(f"--model: {', '.join(names)} needs no file")
    learned_lines.read(path)
    return {name: {file: str(path)} for name, file in wanted.items()}


def stamp(chosen):
    """What tells whether the files of a Style have changed, to be compared."""
    return tuple((path, _stamp(path)) for path in _paths(chosen))


def absolute(chosen, folder):
    """A Style with the paths of a style file in that folder. ValueError if one leads out of it, as by a link."""
    folder = Path(folder)

    def place(path):
        there = folder / path
        if not there.resolve().is_relative_to(folder.resolve()):
            raise ValueError(f"{path}, which the style names, leads out of its folder: put the file itself there")
        return str(there.absolute())

    return _changed(chosen, place)


def beside(chosen, folder):
    """A Style for a style file in that folder: paths are relative, and files from elsewhere are copied to it.
    ValueError if one cannot be."""
    folder = Path(folder).absolute()

    def place(path):
        there = Path(path).absolute()
        inside = there if there.is_relative_to(folder) else _copied(there, folder / BESIDE)
        return inside.relative_to(folder).as_posix()

    return _changed(chosen, place)


def _copied(path, folder):
    """The path of a copy of a file in a folder, one that is there or a new one."""
    try:
        data = path.read_bytes()
        place = folder / path.name
        if place.exists() and place.read_bytes() != data:
            place = folder / f"{path.stem}_{hashlib.sha256(data).hexdigest()[:8]}{path.suffix}"
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ValueError(f"{path}, which a line definition is given, cannot be copied: {error.strerror}") from error
    with files.written(place) as fresh:
        shutil.copyfile(path, fresh)
    return place


@cache
def _definitions():
    """{name: definition} of those that are given a file. A Style may name what is no definition."""
    return {definition["name"]: definition for definition in catalogue.definitions() if definition["file"]}


def _given(chosen):
    """(label of the definition, label of its file, path or None) of those of a Style that are given one."""
    for line_set in chosen.line_sets:
        for name, values in line_set.kinds.items():
            if definition := _definitions().get(name):
                yield definition["label"], definition["file"]["label"], values.get(definition["file"]["name"])


def _paths(chosen):
    return dict.fromkeys(path for _, _, path in _given(chosen) if path)


def _changed(chosen, place):
    """A Style with place(path) of the path of each file."""
    if not _paths(chosen):
        return chosen

    def moved(name, values):
        file = _definitions()[name]["file"]["name"] if name in _definitions() else None
        return values | {file: place(values[file])} if file in values else values

    sets = (
        line_set.replace(kinds={name: moved(name, values) for name, values in line_set.kinds.items()})
        for line_set in chosen.line_sets
    )
    return chosen.replace(line_sets=tuple(sets))


def _stamp(path):
    try:
        found = Path(path).stat()
    except (OSError, ValueError):
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino


def _content(path):
    """The native FileContent of a file, or a sentence that says why there is none."""
    return _read(path, _stamp(path))


@lru_cache(maxsize=KEPT)
def _read(path, _changed):
    try:
        return learned_lines.read(path).content
    except ValueError as error:
        return str(error)
