# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside a Blender for own_blender.sh, with the folder of self-contained modules as its only word. Prints lines
'fovea WORD VALUE': python (version), program, include (folder of Python.h), platform, and of a module that is made for
them `tried`, then `module` if it loads and is of this checkout's sources, or `refused` with the reason. A
Blender that ends in between has tried it."""

import importlib.util
import platform
import sys
import sysconfig
from pathlib import Path

sys.path.append(str(Path(__file__).parent))

import module_sources  # noqa: E402

SYSTEMS = {"linux": "linux", "darwin": "macos", "win32": "windows"}
MACHINES = {"x86_64": "x64", "amd64": "x64", "arm64": "arm64", "aarch64": "arm64"}


def tell(word, value):
    print("fovea", word, value, flush=True)


def platform_name():
    """As modules are named by: linux-x64-cp311, for example."""
    machine = platform.machine().lower()
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{SYSTEMS.get(sys.platform, sys.platform)}-{MACHINES.get(machine, machine)}-{python}"


def modules(folder):
    """Files of a folder that this Python would take for the native module."""
    return sorted(file for file in folder.glob("_native.*") if file.suffix in (".so", ".pyd"))


def try_module(file):
    tell("tried", file)
    if not module_sources.are_these(file):
        tell("refused", "it was made of other sources than these")
        return
    try:
        spec = importlib.util.spec_from_file_location("_native", file)
        spec.loader.exec_module(importlib.util.module_from_spec(spec))
    except ImportError as error:
        reason = str(error.__cause__ or error).removeprefix(f"{file}: ")
        tell("refused", " ".join(reason.split()))
    else:
        tell("module", file)


def main(folder):
    tell("python", f"{sys.version_info.major}.{sys.version_info.minor}")
    tell("program", sys.executable)
    tell("include", sysconfig.get_path("include"))
    tell("platform", platform_name())
    for file in modules(Path(folder) / platform_name())[:1]:
        try_module(file)


if __name__ == "__main__":
    main(sys.argv[-1])
