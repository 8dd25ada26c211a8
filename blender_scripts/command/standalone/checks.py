# SPDX-License-Identifier: GPL-3.0-or-later
"""What a self-contained module may take from the system, and hand out: its rules, platform by platform."""

import re

from . import interface

GLIBC = (2, 28)  # the oldest that Blender itself runs with
ENTRY = "PyInit__native"
LINUX = {f"lib{name}" for name in ("c.so.6", "m.so.6", "pthread.so.0", "dl.so.2", "rt.so.1")} | {"ld-linux-x86-64.so.2"}
# The C library has them for each processor; a compiler's own are slower (native/standalone/wide_integers.cpp).
FAST = ("memcpy", "memmove", "memset")
MACOS = {"/usr/lib/libSystem.B.dylib"}
MACOS_SYSTEM = (11, 0)
# Parts of every Windows 10, in lower case: its kernel, and the C runtime that is part of it.
WINDOWS = re.compile(r"(kernel32|ntdll|advapi32|api-ms-win-crt-[a-z0-9-]+|api-ms-win-core-[a-z0-9-]+)\.dll")
PYTHON = re.compile(r"_?Py[A-Z_]\w*")
# Weak references that compilers add to every library; a program that has none of them is as good.
ADDED = {"__gmon_start__", "_ITM_deregisterTMCloneTable", "_ITM_registerTMCloneTable", "__cxa_finalize"}


def problems(file, platform, python, names=None):
    """Sentences on what is wrong with a module for a platform and a Python; `names`: those that this Python has."""
    try:
        module = interface.read(file)
    except (interface.Unreadable, ValueError, IndexError) as error:
        return [f"it cannot be read: {error}"]
    own = {"linux-x64": _linux, "windows-x64": _windows, "macos-arm64": _macos}[platform.name]
    found = list(own(module, python))
    entry = f"_{ENTRY}" if platform.system == "Darwin" else ENTRY
    if module.exports != {entry}:
        extra, lacks = sorted(module.exports - {entry}), entry not in module.exports
        found += [f"it hands out {each}, which another library may take for its own" for each in extra]
        found += [f"it hands out no {entry}"] if lacks else []
    asked = {name.removeprefix("_") if platform.system == "Darwin" else name for name in module.imports}
    if names is not None:
        unknown = sorted(name for name in asked if PYTHON.fullmatch(name) and name not in names)
        found += [f"it asks for {name}, which Python {python} does not have" for name in unknown]
    return found


def _linux(module, _python):
    yield from _strangers(module.libraries - LINUX)
    for name, version in sorted(module.imports.items()):
        number = version.removeprefix("GLIBC_")
        if version.startswith("GLIBC_") and _number(number) > GLIBC:
            yield f"{name} is of glibc {number}, newer than {GLIBC[0]}.{GLIBC[1]}"
        elif version and not version.startswith("GLIBC_"):
            yield f"{name} is taken from a library of version {version}"
        elif not version and name not in ADDED and not PYTHON.fullmatch(name):
            yield f"{name} would be taken from whatever has it in Blender"
    for name in FAST:
        if name not in module.imports:
            yield f"its {name} is not that of the C library"


def _windows(module, python):
    own = f"python{python.replace('.', '')}.dll"
    yield from _strangers({name for name in module.libraries if name != own and not WINDOWS.fullmatch(name.lower())})
    for name, library in sorted(module.imports.items()):
        if PYTHON.fullmatch(name) and library != own:
            yield f"{name} is taken from {library}, not from {own}"


def _macos(module, _python):
    yield from _strangers(module.libraries - MACOS)
    for name, library in sorted(module.imports.items()):
        if not library and not PYTHON.fullmatch(name.removeprefix("_")):
            yield f"{name} would be taken from whatever has it in Blender"
    for name in sorted(module.replaceable):
        yield f"it uses {name} of whichever library in Blender has it first"
    if _number(module.system or "0") > MACOS_SYSTEM:
        yield f"it is for macOS {module.system}, newer than {MACOS_SYSTEM[0]}.{MACOS_SYSTEM[1]}"
    if not module.is_signed:
        yield "it is not signed, and macOS loads no such library"


def _strangers(libraries):
    return (f"it needs {name}, which is no part of the system" for name in sorted(libraries))


def _number(version):
    return tuple(int(part) for part in re.findall(r"\d+", version))
