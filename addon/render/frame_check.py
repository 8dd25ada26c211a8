# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks folders of rendered frames: that each is whole, as it was recorded, and in both of two folders the same.

Also as a command of Blender's, for farms: `blender --command fovea_check FOLDER [FOLDER] [--frames A-B,C]`."""

import argparse
import re
from collections import defaultdict
from pathlib import Path

import bpy
import numpy as np

from .. import frame_records
from . import whole_pictures

COMMAND = "fovea_check"
PICTURES = (*whole_pictures.ENDS, ".jpeg", ".tif", ".tiff", ".bmp", ".tga", ".jp2")


def check(folders, frames=()):
    """A dict of what is found in one or two folders. `frames`: numbers of those that have to be there.

    equal: whether nothing below is found; frames: how many there are; missing: {folder: frames}; broken: paths of files
    that are not whole or, though recorded, not there; changed: of those that differ from their record; different:
    [{frame, a, b, max_difference}], paths and the largest difference of a value, None where the sizes differ."""
    found = [_frames(Path(folder)) for folder in folders]
    wanted = sorted({*frames, *(frame for each in found for frame in each)})
    result = {"equal": True, "frames": len(wanted), "missing": {}, "broken": [], "changed": [], "different": []}
    for folder, each in zip(folders, found):
        if absent := [frame for frame in wanted if frame not in each]:
            result["missing"][str(folder)] = absent
    hashes = {}
    for path, recorded in (entry for each in found for files in each.values() for entry in files):
        hashes[path] = whole_pictures.pixels_sha256(path)
        if hashes[path] is None:
            result["broken"].append(str(path))
        elif recorded not in (None, hashes[path]):
            result["changed"].append(str(path))
    if len(found) == 2:
        for frame in sorted(found[0].keys() & found[1].keys()):
            result["different"] += _differences(frame, found[0][frame], found[1][frame], hashes)
    result["equal"] = not any(result[name] for name in ("missing", "broken", "changed", "different"))
    return result


def _frames(folder):
    """{frame: [(path, hash of its pixels as recorded, or None)], sorted} of the pictures that are recorded or have the
    frame's number at the end of their name."""
    if not folder.is_dir():
        raise ValueError(f"there is no folder {folder}")
    records, frames = frame_records.read(folder), defaultdict(list)
    for name in sorted({*records, *(path.name for path in folder.iterdir() if path.suffix.lower() in PICTURES)}):
        number = re.search(r"(-?\d+)(_[A-Za-z])?$", Path(name).stem)  # of stereo pictures with the eye after it
        if name in records:
            frames[records[name]["frame"]].append((folder / name, records[name]["pixels_sha256"]))
        elif number:
            frames[int(number[1])].append((folder / name, None))
    return frames


def _differences(frame, ours, others, hashes):
    if len(ours) != len(others):
        return [{"frame": frame, "a": str(ours[0][0]), "b": str(others[0][0]), "max_difference": None}]
    found = []
    for (a, _), (b, _) in zip(ours, others):
        if hashes[a] != hashes[b] and hashes[a] and hashes[b]:
            largest = _largest_difference(a, b)
            if largest != 0.0:  # others than PNG and OpenEXR may differ by dates alone
                found.append({"frame": frame, "a": str(a), "b": str(b), "max_difference": largest})
    return found


def _largest_difference(a, b):
    """Of all values; None where two files are of other sizes, or have layers, whose values Blender does not give."""
    first, second = _values(a), _values(b)
    if first.shape != second.shape or not first.size:
        return None
    return float(np.abs(first - second).max())


def _values(path):
    image = bpy.data.images.load(str(path))
    values = np.empty(len(image.pixels), np.float32)
    if len(values):
        image.pixels.foreach_get(values)
    values = values.reshape(*image.size, -1) if len(values) else values
    bpy.data.images.remove(image)
    return values


def sentences(result):
    """What `check` has found, a line each."""
    for folder, frames in result["missing"].items():
        yield f"{folder} lacks frames {_ranges(frames)}"
    yield from (f"{path} is not {'whole' if Path(path).exists() else 'there'}" for path in result["broken"])
    yield from (f"{path} is not what was rendered there" for path in result["changed"])
    for each in result["different"]:
        far = each["max_difference"]
        how = "in size or layers" if far is None else f"by {far:.6g} at most"
        yield f"frame {each['frame']} differs {how}: {each['a']}, {each['b']}"
    yield f"{result['frames']} frames: {'all as they should be' if result['equal'] else 'not as they should be'}"


def _ranges(frames):
    """Numbers in order as "1-3, 7"."""
    runs = []
    for frame in frames:
        if runs and frame == runs[-1][1] + 1:
            runs[-1][1] = frame
        else:
            runs.append([frame, frame])
    return ", ".join(str(a) if a == b else f"{a}-{b}" for a, b in runs)


def _numbers(text):
    """Frames from 1-100,150."""
    ends = [[int(end) for end in part.split("-")] for part in text.split(",")]
    return [frame for part in ends for frame in range(part[0], part[-1] + 1)]


def _command(words):
    parser = argparse.ArgumentParser(f"blender --command {COMMAND}")
    parser.add_argument("folders", nargs="+", metavar="FOLDER", help="one, or two whose frames are compared")
    parser.add_argument("--frames", type=_numbers, default=(), metavar="A-B,C", help="that have to be there")
    options = parser.parse_args(words)
    if len(options.folders) > 2:
        parser.error("one folder is looked at, or two are compared")
    try:
        result = check(options.folders, options.frames)
    except ValueError as error:
        print(f"Error: {error}")
        return 2
    print(*sentences(result), sep="\n")
    return 0 if result["equal"] else 1


_registered = None


def register():
    global _registered
    _registered = bpy.utils.register_cli_command(COMMAND, _command)


def unregister():
    bpy.utils.unregister_cli_command(_registered)
