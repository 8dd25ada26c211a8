# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of `fovea render`: parsed outside Blender, to report errors at once, and again by render.py inside it."""

import argparse
import os
from pathlib import Path

from . import output, quantities


def parse(words):
    parser = argparse.ArgumentParser("fovea render", usage=argparse.SUPPRESS)
    parser.add_argument("file", type=lambda text: Path(text).absolute(), help="SCENE.blend")
    parser.add_argument("--frames", type=quantities.frames, metavar="A-B", help="without it, those of the file")
    parser.add_argument("-o", "--output", metavar="DIR/NAME_####", help="without it, the place that the file names")
    parser.add_argument("--resume", action="store_true", help="only frames that are not done")
    parser.add_argument("--scripts", action="store_true", help="run scripts in the file, and drivers that need them")
    parser.add_argument("--threads", type=int, default=0, metavar="N", help="at most; 0: all processors")
    options = parser.parse_args(words)
    try:
        _check(options)
    except ValueError as error:
        parser.error(str(error))
    return options


def _check(options):
    if options.file.suffix != ".blend" or not options.file.is_file():
        raise ValueError(f"there is no Blender file {options.file}")
    if not 0 <= options.threads <= 1024:
        raise ValueError(f"--threads {options.threads}: name 1 to 1024, or 0 for all processors")
    if not options.output:
        return
    place = Path(options.output).absolute()
    if options.output.endswith(os.sep) or place.is_dir():
        raise ValueError(f"{options.output} is a folder: name frames in it, as {place / 'name_####'}")
    folder = place.parent
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ValueError(f"the folder {folder} cannot be made ({error.strerror}): name another one") from error
    output.check(folder / "frame")
