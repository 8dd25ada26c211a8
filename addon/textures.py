# SPDX-License-Identifier: GPL-3.0-or-later
"""Pen textures of a frame: grey PNG files of the folder `textures`, where white is full ink."""

import json
from functools import lru_cache
from pathlib import Path

from .backend import cpu

FOLDER = Path(__file__).parent / "textures"
SOLID = "solid"


@lru_cache(maxsize=1)
def _lengths():
    """{texture: length of one repetition, in widths of the pen}."""
    path = FOLDER / "textures.json"
    return {name: entry["length_in_widths"] for name, entry in json.loads(path.read_text()).items()}


@lru_cache(maxsize=64)
def _read(name):
    return cpu.read_texture(FOLDER / f"{name}.png")


class Textures:
    """The textures that a style's pens use, numbered for native pens."""

    def __init__(self, style):
        names = {pen.texture for pen in style.pens()}
        self.names = sorted(names - {SOLID})
        self.native = [_read(name) for name in self.names]

    def index(self, pen):
        """Number of a pen's texture; None: solid."""
        return self.names.index(pen.texture) if pen.texture in self.names else None

    def length(self, pen):
        """Widths of the pen that one repetition covers."""
        return pen.length_scale * _lengths().get(pen.texture, 1.0)
