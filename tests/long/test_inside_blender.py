# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests inside Blender that are left out where all are run: lines over renders of EEVEE, which compiles its shaders for
a minute on software OpenGL, benchmarks that start Blender several times, and more frames and operations in a row than
there."""

import os
import subprocess
import sys
from pathlib import Path

import frames
import pytest

TESTS = Path(__file__).parents[1]


@pytest.mark.parametrize(
    "chosen, count",
    [
        ("closed_form_has_the_outlines and EEVEE", 1),
        ("bench_peers or bench_focus or bench_scale or bench_coherence_leaves or bench_coherence_measures", 5),
        ("test_frames_alone and in_order_backwards_and_shuffled", 2),
    ],
)
def test_what_takes_long_inside_blender_passes(chosen, count):
    passes([frames.BLENDER, "-b", "-P", TESTS / "blender" / "run.py", "--", "-v", "-k", chosen], count)


def test_fifty_operations_in_a_window_undone_and_done_again():
    passes([sys.executable, "-m", "pytest", TESTS / "window" / "test_undo.py"], 1, FOVEA_BLENDER=frames.BLENDER)


def passes(words, count, **environment):
    """Asserts that so many tests pass, with nothing left out that takes long."""
    environment = os.environ | {"FOVEA_LONG": "1"} | environment
    told = subprocess.run(words, env=environment, capture_output=True, text=True, errors="replace")
    assert told.returncode == 0 and f"{count} passed" in told.stdout, told.stdout + told.stderr
