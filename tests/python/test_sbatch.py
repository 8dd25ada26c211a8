# SPDX-License-Identifier: GPL-3.0-or-later
"""The script for Slurm's arrays: what Blender is told in each task."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="Slurm's tasks run on Linux")

FARM = Path(__file__).parents[2] / "addon" / "farm"


def slurm(tmp_path, task, *words, **environment):
    """(exit status, words that Blender gets, its environment) of a task."""
    program = tmp_path / "blender"
    program.write_text('#!/bin/sh\nprintf "%s\\n" "$@" >"$0.words"\nenv >"$0.env"\n')
    program.chmod(0o755)
    given = os.environ | {"BLENDER": str(program), "SLURM_ARRAY_TASK_ID": str(task)} | environment
    done = subprocess.run(["bash", FARM / "fovea.sbatch", *words], env=given, capture_output=True, text=True)
    found = tmp_path / "blender.words"
    return done.returncode, found.read_text().splitlines() if found.exists() else None, tmp_path / "blender.env"


def test_a_task_of_slurm_renders_its_chunk(tmp_path):
    status, words, environment = slurm(tmp_path, 2, "a b.blend", "1", "25", "10", "/f/a_####", SLURM_CPUS_PER_TASK="4")
    chunk = ["--frame-start", "21", "--frame-end", "25", "--frame-jump", "1", "--render-anim"]
    assert status == 0 and words == ["-b", "a b.blend", "--threads", "4", "-o", "/f/a_####", *chunk]
    assert {"FOVEA_ATOMIC=1", "FOVEA_RESUME=1", "FOVEA_BACKEND=cpu"} <= set(environment.read_text().splitlines())


def test_a_task_of_slurm_beyond_the_animation_does_nothing(tmp_path):
    assert slurm(tmp_path, 3, "a.blend", "1", "25", "10")[:2] == (0, None)


def test_slurm_is_told_how_the_script_is_called(tmp_path):
    assert slurm(tmp_path, 0, "a.blend")[:2] == (2, None)
