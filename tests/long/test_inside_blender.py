# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests inside Blender that are left out where all are run: lines over renders of EEVEE, which compiles its shaders for
a minute on software OpenGL, and benchmarks that start Blender several times."""

import os
import subprocess
from pathlib import Path

import frames
import pytest

RUN = Path(__file__).parents[1] / "blender" / "run.py"


@pytest.mark.parametrize(
    "chosen, count", [("closed_form_has_the_outlines and EEVEE", 1), ("bench_peers or bench_focus or bench_scale", 3)]
)
def test_what_takes_long_inside_blender_passes(chosen, count):
    words = [frames.BLENDER, "-b", "-P", RUN, "--", "-v", "-k", chosen]
    told = subprocess.run(words, env=os.environ | {"FOVEA_LONG": "1"}, capture_output=True, text=True, errors="replace")
    assert told.returncode == 0 and f"{count} passed" in told.stdout, told.stdout + told.stderr
