# SPDX-License-Identifier: GPL-3.0-or-later
"""Focus emphasizes: a place in focus has more edges, lines and color than the same place out of focus."""

import sys
from pathlib import Path

import bpy
import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import scenes
from bench.focus import emphasis, world
from command.target import SHARED

SIZE = (1280, 720)  # smaller, the grain of watercolor paper is all of its edges


@pytest.mark.parametrize("model", ["image", "scene"])
@pytest.mark.parametrize("name", emphasis.STYLES)
def test_the_focus_stands_out(name, model):
    bpy.ops.wm.read_homefile()
    scenes.build("office", SHARED if SHARED.is_dir() else None)
    colorful = name in emphasis.COLORFUL
    ratios, jump = world.measure(lambda place: emphasis.compare(emphasis.Stage(place, name, model), 1, colorful), SIZE)
    wanted = {"edge contrast", "line density"} | ({"saturation"} if colorful else set())
    assert {what: ratio for what, ratio in ratios.items() if what in wanted and ratio < 2} == {}
    assert jump <= 0.2
