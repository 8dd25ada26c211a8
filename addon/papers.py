# SPDX-License-Identifier: GPL-3.0-or-later
"""Papers with a surface: grey PNG files of the folder `papers`, where white is high."""

from functools import lru_cache
from pathlib import Path

from .backend import cpu

FOLDER = Path(__file__).parent / "papers"
SMOOTH = "none"


@lru_cache(maxsize=8)
def _read(name):
    return cpu.read_paper(FOLDER / f"{name}.png")


def texture(paper):
    """The native PaperTexture of a style's paper; None: it is smooth."""
    return None if paper.texture == SMOOTH else _read(paper.texture)
