# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the native module, which lies beside this file, and says what is wrong when it cannot be used."""

import importlib
import os
import sys
from pathlib import Path

UNSET = 0xFFFFFFFF  # an index that is none


class Unavailable(RuntimeError):
    """Why the native module cannot be used, in words for the user."""


def load():
    """The native module, the same object every time."""
    try:
        module = importlib.import_module("._native", __package__)
    except ImportError as error:
        raise Unavailable(_explain(error)) from error
    # A process keeps the native code that it has loaded, whatever is installed over it and however often the module is
    # imported anew; code that keeps no notes is of a version before them.
    file = _file_of(module)
    if vars(module).get("notes", {"loaded_from": None}).setdefault("loaded_from", file) != file:
        raise Unavailable("Fovea has been updated while Blender was running; start Blender again")
    return module


def _file_of(module):
    """What tells the module's file from another one in its place; None where there is none."""
    try:
        found = os.stat(module.__file__)
    except FileNotFoundError:
        return None
    return found.st_ino, found.st_mtime_ns, found.st_size


def problem():
    """Why the native module cannot be used, in one sentence; empty where it can."""
    try:
        load()
    except Unavailable as error:
        return str(error)
    return ""


def _explain(error):
    here = Path(__file__).parent
    python = f"Python {sys.version_info.major}.{sys.version_info.minor}"
    found = sorted(path.name for pattern in ("_native*.so", "_native*.pyd") for path in here.glob(pattern))
    if not found:
        return "Fovea's native module is missing from the extension; build or install the extension again"
    if isinstance(error, ModuleNotFoundError):
        return f"Fovea has no native module for {python}, only {', '.join(found)}; install the build for this Blender"
    return f"Fovea's native module does not load in this Blender ({python}): {error}"
