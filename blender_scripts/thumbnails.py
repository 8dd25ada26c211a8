# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea figures thumbnails`: writes the thumbnails of the bundled styles, which show the same
scene as those of saved styles, and pictures of boards without and with line thinning for its panel."""

import sys
from pathlib import Path

from bl_ext.user_default.fovea import still_life, style
from bl_ext.user_default.fovea.style import style_picture

sys.path.insert(0, str(Path(__file__).parent))

import ending
import sheet


def thinning(folder):
    """Writes thinning_off.jpg and thinning_on.jpg."""
    plain = style.load("plain")
    pen = style.Pen(width=3.0, spacing=11.0)
    sets = tuple(line_set.replace(pen=pen, hidden=()) for line_set in plain.line_sets)
    for name, on in (("off", False), ("on", True)):
        drawn = plain.replace(line_sets=sets, elision=style.Elision(enabled=on))
        sheet.save(style_picture.draw(drawn, still_life.boards) / 255, Path(folder) / f"thinning_{name}.jpg")


def main(words):
    """words: the folder, then names of styles; none: all bundled styles."""
    folder, *names = words
    for name in names or style.names():
        sheet.save(style_picture.draw(style.load(name)) / 255, Path(folder) / f"{name}.jpg")
    thinning(folder)


if __name__ == "__main__":
    ending.run(main)
