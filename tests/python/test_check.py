# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea check` reports violations with file names, and fixes those that can be fixed."""

import re
import shutil
import sys
from pathlib import Path

import pytest
from command import check, target

PROJECT = Path(__file__).parents[2]
# Suite: its tool, a file of the project that tells the tool what to do, a bad source, and what is said of it.
TOOLS = {
    "sid": ("ruff", ".ruff.toml", "addon/bad.py", "import os\nx = {  'a':1 }\n", "addon/bad.py:1:8: F401"),
    "trixie": ("clang-format-19", ".clang-format", "native/fovea/bad.cpp", "int  x;\n", "native/fovea/bad.cpp\n"),
}


@pytest.fixture
def suite(tmp_path, monkeypatch):
    """A function from a name to a target, in a project that is empty."""
    project = tmp_path / "project"
    (project / "tests" / "native").mkdir(parents=True)
    monkeypatch.setattr(check, "PROJECT", project)
    monkeypatch.chdir(project)
    return lambda name: target.Target(name, tmp_path / "work", tmp_path / "cache", "blender", "")


def says(*lines, status=1):
    """A command that prints these lines."""
    return [sys.executable, "-c", f"print({chr(10).join(lines)!r}); raise SystemExit({status})"]


def test_what_is_wrong_in_a_file_is_said_once(suite, capfd):
    places = [f"{check.PROJECT}/native/a.h:3:1: error: late", "native/b.h:1:2: note: why", "3 warnings generated."]
    found = check.Check("lint", says(places[0], *places), check.PLACE)
    assert not check.holds(suite("sid"), found, fix=False)
    told = capfd.readouterr().err
    assert told.count("    native/a.h:3:1: error: late\n") == 1 and "b.h" not in told and "warnings" not in told


def test_files_that_are_written_otherwise_are_named_with_the_command_that_mends_them(suite, capfd):
    lines = ["a.py:3:1: error: one", "a.py:7:1: error: two", "b.py:7:1: error: three"]
    found = check.Check("format", says(*lines), check.PLACE, files_alone=True, fix=["true"])
    assert not check.holds(suite("sid"), found, fix=False)
    told = capfd.readouterr().err
    assert "    a.py\n    b.py\n" in told and "blender_scripts/fovea check --fix" in told


def test_what_ends_without_naming_a_file_shows_the_end_of_its_output(suite, capfd):
    assert not check.holds(suite("sid"), check.Check("rules", says("one", "two")), fix=False)
    assert "    one\n    two\n" in capfd.readouterr().err


def test_all_checks_are_made_although_the_first_fails(suite, monkeypatch, capfd):
    checks = [
        check.Check(name, says(name, status=status)) for name, status in (("first", 1), ("second", 0), ("third", 2))
    ]
    monkeypatch.setattr(check, "of_python", lambda: checks)
    assert check.check(suite("sid"), ["--tidy"]) == 1
    assert re.findall(r"the (\w+) FAILED", capfd.readouterr().err) == ["first", "third"]


@pytest.mark.parametrize("name", TOOLS)
def test_a_bad_source_is_found_and_mended(suite, monkeypatch, capfd, name):
    tool, settings, file, text, said = TOOLS[name]
    if not shutil.which(tool):
        pytest.skip(f"{tool} is installed by `fovea check`, in Debian {name} alone")
    monkeypatch.setattr(check, "RULES", ("--version",))
    shutil.copy(PROJECT / settings, check.PROJECT)
    bad = check.PROJECT / file
    bad.parent.mkdir(parents=True)
    bad.write_text(text)
    assert check.check(suite(name), []) == 1
    told = capfd.readouterr().err
    assert f"    {said}" in told and told.count(f"    {file}\n") == 1 and bad.read_text() == text
    assert check.check(suite(name), ["--fix"]) == 0 and bad.read_text() != text
    assert check.check(suite(name), []) == 0


def test_clang_tidy_looks_at_the_files_that_are_named_and_at_those_in_folders(suite, tmp_path):
    for file in ("native/fovea/a.h", "native/fovea/b.cpp", "native/fovea/exports.map", "tests/native/c.cpp"):
        (check.PROJECT / file).parent.mkdir(parents=True, exist_ok=True)
        (check.PROJECT / file).touch()
    found = check.cpp_files(["native", "tests/native/c.cpp", "native/fovea/exports.map"])
    assert [str(file) for file in found] == ["native/fovea/a.h", "native/fovea/b.cpp", "tests/native/c.cpp"]
    commands = [each.command for each in check.of_cpp(tmp_path / "work", found)]
    assert len(commands) == 2 and Path(commands[1][2]).read_text().split() == [str(file) for file in found]
    assert len(check.of_cpp(tmp_path / "work", [])) == 1
