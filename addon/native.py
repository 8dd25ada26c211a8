# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the native module from this folder, and explains why when it cannot be loaded."""

import importlib
import os
import sys
from contextlib import contextmanager
from pathlib import Path

UNSET = 0xFFFFFFFF  # index value for "none"


class Unavailable(RuntimeError):
    """The native module cannot be used; the message is for the user."""


class Refused(ValueError):
    """The core refuses what it is to draw; the message is one sentence for the user."""


@contextmanager
def refusals():
    """Context in which what the core refuses raises Refused; a ValueError of Python that is called stays one."""
    try:
        yield
    except ValueError as error:
        if error.__traceback__.tb_next.tb_next:  # neither here nor in the context, but further in
            raise
        raise Refused(str(error)) from error


def load():
    """The native module, the same object every time. Unavailable if it cannot be used."""
    try:
        module = importlib.import_module("._native", __package__)
    except ImportError as error:
        raise Unavailable(_explain(error)) from error
    # A process keeps the shared library it loaded first, even if another version is installed over it and the module
    # is imported again. So the identity of the file loaded first is stored in the module's `notes`; a module without
    # `notes` is of an older version.
    file = _file_of(module)
    if vars(module).get("notes", {"loaded_from": None}).setdefault("loaded_from", file) != file:
        raise Unavailable("Fovea has been updated while Blender was running; start Blender again")
    return module


def cancelled():
    """The exception that ends what polls a Cancel."""
    return load().Cancelled("cancelled")


def _file_of(module):
    """(inode, modification time in ns, size) of the module's file, to detect its replacement; None if missing."""
    try:
        found = os.stat(module.__file__)
    except FileNotFoundError:
        return None
    return found.st_ino, found.st_mtime_ns, found.st_size


def problem():
    """One sentence on why the native module cannot be used; "" if it can."""
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
