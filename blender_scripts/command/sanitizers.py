# SPDX-License-Identifier: GPL-3.0-or-later
"""What programs with sanitizers are compiled with, and run in."""

import json
import os

from .target import PROJECT

THREAD_SUPPRESSIONS = PROJECT / "tests" / "native" / "thread_sanitizer.supp"
# Of suites, where it is not CMake's choice. Clang compiles in two thirds of the time, its sanitizers see more than
# GCC's, and what it makes is several times as fast. Without them GCC makes the faster core. run_tests.sh installs it.
COMPILERS = {"trixie": "clang++-19"}
PRESETS = "sanitize", "thread-sanitize"
SYMBOLIZER = "/usr/lib/llvm-19/bin"  # folder of Clang's, which names functions in reports


def names():
    """The sanitizers of the preset, as FOVEA_SANITIZE names them."""
    presets = json.loads((PROJECT / "CMakePresets.json").read_text(encoding="utf-8"))["configurePresets"]
    return next(each for each in presets if each["name"] == "sanitize")["cacheVariables"]["FOVEA_SANITIZE"]


def environment():
    return {
        "PATH": f"{os.environ['PATH']}:{SYMBOLIZER}",
        "UBSAN_OPTIONS": "print_stacktrace=1",
        "TSAN_OPTIONS": f"suppressions='{THREAD_SUPPRESSIONS}'",
    }
