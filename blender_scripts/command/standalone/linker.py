# SPDX-License-Identifier: GPL-3.0-or-later
"""The linker of macOS modules: LLVM's, with the C++ runtime that zig has built. Zig's own for macOS knows no list of
exports, and has the system put other libraries' functions and tables of C++ in the place of the module's."""

import re
import shlex
import shutil
import stat
import subprocess

from ..target import StepFailed

PROGRAMS, OLDEST = ("ld64.lld-19", "ld64.lld"), 19
RUNTIME = ("libc++abi.a", "libc++.a", "libcompiler_rt.a")
WRAPPER = """#!/bin/sh
# zig {digest}, {version}
exec {words} "$@" {libraries}
"""


def option(target, sources, platform):
    """The option that tells CMake of the linker for a platform, which is made where it is not there yet."""
    program, version = installed()
    folder = target.work / "compilers" / platform.name
    runtime = [folder / "runtime" / name for name in RUNTIME]
    system = platform.triple.partition("macos.")[2]
    words = [program, "-arch", platform.processor, "-platform_version", "macos", system, system, "-adhoc_codesign"]
    libraries = [*runtime, sources / "zig_lib" / "libc" / "darwin" / "libSystem.tbd"]
    text = WRAPPER.format(digest=sources.name, version=version, words=_quoted(words), libraries=_quoted(libraries))
    file = folder / "ld"
    if not (file.exists() and file.read_text() == text and all(library.exists() for library in runtime)):
        _copy_runtime(target, folder, runtime)
        file.write_text(text)
        file.chmod(file.stat().st_mode | stat.S_IXUSR | stat.S_IXGRP | stat.S_IXOTH)
    return f"-DFOVEA_LINKER={file}"


def installed():
    """(program, what it says of its version)."""
    for program in filter(None, map(shutil.which, PROGRAMS)):
        said = subprocess.run([program, "--version"], capture_output=True, text=True, check=False).stdout.strip()
        if (number := re.search(r"LLD (\d+)", said)) and int(number[1]) >= OLDEST:
            return program, number.string.partition("\n")[0]
    raise StepFailed(
        f"ld64.lld of LLVM {OLDEST} or later is missing, with which modules for macOS are linked: install it "
        f"(apt-get install lld-{OLDEST})"
    )


def _copy_runtime(target, folder, places):
    """Has zig build the C++ runtime, by linking a library of nothing, and copies its archives."""
    trial = folder / "runtime" / "trial.cpp"
    trial.parent.mkdir(parents=True, exist_ok=True)
    trial.write_text("")
    words = [folder / "c++", "--verbose", "-shared", trial, "-o", trial.with_suffix(".so")]
    log = target.run(f"building the C++ runtime for {folder.name}", words)
    found = archives(log.read_text(encoding="utf-8", errors="replace"), target.cache / "zig")
    for place in places:
        if place.name not in found:
            raise StepFailed(f"zig did not say where its {place.name} is: see {log}")
        shutil.copyfile(found[place.name], place)


def archives(said, cache):
    """Name -> path of zig's archives, of what it says with --verbose; cache: its folder."""
    paths = re.findall(rf"{re.escape(str(cache))}/o/\w+/lib[\w+]+\.a", said)
    return {path.rpartition("/")[2]: path for path in paths}


def _quoted(words):
    return " ".join(shlex.quote(str(word)) for word in words)
