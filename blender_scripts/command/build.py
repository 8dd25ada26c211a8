# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the native module and the native tests, out of the tree, in the work folder."""

import os
import shutil
import sys

from .target import PROJECT


def build(target, goal="_native", sanitize=False):
    """Builds a CMake target (`_native` or `fovea_tests`); returns the build folder."""
    folder = target.work / ("sanitize" if sanitize else "release")
    with target.lock():
        _configure(target, folder, sanitize)
        kind = " with sanitizers" if sanitize else ""
        jobs = str(len(os.sched_getaffinity(0)))
        target.run(f"building {goal}{kind}", ["cmake", "--build", folder, "--target", goal, "-j", jobs])
    return folder


def module(target):
    """The built Python module."""
    folder = build(target)
    found = sorted(folder.glob("_native*.so"))
    if len(found) != 1:
        raise FileNotFoundError(f"the build left {len(found)} modules in {folder}, not one")
    return found[0]


def _configure(target, folder, sanitize):
    """CMake configures again by itself when its files change, so this runs only when the options do."""
    link = target.work / "source"
    if not link.is_symlink():
        link.symlink_to(PROJECT)
    options = _options(target, sanitize)
    record = folder / "configured-with"
    if (folder / "build.ninja").exists() and record.exists() and record.read_text() == "\n".join(options):
        return
    folder.mkdir(parents=True, exist_ok=True)
    kind = " with sanitizers" if sanitize else ""
    target.run(f"configuring the build{kind}", ["cmake", "-S", link, "-B", folder, *options])
    record.write_text("\n".join(options))


def _options(target, sanitize):
    options = ["-G", "Ninja", f"-DPython_EXECUTABLE={sys.executable}", "-DCMAKE_COLOR_DIAGNOSTICS=OFF"]
    options.append(f"-DFOVEA_SANITIZE={'ON' if sanitize else 'OFF'}")
    options.append(f"-DFOVEA_TESTS={'ON' if target.is_suite else 'OFF'}")
    # A user's own compiler may warn of what nobody has seen: that must not keep Fovea from being built.
    options.append(f"-DCMAKE_COMPILE_WARNING_AS_ERROR={'ON' if target.is_suite else 'OFF'}")
    if target.python_include:
        options.append(f"-DPython_INCLUDE_DIR={target.python_include}")
    if shutil.which("ccache"):
        options.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    return options
