# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea farm check FOLDER [FOLDER]`: whether rendered frames are whole, as recorded, and equal in both folders.
`fovea farm check --neighbours SCENE.blend`: whether frames are alone as they are in an animation."""

import argparse
import contextlib
import io
import json
import os
from pathlib import Path

from . import actions, quantities


def farm(target, words):
    options = parse(words)
    if options.neighbours:
        found = alone_and_in_order(target, *options.places, options.frames, options.scripts)
    else:
        found = checked(target, options.places, options.frames)
    print(json.dumps(found["result"]) if options.json else "\n".join(found["sentences"]))
    return 0 if found["result"]["equal"] else 1


def checked(target, folders, frames):
    """What the add-on's check finds in folders: {result, sentences}."""
    words = [*folders, *(["--frames", _range(*frames)] if frames else [])]
    return json.loads(actions.written_by(target, f"checking {folders[0].name}", "farm_check.py", words))


def alone_and_in_order(target, file, frames, scripts):
    """The same of frames of a file that one Blender renders in order, and of each by a Blender of its own."""
    together, alone = folders = [Path(os.environ["TMPDIR"], name) for name in ("together", "alone")]
    runs = [(together, *frames), *((alone, frame, frame) for frame in range(frames[0], frames[1] + 1))]
    with contextlib.redirect_stdout(io.StringIO()):  # paths of files that nobody keeps
        for folder, *some in runs:
            words = [str(file), "--frames", _range(*some), "-o", str(folder / "frame_####")]
            actions.render(target, [*words, *(["--scripts"] if scripts else [])])
    result = checked(target, folders, frames)["result"]
    told = [f"frame {each['frame']} is another one alone than in the animation" for each in result["different"]]
    end = "bake simulations; drivers and scripts may depend on nothing but the frame"
    how = "alone as in the animation" if result["equal"] else f"not all alone as in the animation: {end}"
    return {"result": result, "sentences": [*told, f"{result['frames']} frames: {how}"]}


def _range(first, last):
    return f"{first}-{last}"


def parse(words):
    parser = argparse.ArgumentParser("fovea farm", usage=argparse.SUPPRESS)
    parser.add_argument("action", choices=("check",))
    parser.add_argument("places", nargs="+", type=lambda text: Path(text).absolute(), metavar="FOLDER")
    parser.add_argument("--frames", type=quantities.frames, metavar="A-B", help="that have to be there")
    parser.add_argument("--neighbours", action="store_true", help="render frames of a file alone and in order")
    parser.add_argument("--scripts", action="store_true", help="run scripts in the file, and drivers that need them")
    parser.add_argument("--json", action="store_true", help="print what is found as JSON")
    options = parser.parse_args(words)
    (_check_file if options.neighbours else _check_folders)(parser, options)
    return options


def _check_folders(parser, options):
    if len(options.places) > 2:
        parser.error("one folder is looked at, or two are compared")
    for folder in options.places:
        if not folder.is_dir():
            parser.error(f"there is no folder {folder}")


def _check_file(parser, options):
    file, *others = options.places
    if others or file.suffix != ".blend" or not file.is_file():
        parser.error(f"--neighbours renders frames of one Blender file: {file if not others else others[0]} is none")
    if not options.frames:
        parser.error("--neighbours: name the frames, a few of one shot, as --frames 101-104")
