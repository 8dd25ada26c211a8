# SPDX-License-Identifier: GPL-3.0-or-later
"""Where what a command prints cannot be written, it says so in one sentence and fails."""

import subprocess
import sys
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).parents[2] / "blender_scripts"
WORK = """
import sys
sys.path.insert(0, sys.argv[1])
from command import actions, main, target
def work(target, words):
    print({printed})
    {then}
actions.work = work
sys.exit(main.main(["test", sys.argv[2], sys.argv[2], "blender", "", "", "work"]))
"""
LOST = "fovea: work: what it prints could not be written (No space left on device): make room, or send it elsewhere\n"


def run(folder, to, printed="'a.png'", then="return 0"):
    """(exit status, what was said) of a command whose output goes to a file."""
    script = WORK.format(printed=printed, then=then)
    with open(to, "w") as out:
        done = subprocess.run([sys.executable, "-c", script, SCRIPTS, folder], stdout=out, stderr=subprocess.PIPE)
    return done.returncode, done.stderr.decode()


full = pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")


@full
@pytest.mark.parametrize("printed", ["'a.png'", "'a.png' * 100_000"])
def test_a_full_disk_is_said_in_one_sentence(tmp_path, printed):
    assert run(tmp_path, "/dev/full", printed) == (1, LOST)


@full
@pytest.mark.parametrize("error", ["ValueError('no such thing')", "OSError(2, 'No such file', 'a.obj')"])
def test_what_failed_before_is_said_alone(tmp_path, error):
    status, said = run(tmp_path, "/dev/full", then=f"raise {error}")
    assert status == 1 and said.startswith("fovea: work: ") and "no such" in said.lower() and said.count("\n") == 1


def test_what_is_printed_is_written(tmp_path):
    out = tmp_path / "out"
    assert run(tmp_path, out) == (0, "") and out.read_text() == "a.png\n"


def test_the_status_of_a_command_is_its_own(tmp_path):
    assert run(tmp_path, tmp_path / "out", then="return 3") == (3, "")
