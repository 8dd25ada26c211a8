# SPDX-License-Identifier: GPL-3.0-or-later
"""The linkers of modules. For macOS it is LLVM's, with the C++ runtime that zig has built: zig's own there knows no
list of exports, and has the system put other libraries' functions and tables of C++ in the place of the module's. For
Linux it is zig's, told to keep one of functions that have the same code, a twentieth of a module; on Windows' that word
has no effect."""

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


# Zig takes no such word, but says how it links. In its words paths are not quoted: one with a space stays as it is.
FOLDING = """#!/bin/sh
# zig {digest}
said=$(ZIG_VERBOSE_LINK=1 {compiler} "$@" 2>&1) || {{ printf '%s\\n' "$said" >&2; exit 1; }}
case $PWD{sources} in *" "*) exit 0 ;; esac
words=$(printf '%s\\n' "$said" | grep '^ld.lld ' | tail -n 1)
[ -n "$words" ] || {{ echo "zig did not say how it links: $said" >&2; exit 1; }}
exec {sources}/zig/zig $words --icf=safe
"""
PLATFORMS = ("linux-x64", "macos-arm64")  # of which modules are not linked as zig does


def option(target, sources, platform):
    """The option that tells CMake of the linker for a platform, which is made where it is not there yet."""
    make = _of_llvm if platform.system == "Darwin" else _folding
    return f"-DFOVEA_LINKER={make(target, sources, platform)}"


def _folding(target, sources, platform):
    folder = target.work / "compilers" / platform.name
    words = {"compiler": shlex.quote(str(folder / "c++")), "sources": shlex.quote(str(sources))}
    return _written(folder / "ld", FOLDING.format(digest=sources.name, **words))


def _of_llvm(target, sources, platform):
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
        _written(file, text)
    return file


def _written(file, text):
    """A program of this text, which is written where it is another one."""
    if not (file.exists() and file.read_text() == text):
        file.write_text(text)
        file.chmod(file.stat().st_mode | stat.S_IXUSR | stat.S_IXGRP | stat.S_IXOTH)
    return file


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
