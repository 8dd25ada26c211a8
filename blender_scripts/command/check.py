# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea check`: format, lint and rules of the sources, without building them; each suite runs the checks whose tools
it has."""

import argparse
import os
import re
import sys
import sysconfig
from dataclasses import dataclass
from pathlib import Path

from .target import PROJECT, say, tail

CPP = ("native", "tests")  # folders of all C++ files
RULES = [f"tests/python/test_{what}.py" for what in ("layering", "licenses", "shaders")]  # they only read the sources
# A finding in the format of compilers and ruff: FILE:LINE:COLUMN: MESSAGE.
PLACE = re.compile(r"(?P<file>[^\s:]+):\d+:\d+: (?!note: ).+")


@dataclass(frozen=True)
class Check:
    """A command that returns 0 if it finds nothing; it is run in the project's folder."""

    name: str
    command: list
    finding: re.Pattern | None = None  # matches lines of its output that report a file; None: show the output's end
    files_alone: bool = False  # show only the names of the files
    fix: list | None = None  # the command that fixes its findings


def check(target, words):
    """words: [--fix] [--tidy FILE|FOLDER...], the inputs of clang-tidy."""
    parser = argparse.ArgumentParser("fovea check")
    parser.add_argument("--fix", action="store_true")
    parser.add_argument("--tidy", nargs="*", default=[])
    options = parser.parse_args(words)
    os.chdir(PROJECT)
    checks = of_python() if target.name == "sid" else of_cpp(target.work / "check", cpp_files(options.tidy))
    # Runs all checks, even after one has failed.
    return 1 if [each for each in checks if not holds(target, each, options.fix)] else 0


def holds(target, check, fix):
    """Runs a check, after its fix if `fix`; prints its findings and returns whether there are none."""
    if fix and check.fix:
        target.attempt(f"mending the {check.name}", check.fix)
    log, status = target.attempt(check.name, check.command)
    if status == 0:
        return True
    lines = log.read_text(encoding="utf-8", errors="replace").replace(f"{PROJECT}/", "").splitlines()
    found = [match for line in lines if check.finding and (match := check.finding.match(line))]
    told = dict.fromkeys(match["file" if check.files_alone else 0] for match in found)  # unique, in order
    say(f"the {check.name} FAILED:\n" + ("\n".join(f"    {each}" for each in told) or tail(log, 25)))
    if check.fix and not fix:
        say(f"the same words and --fix (blender_scripts/fovea check --fix) mend what can be mended of the {check.name}")
    return False


def of_python():
    lint, form, concise = ["ruff", "check", "--no-cache"], ["ruff", "format", "--no-cache"], "--output-format=concise"
    rules = [sys.executable, "-m", "pytest", "-q", "--no-header", *RULES]
    return [
        Check("lint of Python", [*lint, concise], PLACE, fix=[*lint, "--fix"]),
        Check("format of Python", [*form, "--check", concise], PLACE, files_alone=True, fix=form),
        Check("rules of imports, includes, licenses and shaders", rules),
    ]


def of_cpp(folder, tidied):
    """The checks of C++. `folder`: for files that the tools read; `tidied`: inputs of clang-tidy, seconds per file."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "compile_flags.txt").write_text("\n".join(compile_flags()))
    form = [*in_shares(folder / "every", cpp_files(CPP), 32), "clang-format-19"]
    checks = [Check("format of C++", [*form, "--dry-run", "--Werror"], PLACE, files_alone=True, fix=[*form, "-i"])]
    if tidied:
        tidy = [*in_shares(folder / "tidied", tidied, 1), "clang-tidy-19", "--quiet", "-p", folder]
        checks.append(Check("lint of C++", tidy, PLACE, fix=[*tidy, "--fix"]))
    return checks


def compile_flags():
    """Compiler flags of the CMake build, without precompiled headers and unity builds, which clang-tidy cannot use."""
    includes = (PROJECT / "native", PROJECT / "shaders", PROJECT / "tests" / "native", sysconfig.get_path("include"))
    words = ["-xc++", "-std=c++20", "-Wall", "-Wextra", "-Wno-pragma-once-outside-header"]
    words += [f'-D{place}=""' for place in ("FOVEA_ADDON", "FOVEA_CORPUS")]  # of the sources, for tests
    return words + [f"-I{folder}" for folder in includes]


def in_shares(record, files, count):
    """The xargs prefix that runs a command on `count` files at a time, on all cores; `record`: file for their names."""
    record.write_text("".join(f"{file}\n" for file in files))
    return ["xargs", "-a", record, "-P", str(len(os.sched_getaffinity(0))), "-n", str(count)]


def cpp_files(places):
    """All C++ files among the given files and in the given folders."""
    inside = [sorted(Path(place).rglob("*")) if Path(place).is_dir() else [Path(place)] for place in places]
    return [file for files in inside for file in files if file.suffix in (".h", ".cpp")]
