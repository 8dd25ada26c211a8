# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea figures thumbnails`: writes the thumbnails of the bundled styles, which show the same
scene as those of saved styles."""

import sys
from pathlib import Path

from bl_ext.user_default.fovea import style
from bl_ext.user_default.fovea.style import style_picture

sys.path.insert(0, str(Path(__file__).parent))

import ending
import sheet


def main(words):
    """words: the folder, then names of styles; none: all bundled styles."""
    folder, *names = words
    for name in names or style.names():
        sheet.save(style_picture.draw(style.load(name)) / 255, Path(folder) / f"{name}.jpg")


if __name__ == "__main__":
    ending.run(main)
