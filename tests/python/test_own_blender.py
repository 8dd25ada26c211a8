# SPDX-License-Identifier: GPL-3.0-or-later
"""With a Blender of the user's own, a self-contained module is taken where one fits: nothing is built, no suite is set
up. Most of these Blenders are made up: a script that runs this Python."""

import os
import subprocess
import sys

import pytest
from command import module_sources
from own_blenders import HERE, HERS, MODULES, PROJECT, placed, with_module

pytest_plugins = ("own_blenders",)

OFFICIAL = HERS.endswith(("cp311", "cp313"))  # whether official Blenders have this Python

# $1: the folder of the scripts; $2: what is missing to build a module; the rest: of choose_target.
SCRIPT = """
here=$1 parts=$2
shift 2
for part in say own_blender target; do . "$here/$part.sh"; done
set_up_suite() { echo "setting up $1"; }
missing_parts() { echo "$parts"; }
choose_target "$@" && echo "on ${target_name%-*}" && echo "module $module"
"""
pytestmark = with_module


@pytest.fixture
def choose(tmp_path):
    """choose(--on, what is missing to build a module, environment): what is chosen, line by line, and what is said."""

    def run(on="", missing="CMake (cmake)", **environment):
        command = ["/bin/sh", "-eu", "-c", SCRIPT, "sh", HERE, missing, on]
        environment = {"PATH": "/usr/bin:/bin", "cache": str(tmp_path / "cache")} | environment
        done = subprocess.run(command, env=environment, capture_output=True, text=True)
        return done.stdout.splitlines(), done.stderr

    return run


def test_the_module_that_fits_is_taken(choose, blender, fitting):
    assert choose(blender()) == (["on own-4.2.1", f"module {fitting}"], "")


@pytest.mark.parametrize("how", ["BLENDER=", "PATH"])
def test_no_suite_is_set_up_for_it(choose, blender, fitting, how):
    program = blender()
    named = {"BLENDER": str(program)} if how == "BLENDER=" else {"PATH": f"{program.parent}:/usr/bin:/bin"}
    assert choose(**named) == (["on own-4.2.1", f"module {fitting}"], "")


def test_it_is_taken_where_one_could_be_built(choose, blender, fitting):
    assert choose(blender(), missing="")[0][-1] == f"module {fitting}"


def test_where_none_fits_and_all_is_there_one_is_built(choose, blender, modules):
    assert choose(blender(), missing="") == (["on own-4.2.1", "module "], "")


def test_without_module_and_libraries_one_sentence_has_what_is_missing_and_both_remedies(choose, blender, modules):
    done, said = choose(blender())
    assert done == [] and said.count("\n") == 1
    assert f"no self-contained module for {blender()} (Blender 4.2.1, Python" in said and str(modules / HERS) in said
    assert "missing: CMake (cmake)" in said and ("take an official Blender" in said) == (not OFFICIAL)
    assert said.endswith(", or install what is missing\n")


@pytest.mark.parametrize("name", ["linux-x64-cp311", "macos-arm64-cp313"])
def test_a_module_that_official_blenders_take_is_named_with_the_command_that_makes_it(choose, blender, name):
    program = sys.executable
    answers = f"echo 'fovea python 3.11'; echo 'fovea program {program}'; echo 'fovea platform {name}'; exit 0"
    assert f"; make it with 'blender_scripts/fovea standalone {name}', or install" in choose(blender(ending=answers))[1]


def test_modules_for_another_python_are_not_tried(choose, blender, modules, fitting):
    (modules / HERS).rename(modules / "linux-x64-cp37")
    assert "there is no self-contained module" in choose(blender())[1]


def test_a_module_that_does_not_load_is_named_with_the_reason(choose, blender, modules):
    placed(b"not a library " * 99, modules)
    done, said = choose(blender())
    assert done == [] and said.count("\n") == 1
    assert f"{MODULES[0].name} cannot be used in" in said and ": invalid ELF header), and" in said
    assert "missing: CMake (cmake)" in said


@pytest.mark.parametrize("told", ["0123", None])
def test_a_module_of_other_sources_is_named_and_not_taken(choose, blender, fitting, told):
    record = module_sources.record(fitting)
    record.unlink() if told is None else record.write_text(told)
    done, said = choose(blender())
    assert done == [] and f"{fitting} cannot be used in" in said and "made of other sources than these), and" in said


def test_a_module_that_ends_blender_is_named(choose, blender, fitting):
    ends = f"echo 'fovea python 3.11'; echo 'fovea program {sys.executable}'; echo 'fovea tried {fitting}'; exit 11"
    done, said = choose(blender(ending=ends))
    assert done == [] and f"{fitting} cannot be used in" in said and "it ends Blender" in said


def test_a_blender_on_path_without_module_says_so_before_a_suite_is_set_up(choose, blender, modules):
    done, said = choose(PATH=f"{blender().parent}:/usr/bin:/bin")
    assert done == ["setting up sid", "on sid", "module "]
    assert "there is no self-contained module" in said and "using Fovea's own Blender" in said


@pytest.mark.parametrize("version, told", [("4.1.1", "is Blender 4.1.1, and Fovea needs"), ("x", "is no Blender, and")])
def test_another_program_is_not_asked_for_its_python(choose, blender, fitting, version, told):
    done, said = choose(blender(version, "echo asked >&2"))
    assert done == [] and told in said and "asked" not in said


def test_a_python_that_only_blender_sees_is_named(choose, blender, fitting):
    inside = f"echo 'fovea python 3.11'; echo 'fovea program /app/python3'; echo 'fovea module {fitting}'; exit 0"
    done, said = choose(blender(ending=inside))
    assert done == [] and "/app/python3, which is no program of this machine" in said


NEVER = ("cmake", "ninja", "g++", "c++", "debootstrap", "bwrap", "apt-get", "sudo")


@pytest.mark.skipif("FOVEA_BLENDER" not in os.environ, reason="FOVEA_BLENDER names no Blender")
def test_a_whole_blender_draws_with_it_as_no_root_and_nothing_is_built(tmp_path, modules, fitting):
    """The Blender of the suite, as one of the user's own in another folder; what would build or set up is made up."""
    stubs, picture, called = tmp_path / "stubs", tmp_path / "a picture.png", tmp_path / "called"
    stubs.mkdir()
    for name in NEVER:
        (stubs / name).write_text(f"#!/bin/sh\necho {name} >>'{called}'\nexit 1\n")
    (stubs / "id").write_text("#!/bin/sh\necho 1000\n")
    own = tmp_path / "own blender"
    own.write_text(f'#!/bin/sh\nexec {os.environ["FOVEA_BLENDER"]} "$@"\n')
    for program in (own, *stubs.iterdir()):
        program.chmod(0o755)
    done = subprocess.run(
        [PROJECT / "blender_scripts" / "fovea", "draw", "boxes:2", "--size", "96x54", "-o", picture],
        env={"PATH": f"{stubs}:/usr/bin:/bin", "HOME": str(tmp_path), "FOVEA_CACHE": str(tmp_path / "cache")}
        | {"BLENDER": str(own)},
        capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0 and done.stdout.strip() == str(picture), done.stderr
    assert picture.stat().st_size > 300 and not called.exists()
    made = {path.name for path in (tmp_path / "cache").iterdir()}
    assert {name.partition("-")[0] for name in made} == {"standalone", "own", "log"}
    assert not list((tmp_path / "cache").rglob("release"))
