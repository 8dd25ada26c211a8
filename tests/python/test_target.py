# SPDX-License-Identifier: GPL-3.0-or-later
"""Which Blender a command uses where suites cannot be set up: tests the shell functions with a simulated setup."""

import subprocess
from pathlib import Path

import pytest

HERE = Path(__file__).parents[2] / "blender_scripts" / "command"

# Arguments: the folder of the scripts, the suites that cannot be set up, the user's number, what --on says.
SCRIPT = """
here=$1 broken=$2 user=$3 cache=/nowhere
for part in say own_blender target; do . "$here/$part.sh"; done
set_up_suite() {
    echo "setting up $1"
    case " $broken " in *" $1 "*) say "$1 is broken" && return 1 ;; esac
}
id() { echo "$user"; }
choose_target "$4" && echo "on $target_name"
"""


@pytest.fixture
def choose(tmp_path):
    """choose(broken suites, --on, user): what is done, line by line, and what is said. There is no Blender on PATH."""

    def run(broken="", on="", user="0"):
        done = subprocess.run(
            ["/bin/sh", "-eu", "-c", SCRIPT, "sh", HERE, broken, user, on],
            env={"PATH": str(tmp_path)}, capture_output=True, text=True,
        )  # fmt: skip
        return done.stdout.splitlines(), done.stderr

    return run


def test_sid_is_what_runs_where_nothing_is_said(choose):
    assert choose() == (["setting up sid", "on sid"], "")


def test_trixie_runs_where_sid_cannot_be_installed_and_a_sentence_says_so(choose):
    done, said = choose("sid")
    assert done == ["setting up sid", "setting up trixie", "on trixie"]
    assert said.splitlines()[0] == "fovea: sid is broken"
    assert "going on with Debian trixie" in said and "--on sid tries it again" in said


def test_a_suite_that_is_named_is_not_replaced_by_another(choose):
    assert choose("sid", on="sid") == (["setting up sid"], "fovea: sid is broken\n")


def test_nothing_runs_where_neither_can_be_installed(choose):
    done, said = choose("sid trixie")
    assert done == ["setting up sid", "setting up trixie"] and said.endswith("fovea: trixie is broken\n")


def test_who_may_not_set_up_suites_is_told_once(choose):
    assert choose("sid", user="1000") == (["setting up sid"], "fovea: sid is broken\n")
