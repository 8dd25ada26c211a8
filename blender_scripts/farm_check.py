# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea farm check`: OUT.json and its words. Writes what the add-on's check finds."""

import json
import sys
from pathlib import Path

from bl_ext.user_default.fovea.render import frame_check

sys.path.insert(0, str(Path(__file__).parent))

import ending
from command import farm


def main(words):
    options = farm.parse(["check", *words[1:]])
    first, last = options.frames or (1, 0)
    result = frame_check.check(options.places, range(first, last + 1))
    found = {"result": result, "sentences": list(frame_check.sentences(result))}
    Path(words[0]).write_text(json.dumps(found), encoding="utf-8")


if __name__ == "__main__":
    ending.run(main)
