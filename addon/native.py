# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the native module from this folder, or from the wheel that Blender has installed with the extension; explains
why when it cannot be loaded."""

import importlib
import importlib.util
import os
import platform
import sys
import tomllib
from contextlib import contextmanager
from pathlib import Path

UNSET = 0xFFFFFFFF  # index value for "none"
WHEEL = "fovea_native"  # what names of wheels and of their packages begin with; that of the build follows
PYTHONS = ("3.11", "3.13")  # for which there are wheels
SYSTEMS = {"linux": "linux", "win32": "windows", "darwin": "macos"}
MACHINES = {"x86_64": "x64", "amd64": "x64", "arm64": "arm64", "aarch64": "arm64"}
UPDATED = "Fovea has been updated while Blender was running; start Blender again"
BUILT_FOR = ("linux_x64", "windows_x64", "macos_arm64")  # as zips name them


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
        module = _import()
    except ImportError as error:
        raise Unavailable(_explain(error)) from error
    # A process keeps the shared library it loaded first, even if another version is installed over it and the module
    # is imported again. So the identity of the file loaded first is stored in the module's `notes`; a module without
    # `notes` is of an older version.
    file = _file_of(module)
    if vars(module).get("notes", {"loaded_from": None}).setdefault("loaded_from", file) != file:
        raise Unavailable(UPDATED)
    return module


def _import():
    """The module beside this file, in zips for one Blender; else that of the wheel, in those for several Pythons."""
    try:
        return importlib.import_module("._native", __package__)
    except ModuleNotFoundError:
        packages = [wheel.name.partition("-")[0] for wheel in _wheels()]
        package = next(filter(importlib.util.find_spec, packages), None)
        if package is None:
            raise
    wanted = f"{package}._native"
    if any(name.startswith(f"{WHEEL}_") and name.endswith("._native") and name != wanted for name in sys.modules):
        raise Unavailable(UPDATED)
    return importlib.import_module(wanted)


def _wheels():
    """The extension's wheels for this Python, as files; Blender unpacks them into packages of their names."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return sorted((Path(__file__).parent / "wheels").glob(f"{WHEEL}_*-{python}-*.whl"))


def place():
    """The Path of the native module's file; None if it cannot be used."""
    return None if problem() else Path(load().__file__)


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
    patterns = ("_native*.so", "_native*.pyd", f"wheels/{WHEEL}_*.whl")
    found = sorted(path.name for pattern in patterns for path in here.glob(pattern))
    if not found:
        return f"Fovea's native module is missing from the extension; {_zip_that_fits()}"
    if isinstance(error, ModuleNotFoundError) and _wheels():
        return (
            f"Blender has not unpacked Fovea's native module, {_wheels()[0].name}: uninstall Fovea in Preferences > "
            "Get Extensions, start Blender again and install it"
        )
    if isinstance(error, ModuleNotFoundError):
        return f"Fovea has no native module for {python}, only {', '.join(found)}; {_zip_that_fits()}"
    return f"Fovea's native module does not load in this Blender ({python}): {error}"


def _zip_that_fits():
    """Which zip to install in this Blender: the end of a sentence."""
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    place = f"{SYSTEMS.get(sys.platform, sys.platform)}_{MACHINES.get(platform.machine().lower(), platform.machine())}"
    if version in PYTHONS and place in BUILT_FOR:
        return f"install {_name_of_zip(place)}"
    return f"for {place} with Python {version} install the zip that `blender_scripts/fovea package` builds"


def _name_of_zip(place):
    """As Blender names the zip of a platform."""
    try:
        told = tomllib.loads((Path(__file__).parent / "blender_manifest.toml").read_text(encoding="utf-8"))
    except OSError:
        return f"the zip for {place}"
    return f"{told['id']}-{told['version']}-{place}.zip"
