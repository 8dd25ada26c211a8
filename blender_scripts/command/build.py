# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the native module, the native tests and the stand-alone core, out of source in the work folder."""

import os
import shutil
import sys
from pathlib import Path

from . import sanitizers
from .precompiled import forget_changed
from .target import PROJECT, YIELDING


def build(target, goal="_native", sanitize=False):
    """Builds a CMake target (`_native` or `fovea_tests`); returns the build folder. With sanitizers it yields to what
    runs beside it."""
    folder = target.work / ("sanitize" if sanitize else "release")
    with target.lock():
        kind = " with sanitizers" if sanitize else ""
        _configure(target, folder, f"the build{kind}", cmake_options(target, sanitize))
        _make(target, f"building {goal}{kind}", folder, "--target", goal, first=YIELDING if sanitize else [])
    return folder


def module(target):
    """Path of the Python module: the target's self-contained one, or one that is built."""
    if target.module:
        return Path(target.module)
    folder = build(target)
    found = sorted(folder.glob("_native*.so"))
    if len(found) != 1:
        raise FileNotFoundError(f"the build left {len(found)} modules in {folder}, not one")
    return found[0]


def preset(target, name, *goals):
    """Builds CMake targets, or all, with a preset, as users of the core without Blender do; returns the build folder.
    Objects shared with another build (`release` and the module, for example) come from ccache."""
    folder = target.work / f"preset-{name}"
    with target.lock():
        _configure(
            target, folder, f"the preset {name}", ["--preset", name, *_compiling(target, name in sanitizers.PRESETS)]
        )
        _make(target, f"building the preset {name}", folder, *(["--target", *goals] if goals else []))
    return folder


def _make(target, sentence, folder, *words, first=()):
    """first: words before the command."""
    forget_changed(folder)
    target.run(sentence, [*first, "cmake", "--build", folder, "-j", str(len(os.sched_getaffinity(0))), *words])


def _configure(target, folder, what, options):
    """Runs CMake's configure step only if options or presets changed; it reruns by itself when CMake files change."""
    source = _source(target)
    record = folder / "configured-with"
    wanted = "\n".join([*options, (PROJECT / "CMakePresets.json").read_text(encoding="utf-8")])
    if (folder / "build.ninja").exists() and record.exists() and record.read_text(encoding="utf-8") == wanted:
        return
    folder.mkdir(parents=True, exist_ok=True)
    target.run(f"configuring {what}", ["cmake", "--fresh", "-S", source, "-B", folder, *options])
    record.write_text(wanted, encoding="utf-8")


def _source(target):
    """A symlink to the checkout in the work folder; paths relative to it let ccache share objects between clones."""
    link = target.work / "source"
    if not link.is_symlink():
        link.symlink_to(PROJECT)
    return link


def cmake_options(target, sanitize):
    options = ["-G", "Ninja", f"-DPython_EXECUTABLE={sys.executable}", *_compiling(target, sanitize)]
    options.append(f"-DFOVEA_SANITIZE={sanitizers.names() if sanitize else ''}")
    options.append(f"-DFOVEA_TESTS={'ON' if target.is_suite else 'OFF'}")
    options.append("-DFOVEA_TOOL=OFF")
    if target.python_include:
        options.append(f"-DPython_INCLUDE_DIR={target.python_include}")
    return options


def _compiling(target, sanitize):
    options = ["-DCMAKE_COLOR_DIAGNOSTICS=OFF"]
    if sanitize and target.name in sanitizers.COMPILERS:
        options.append(f"-DCMAKE_CXX_COMPILER={sanitizers.COMPILERS[target.name]}")
    # Warnings are errors only with the fixed compiler of Debian stable; new warnings of other compilers must not break
    # the build.
    options.append(f"-DCMAKE_COMPILE_WARNING_AS_ERROR={'ON' if target.name == 'trixie' else 'OFF'}")
    if shutil.which("ccache"):
        options.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    return options
