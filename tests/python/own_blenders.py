# SPDX-License-Identifier: GPL-3.0-or-later
"""Blenders of the user's own, made up: a script that runs this Python, for what asks a Blender what it is."""

import platform
import sys
from pathlib import Path

import pytest
from command import module_sources

import addon

PROJECT = Path(__file__).parents[2]
HERE = PROJECT / "blender_scripts" / "command"
HERS = f"linux-x64-cp{sys.version_info.major}{sys.version_info.minor}"  # folder of modules for this Python
MODULES = sorted(Path(addon.__file__).parent.glob("_native.*.so"))
BLENDER = """#!/bin/sh
[ "$1" != --version ] || { echo "Blender VERSION"; exit; }
for folder; do :; done
ENDING
exec PYTHON SCRIPT -- "$folder"
"""

with_module = pytest.mark.skipif(
    not MODULES or platform.machine() != "x86_64", reason="there is no native module for Linux on x64"
)


@pytest.fixture
def blender(tmp_path):
    """Makes a Blender up: its program. `ending`: shell words that stand before it answers."""

    def made(version="4.2.1", ending=""):
        program = tmp_path / "bin" / "blender"
        program.parent.mkdir(exist_ok=True)
        text = BLENDER.replace("VERSION", version).replace("ENDING", ending)
        program.write_text(text.replace("PYTHON", sys.executable).replace("SCRIPT", f"'{HERE}/ask_blender.py'"))
        program.chmod(0o755)
        return program

    return made


@pytest.fixture
def modules(tmp_path):
    return tmp_path / "cache" / "standalone" / "modules"


def placed(content, modules):
    """A module of this checkout's sources, where self-contained ones for this Python are."""
    module = modules / HERS / MODULES[0].name
    module.parent.mkdir(parents=True)
    module.write_bytes(content)
    module_sources.record(module).write_text(module_sources.digest())
    return module


@pytest.fixture
def fitting(modules):
    """A module that this Python loads, where self-contained ones are."""
    return placed(MODULES[0].read_bytes(), modules)
