# SPDX-License-Identifier: GPL-3.0-or-later
"""Each run of a command has a log of its own, also beside another run of the same words."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from command import actions, target

SCRIPTS = Path(__file__).parents[2] / "blender_scripts"
RUN = """
import sys
from pathlib import Path
sys.path.insert(0, sys.argv[1])
from command import actions, target
own = target.Target("test", Path(sys.argv[2]), Path(sys.argv[2]), sys.argv[3], "")
actions.in_blender(own, "drawing demo", "draw.py", sys.argv[4:])
"""
# Announces a file; with two pipes it says by one that it has, and waits for the other.
BLENDER = """#!/bin/sh
echo "fovea wrote: \\"$7\\""
[ -z "$8" ] || { echo >"$8"; cat "$9"; }
echo "fovea notes: $7 is drawn"
"""


@pytest.fixture
def run(tmp_path):
    """run(words of a script): another process that runs it in a Blender."""
    blender = tmp_path / "blender"
    blender.write_text(BLENDER)
    blender.chmod(0o755)

    def begin(*words):
        command = [sys.executable, "-c", RUN, SCRIPTS, tmp_path, blender, *words]
        return subprocess.Popen(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    return begin


def told(process):
    out, said = process.communicate()
    return out, said.replace("fovea: test: drawing demo\n", "")


def test_two_runs_of_the_same_words_at_once_tell_of_their_own_files_only(run, tmp_path):
    begun, ended = tmp_path / "begun", tmp_path / "ended"
    os.mkfifo(begun)
    os.mkfifo(ended)
    slow = run("slow.png", begun, ended)
    begun.read_text()
    assert told(run("quick.png")) == ("quick.png\n", "fovea: quick.png is drawn\n")
    ended.write_text("")
    assert told(slow) == ("slow.png\n", "fovea: slow.png is drawn\n")


def test_runs_one_after_the_other_leave_one_log(run, tmp_path):
    for name in ("a.png", "b.png"):
        assert told(run(name)) == (f"{name}\n", f"fovea: {name} is drawn\n")
    assert [log.name for log in (tmp_path / "log").iterdir()] == ["drawing-demo.log"]


@pytest.mark.parametrize("scene", ["/far/" * 60, "\u00fc" * 200, "a\n\udc80"], ids=["deep", "long", "odd"])
def test_the_log_of_a_scene_of_any_name_can_be_read_after_it_failed(tmp_path, scene):
    own = target.Target("test", tmp_path, tmp_path, "/bin/false", "")
    with pytest.raises(target.StepFailed) as failure:
        actions.in_blender(own, f"drawing {scene}", "draw.py", [])
    log = Path(re.search("the last lines of (.*):", str(failure.value))[1])
    assert log.read_text() == "" and log.parent == tmp_path / "log" and log.name.startswith("drawing-")


def test_a_step_that_is_repeated_in_a_run_begins_its_log_anew(tmp_path):
    own = target.Target("test", tmp_path, tmp_path, "", "")
    for word in ("one", "two"):
        log = own.run("working", ["echo", word])
        assert log == tmp_path / "log" / "working.log" and log.read_text() == f"{word}\n"


@pytest.mark.parametrize("asked", [["words"], {"draw": "words"}])
def test_what_a_script_writes_is_in_the_temporary_folder_of_the_run(asked, monkeypatch, tmp_path):
    def in_blender(_target, _sentence, script, words):
        out = json.loads(words[0])["out"] if isinstance(asked, dict) else words[0]
        assert Path(out).parent == tmp_path and script.name == "fit.py"
        assert json.loads(words[0])["draw"] == "words" if isinstance(asked, dict) else words[1:] == asked
        Path(out).write_text("[1]")

    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr(actions, "in_blender", in_blender)
    monkeypatch.setattr(actions.extension, "install", lambda _target: None)
    assert actions.written_by(None, "fitting", "fit.py", asked) == "[1]"
