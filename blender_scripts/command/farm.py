# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea farm check FOLDER [FOLDER]`: whether rendered frames are whole, as recorded, and equal in both folders."""

import argparse
import json
import os
from pathlib import Path

from . import actions, quantities
from . import package as extension
from .target import PROJECT


def farm(target, words):
    options = parse(words)
    extension.install(target)
    out = Path(os.environ["TMPDIR"], "found.json")
    script = PROJECT / "blender_scripts" / "farm_check.py"
    actions.in_blender(target, f"checking {options.folders[0].name}", script, [out, *words[1:]])
    found = json.loads(out.read_text())
    print(json.dumps(found["result"]) if options.json else "\n".join(found["sentences"]))
    return 0 if found["result"]["equal"] else 1


def parse(words):
    parser = argparse.ArgumentParser("fovea farm", usage=argparse.SUPPRESS)
    parser.add_argument("action", choices=("check",))
    parser.add_argument("folders", nargs="+", type=lambda text: Path(text).absolute(), metavar="FOLDER")
    parser.add_argument("--frames", type=quantities.frames, metavar="A-B", help="that have to be there")
    parser.add_argument("--json", action="store_true", help="print what is found as JSON")
    options = parser.parse_args(words)
    if len(options.folders) > 2:
        parser.error("one folder is looked at, or two are compared")
    for folder in options.folders:
        if not folder.is_dir():
            parser.error(f"there is no folder {folder}")
    return options
