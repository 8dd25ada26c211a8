# SPDX-License-Identifier: GPL-3.0-or-later
"""The compiler for all systems: zig's (Clang, LLD, libc++, headers and import libraries of each system), by wrappers
that CMake takes for an ordinary compiler. Why this one: .github/CONTRIBUTING.md."""

import stat
from dataclasses import dataclass

PYTHONS = ("3.11", "3.13")  # of Blender 4.2 to 5.0, and of 5.1 and later
SUITES = {"3.14": "sid"}  # a Python that only a Debian suite's Blender has, whose headers are there: for tests


@dataclass(frozen=True)
class Platform:
    name: str  # as Blender's manifests name it
    triple: str  # as zig names it, with the oldest system that it is for
    system: str  # as CMake names it
    processor: str
    suffix: str  # end of a module's name, as this platform's Python wants it; {} is 311
    wheel: str  # platform tag of wheels
    license: str = ""  # of the parts of the C library that are linked: its file in zig_lib
    program: str = ""  # end of a program's name

    def module_name(self, python):
        return f"_native{self.suffix.format(python.replace('.', ''))}"

    @property
    def cmake_options(self):
        options = [f"-DCMAKE_SYSTEM_NAME={self.system}", f"-DCMAKE_SYSTEM_PROCESSOR={self.processor}"]
        if self.system == "Linux":  # native/standalone/wide_integers.cpp says why
            options += [f"-DCMAKE_{kind}_LINKER_FLAGS=-rtlib=none" for kind in ("EXE", "MODULE")]
        if self.system == "Darwin":
            # CMake wants the tool that changes names of installed libraries; nothing is installed.
            options += ["-DCMAKE_INSTALL_NAME_TOOL=:", "-DCMAKE_OSX_DEPLOYMENT_TARGET=", "-DCMAKE_OSX_SYSROOT="]
        return options


PLATFORMS = {
    platform.name: platform
    for platform in (
        Platform(
            "linux-x64", "x86_64-linux-gnu.2.28", "Linux", "x86_64", ".cpython-{}-x86_64-linux-gnu.so",
            "manylinux_2_28_x86_64", "libc/glibc/LICENSES",
        ),
        Platform(
            "windows-x64", "x86_64-windows-gnu", "Windows", "AMD64", ".cp{}-win_amd64.pyd", "win_amd64",
            "libc/mingw/COPYING", ".exe",
        ),
        Platform(
            "macos-arm64", "aarch64-macos.11.0", "Darwin", "arm64", ".cpython-{}-darwin.so", "macosx_11_0_arm64",
        ),
    )
}  # fmt: skip

WRAPPER = """#!/bin/sh
# zig {digest}
sources={sources}
export ZIG_LIB_DIR="$sources/zig_lib" ZIG_GLOBAL_CACHE_DIR={cache} ZIG_LOCAL_CACHE_DIR={cache}
exec "$sources/zig/zig" {words} "$@"
"""
# Zig checks undefined behavior, writes debugging data and keeps frame pointers unless told not to; what it says of
# missing annotations of headers is about its own.
COMPILING = "-target {triple} -fno-sanitize=undefined -g0 -fomit-frame-pointer -Wno-nullability-completeness"


def wrappers(folder, sources, cache, platform):
    """Writes the compilers and archivers for a platform; returns the options that tell CMake of them."""
    target = COMPILING.format(triple=platform.triple)
    words = {"c++": f"c++ {target}", "cc": f"cc {target}", "ar": "ar", "ranlib": "ranlib", "dlltool": "dlltool"}
    folder = folder / platform.name
    folder.mkdir(parents=True, exist_ok=True)
    for name, command in words.items():
        text = WRAPPER.format(digest=sources.name, sources=sources, cache=cache, words=command)
        file = folder / name
        if not file.exists() or file.read_text() != text:
            file.write_text(text)
            file.chmod(file.stat().st_mode | stat.S_IXUSR | stat.S_IXGRP | stat.S_IXOTH)
    tools = {"CXX_COMPILER": "c++", "C_COMPILER": "cc", "AR": "ar", "RANLIB": "ranlib"}
    return [f"-DCMAKE_{tool}={folder / name}" for tool, name in tools.items()]


def add_platforms(parser):
    parser.add_argument("--all", action="store_true", help="a zip for each platform of blender.org's Blenders")
    known = list(PLATFORMS)
    parser.add_argument("--for", action="append", dest="platforms", choices=known, help="as --all, for this platform")


def wanted_platforms(options):
    """Names of the platforms that the options of `add_platforms` ask for; none: no such option was given."""
    asked = options.platforms or []
    return list(PLATFORMS) if options.all else [each for each in PLATFORMS if each in asked]
