# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios in a Blender with a window: `play` runs one."""

import os
import re
import shutil
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent
sys.path += [str(HERE.parents[1] / "blender_scripts"), str(HERE.parent / "blender")]

import window

COMPLAINT = re.compile(r"Traceback|^\s*\w*(Error|Exception)\b|: error:|failed|SIGSEGV|Segmentation")
SIZE = (960, 600)


@pytest.fixture
def play(request, tmp_path):
    """A function from the name of a scenario to what it returned; the console must be free of complaints. The scenarios
    of test_THIS.py are in THIS_scenarios.py, unless another file is named."""
    if not shutil.which("xvfb-run"):
        pytest.skip("there is no xvfb-run here to make a screen")

    own = request.path.name.removeprefix("test_").replace(".py", "_scenarios.py")

    def run(scenario, file=own, size=SIZE, **options):
        blender = os.environ["FOVEA_BLENDER"]
        played = window.play(blender, dict(os.environ), HERE / file, scenario, tmp_path, size=size, **options)
        complaints = [line for line in played.console.splitlines() if COMPLAINT.search(line)]
        assert not complaints, played.console
        return played.result

    return run
