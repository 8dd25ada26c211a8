# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea test --long`: what takes longer than all other tests runs only on demand."""

import re
import subprocess
from pathlib import Path

import pytest
from command import sanitizers, test
from command.standalone import wine
from command.target import StepFailed

HERE = Path(test.__file__).parent
NATIVE = Path(__file__).parents[1] / "native"

# Arguments: the folder of the scripts, what tests of threads count, the status of clang-tidy, what --on says, words.
SCRIPT = """
here=$1 counted=$2 tidy=$3 on=$4 BLENDER= cache=/none all_suites="sid trixie"
shift 4
for part in say target run_tests check; do . "$here/$part.sh"; done
use_suite() { target_name=$1; }
set_up_suite() { echo "set up $*"; }
counts_file() { echo "$counted"; }
work_folder() { echo /none; }
make_modules() { echo "modules $*"; }
test_target() { echo "test $target_name $3"; }
cp "$counted" "$counted.kept"
run_command() { echo "command $target_name $*"; }
run_child() { cp "$counted.kept" "$counted" && echo "run ${3##*/} $5"; }
check_on() { echo "check $*"; return "$tidy"; }
test_targets "$@"
"""

# As above, for a run of all parts; the suite BROKEN cannot be set up.
SUITES = """
here=$1 on= BLENDER= cache=/none all_suites="sid trixie"
for part in say target run_tests; do . "$here/$part.sh"; done
use_suite() { [ "$1" != "BROKEN" ] && target_name=$1; }
counts_file() { echo /none; }
work_folder() { echo /none; }
test_target() { echo "$target_name without $1, $2 at once"; }
test_targets || true
"""


@pytest.fixture
def long(tmp_path):
    """long(counts, status of clang-tidy, words, --on): exit status, what is done line by line, what is said."""

    def run(counts="5 0 0", tidy=0, words=("--long",), on=""):
        counted = tmp_path / "counts"
        counted.write_text(f"{counts}\n")
        command = ["/bin/sh", "-eu", "-c", SCRIPT, "sh", HERE, counted, str(tidy), on, *words]
        done = subprocess.run(command, capture_output=True, text=True)
        return done.returncode, done.stdout.splitlines(), done.stderr

    return run


def test_all_that_takes_long_is_run_and_counted(long):
    ran = ["modules linux-x64-cp313 linux-x64-cp314", "test trixie native", "test trixie long_sanitize"]
    ran += ["test sid standalone", "test trixie standalone", "test trixie threads"]
    ran += ["set up trixie slurm-wlm munge nodejs", "test trixie kills", "run main.py --wine"]
    ran += ["set up trixie clang-19 libclang-rt-19-dev llvm-19", "command trixie fuzz --minutes 10"]
    ran += ["check trixie --tidy native tests/native"]
    assert long() == (0, [*ran, "37 passed, 0 failed, 0 skipped"], "")
    assert long(tidy=1) == (1, [*ran, "36 passed, 1 failed, 0 skipped"], "")
    assert long(counts="4 1 0") == (1, [*ran, "30 passed, 7 failed, 0 skipped"], "")


def test_what_is_built_for_windows_runs_alone_and_without_a_suite(long):
    assert long(words=("windows", "-k", "torus")) == (0, ["run main.py --wine", "5 passed, 0 failed, 0 skipped"], "")
    assert "takes no --on" in long(words=("windows",), on="sid")[2]


def test_without_wine_a_sentence_says_how_to_get_it(monkeypatch):
    monkeypatch.setenv("PATH", "")
    with pytest.raises(StepFailed, match=r"wine is missing, .* \(apt-get install wine wine64\)"):
        wine.program()


def test_other_words_beside_it_are_refused(long):
    status, done, said = long(words=("--long", "native"))
    assert status == 1 and done == [] and "test --long takes no other words, and not 'native'" in said
    assert "takes no --on" in long(on="sid")[2]


@pytest.mark.parametrize("without", ["sanitize", "native", "none"])
def test_a_run_of_all_parts_leaves_them_out(without):
    words = ["--without", without, "--jobs", "2"]
    parts, jobs, _ = test.parse(words)
    assert jobs == 2 and set(test.PARTS) - set(parts) == {*test.LONG, without} - {"none"}
    assert test.parse([*words, "threads"])[0] == ["threads"] and test.parse([*words, "native"])[0] == ["native"]


@pytest.mark.parametrize("broken", ["", "sid", "trixie"])
def test_native_tests_run_as_they_are_and_under_sanitizers_whichever_suite_is_there(broken):
    script = SUITES.replace("BROKEN", broken)
    done = subprocess.run(["/bin/sh", "-eu", "-c", script, "sh", HERE], capture_output=True, text=True)
    both = ["sid without sanitize, 1 at once", "trixie without native, 2 at once"]
    there = [f"{suite} without none, 2 at once" for suite in ("sid", "trixie") if suite != broken]
    assert sorted(done.stdout.splitlines()[:-1]) == (there if broken else both), done.stderr


def test_what_takes_long_with_sanitizers_is_a_test_that_is_there():
    sources = "".join(file.read_text(encoding="utf-8") for file in NATIVE.glob("test_*.cpp"))
    names = test.long_with_sanitizers()
    assert len(names) > 20
    for name in names:
        suite, case = re.sub(r"^(Registry|All)/", "", name).split("/")[0].split(".")
        assert re.search(rf"TEST(_P|_F)?\({suite}, {case}\)", sources), name


def test_every_line_that_keeps_the_thread_sanitizer_quiet_has_its_reason():
    above = ""
    for line in sanitizers.THREAD_SUPPRESSIONS.read_text(encoding="utf-8").splitlines():
        assert not line or line.startswith("#") or above, line
        above = line
