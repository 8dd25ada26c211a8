# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs tests/python, without Blender, in the Pythons of this machine for which a module has been built."""

import shutil
import subprocess
import sys

from ..target import PROJECT, StepFailed, tail
from . import build, toolchain

QUESTION = "import sys, numpy, pytest; print(*sys.version_info[:2], sep='.')"


def run(target, names):
    """names: of tests, as pytest's -k has them; "": all. 0 if they pass; StepFailed if they fail, or none can run."""
    platform = toolchain.PLATFORMS["linux-x64"]
    tried = 0
    for python, program in pythons().items():
        place = build.module_place(target.cache, platform, python)
        if not place.is_file():
            continue
        tried += 1
        folder = stage(target, place)
        words = [
            program,
            "-B",
            "-m",
            "pytest",
            "-q",
            "-p",
            "no:cacheprovider",
            PROJECT / "tests" / "python",
            "-k",
            names,
        ]
        environment = {"PYTHONPATH": str(folder), "PYTHONSAFEPATH": "1", "FOVEA_STANDALONE": str(target.cache)}
        log = target.run(f"tests with Python {python} and {place.name}", words, **environment)
        print(tail(log, 1).strip())
    if not tried:
        raise StepFailed(f"no module is built for any of these: {', '.join(pythons().values())}")
    return 0


def pythons():
    """Version -> program, of those Pythons of this machine that have what the tests need; StepFailed if none has."""
    found = {}
    names = [sys.executable, "/usr/bin/python3", *(f"python{python}" for python in toolchain.PYTHONS)]
    for program in filter(None, map(shutil.which, names)):
        done = subprocess.run([program, "-c", QUESTION], capture_output=True, text=True, check=False)
        if done.returncode == 0:
            found.setdefault(done.stdout.strip(), program)
    fit = {python: found[python] for python in toolchain.PYTHONS if python in found}
    if not fit:
        known = " or ".join(toolchain.PYTHONS)
        raise StepFailed(
            f"no Python {known} with NumPy and pytest is here (apt-get install python3-numpy python3-pytest)"
        )
    return fit


def stage(target, module):
    """A folder for sys.path with the add-on and a module beside it, as `addon`."""
    folder = target.work / "importable"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(PROJECT / "addon", folder / "addon", ignore=shutil.ignore_patterns("__pycache__", "*.pyi"))
    shutil.copytree(PROJECT / "shaders", folder / "addon" / "shaders")
    shutil.copy2(PROJECT / "LICENSE", folder / "addon")
    shutil.copy2(module, folder / "addon")
    return folder
