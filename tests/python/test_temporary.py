# SPDX-License-Identifier: GPL-3.0-or-later
"""Temporary files go with their run; those of killed runs with the next one."""

import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
from command import temporary

RUN = """
import os, subprocess, sys, tempfile
from pathlib import Path
sys.path.insert(0, sys.argv[1])
from command import temporary
with temporary.folder(Path(sys.argv[2])) as held:
    Path(tempfile.mkdtemp(), "left").touch()
    if sys.argv[3] == "child":
        subprocess.Popen(["sleep", "600"], pass_fds=(held,), stdout=subprocess.DEVNULL)
    print(os.environ["TMPDIR"], flush=True)
    sys.stdin.read()
"""


@pytest.fixture(autouse=True)
def own_settings(monkeypatch):
    """Folders of the tests' own process as they were."""
    monkeypatch.setenv("TMPDIR", os.environ.get("TMPDIR", "/tmp"))
    monkeypatch.setattr(tempfile, "tempdir", tempfile.tempdir)


class Run:
    """Another process that has a folder for its temporary files in `place`, and writes one there."""

    def __init__(self, place, how=""):
        words = [sys.executable, "-c", RUN, Path(temporary.__file__).parents[1], place, how]
        pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
        self.process = subprocess.Popen(words, text=True, start_new_session=True, **pipes)
        self.folder = Path(self.process.stdout.readline().strip())
        assert self.folder.parent == place and any(self.folder.rglob("left"))

    def kill(self, group=True):
        (os.killpg if group else os.kill)(self.process.pid, signal.SIGKILL)
        self.process.wait()


def folders(place):
    return [path for path in place.iterdir() if path.is_dir()]


def test_a_run_that_ends_takes_its_files_with_it(tmp_path):
    run = Run(tmp_path)
    run.process.communicate("")
    assert run.process.returncode == 0 and folders(tmp_path) == []


def test_what_killed_runs_left_goes_with_the_next_one_and_that_of_living_ones_stays(tmp_path):
    living = Run(tmp_path)
    for _ in range(3):
        killed = Run(tmp_path)
        killed.kill()
        assert sorted(folders(tmp_path)) == sorted([living.folder, killed.folder])
    with temporary.folder(tmp_path):
        own = Path(os.environ["TMPDIR"])
        assert Path(tempfile.gettempdir()) == own and sorted(folders(tmp_path)) == sorted([living.folder, own])
    assert folders(tmp_path) == [living.folder] and any(living.folder.rglob("left"))
    living.kill()


def test_a_child_that_outlives_its_run_keeps_the_files(tmp_path):
    run = Run(tmp_path, "child")
    run.kill(group=False)
    with temporary.folder(tmp_path):
        assert run.folder.exists()
    os.killpg(run.process.pid, signal.SIGKILL)


def test_reports_of_crashes_stay(tmp_path):
    (tmp_path / "blender.crash.txt").touch()
    (tmp_path / "of_an_earlier_version").mkdir()
    (tmp_path / "link").symlink_to(tmp_path.parent)
    with temporary.folder(tmp_path):
        own = Path(os.environ["TMPDIR"])
        (own / "cube.crash.txt").touch()
        (own / "tile.png").touch()
    assert sorted(tmp_path.rglob("*.*")) == sorted(
        [tmp_path / ".lock", tmp_path / "blender.crash.txt", own / "cube.crash.txt"]
    )
    assert not (tmp_path / "link").exists() and folders(tmp_path) == [own] and tmp_path.parent.exists()
