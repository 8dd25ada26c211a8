# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of `fovea draw` that are killed at any moment leave whole pictures alone, and nothing in the cache."""

import os
import random
import signal
import subprocess
import sys
from pathlib import Path

import pytest

MAIN = Path(__file__).parents[2] / "blender_scripts" / "command" / "main.py"
TARGET = os.environ["FOVEA_TARGET"].split("\n")  # the words of main.py before the sub-command
WORK = Path(TARGET[1])
DRAW = ["draw", "boxes:3", "--size", "320x180", "--frames", "1-3", "-o"]
KILLS = 40


def started(folder):
    words = [sys.executable, "-B", MAIN, *TARGET, *DRAW, folder / "a.png"]
    return subprocess.Popen(words, stdout=subprocess.PIPE, text=True, start_new_session=True)


def folders():
    """Of temporary files, without that of the run that the tests are."""
    return {path for path in (WORK / "tmp").iterdir() if path.is_dir() and path != Path(os.environ["TMPDIR"])}


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_in_a_loop(tmp_path, number):
    whole = started(tmp_path)
    assert whole.communicate()[0].count("\n") == 3 and whole.returncode == 0
    size = (tmp_path / "a_0001.png").stat().st_size
    left, rng = folders(), random.Random(1)
    for _ in range(KILLS):
        run = started(tmp_path)
        try:
            run.wait(rng.uniform(0.0, 4.0))
        except subprocess.TimeoutExpired:
            os.killpg(run.pid, number)
        run.communicate()
        pictures = sorted(path for path in tmp_path.iterdir() if not path.name.startswith("."))
        assert [path.name for path in pictures] == ["a_0001.png", "a_0002.png", "a_0003.png"]
        assert pictures[0].stat().st_size > size // 2 and all(path.read_bytes()[-8:-4] == b"IEND" for path in pictures)
    assert started(tmp_path).wait() == 0
    assert folders() <= left
    assert number == signal.SIGKILL or len(list(tmp_path.iterdir())) == 3, "what it began goes with it"
