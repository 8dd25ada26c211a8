# SPDX-License-Identifier: GPL-3.0-or-later
"""An interrupted command says so in a sentence and exits with 130, whether the terminal or a program interrupts it."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parents[2] / "blender_scripts" / "command"

# Arguments: the folder of the scripts, then a command. The traps are those of `fovea`.
SCRIPT = """
here=$1
shift
for part in say target; do . "$here/$part.sh"; done
eval "$(grep '^trap' "$here/../fovea")"
run_child "$@"
"""
WORK = """
import os, subprocess, sys
from pathlib import Path
sys.path.insert(0, sys.argv[1])
from command import actions, main
def work(target, words):
    target.attempt("working", [sys.executable, "-c", "import time; print(1, flush=True); time.sleep(600)"])
actions.work = work
print("begun", flush=True)
sys.exit(main.main(["test", sys.argv[2], sys.argv[2], "blender", "", "", "work"]))
"""


STARTING = """
import signal
class Popen(subprocess.Popen):
    def __init__(self, *words, **options):
        super().__init__(*words, **options)
        os.kill(os.getpid(), signal.SIGTERM)
subprocess.Popen = Popen
"""


def begun(tmp_path, before=""):
    script = WORK.replace("actions.work", before + "actions.work", 1)
    words = ["/bin/sh", "-eu", "-c", SCRIPT, "sh", HERE, sys.executable, "-c", script, HERE.parent, tmp_path]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    run = subprocess.Popen(words, text=True, start_new_session=True, **pipes)
    assert run.stdout.readline() == "begun\n"
    assert run.stderr.readline() == "fovea: test: working\n"
    return run


@pytest.mark.parametrize("tell", [os.kill, os.killpg])
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_it_is_said_once_and_nothing_is_left(tmp_path, tell, number):
    run = begun(tmp_path)
    tell(run.pid, number)
    out, said = run.communicate()
    assert (run.returncode, out, said) == (130, "", "fovea: interrupted\n")
    assert [path.name for path in (tmp_path / "tmp").iterdir()] == [".lock"]
    with pytest.raises(ProcessLookupError):
        os.killpg(run.pid, 0)  # no process of it is left


def test_what_is_being_started_as_the_interrupt_comes_is_ended_too(tmp_path):
    run = begun(tmp_path, STARTING)
    _out, said = run.communicate()
    assert (run.returncode, said) == (130, "fovea: interrupted\n")
    with pytest.raises(ProcessLookupError):
        os.killpg(run.pid, 0)
