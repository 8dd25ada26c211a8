# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea render` that is killed at random moments and resumed renders the frames of an undisturbed run."""

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import frames

MAIN = Path(__file__).parents[2] / "blender_scripts" / "command" / "main.py"
KILLS = 50


def started(file, out):
    words = ["render", file, "--frames", f"1-{frames.FRAMES}", "-o", out / "box_####", "--resume"]
    return subprocess.Popen([sys.executable, "-B", MAIN, *frames.TARGET, *words], start_new_session=True)


def test_all_frames_equal_those_of_an_undisturbed_run(tmp_path):
    file, out, rng = frames.saved(tmp_path), tmp_path / "out", random.Random(1)
    whole, start = tmp_path / "whole", time.monotonic()
    assert started(file, whole).wait() == 0
    longest = time.monotonic() - start  # of a run: it is killed at any moment of it
    for number in range(KILLS):
        run = started(file, out)
        try:
            run.wait(rng.uniform(0.0, longest))
        except subprocess.TimeoutExpired:
            os.killpg(run.pid, signal.SIGKILL)
            run.wait()
        pictures = sorted(out.glob("*.png"))
        print(f"{number}: {len(pictures)} frames")
        if len(pictures) == frames.FRAMES:  # once more from the middle on
            for picture in pictures[frames.FRAMES // 2 :]:
                picture.unlink()
    assert started(file, out).wait() == 0
    assert frames.same(out, whole)
    assert sorted(path.name for path in (out / ".fovea").iterdir()) == [".lock", "frames.jsonl"]
