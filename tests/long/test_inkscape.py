# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings in Inkscape, where it is installed in the suite."""

import re
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from frames import BLENDER

DRAW = Path(__file__).parents[2] / "blender_scripts" / "draw.py"
SVG, INKSCAPE = "{http://www.w3.org/2000/svg}", "{http://www.inkscape.org/namespaces/inkscape}"


@pytest.fixture
def inkscape():
    reason = "there is no inkscape in this suite, which takes 300 MB: apt-get install it there"
    return shutil.which("inkscape") or pytest.skip(reason)


def told(inkscape, *words):
    done = subprocess.run([inkscape, *words], capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_it_lists_layers_of_colors_and_of_visible_and_hidden_lines(inkscape, tmp_path):
    file = tmp_path / "boxes.svg"
    words = ["boxes:5", "--style", "watercolor", "--hidden", "--color-areas", "-o", file]
    subprocess.run([BLENDER, "-b", "--python-exit-code", "1", "-P", DRAW, "--", *words], check=True)
    root = ElementTree.parse(file).getroot()
    outer = [layer.get("id") for layer in root.findall(f"{SVG}g")]
    assert outer[:3] == ["paper", "colors", "lines1"]
    selected = told(inkscape, "--actions=select-all:layers;select-list", file)
    assert re.findall(r"^(\w+) cloned", selected, re.M) == outer
    sizes = {row.split(",")[0] for row in told(inkscape, "--query-all", file).splitlines()}
    inner = {layer.get("id"): layer for layer in root.findall(f"{SVG}g/{SVG}g")}
    assert {"lines1-hidden", "lines1-visible"} <= inner.keys() <= sizes
    assert {layer.get(f"{INKSCAPE}groupmode") for layer in inner.values()} == {"layer"}
