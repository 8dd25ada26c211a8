# SPDX-License-Identifier: GPL-3.0-or-later
"""The zip of a platform, with its module in a wheel, installed in a Blender and updated while the old module is loaded:
as systems do it that let go of a file that is in use, and as Windows does, which lets nobody remove or write it."""

import hashlib
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from command import packages
from command.standalone import toolchain, wheel

import addon
from addon import native as loader

BLENDER = os.environ.get("FOVEA_BLENDER")
PYTHON = f"{sys.version_info.major}.{sys.version_info.minor}"
LINUX = toolchain.PLATFORMS["linux-x64"]

pytestmark = pytest.mark.skipif(not BLENDER, reason="FOVEA_BLENDER names no Blender")

ASK = """
import hashlib, json, sys
from pathlib import Path
import bpy
def told():
    from bl_ext.user_default.fovea import native
    found = {"problem": native.problem()}
    if not found["problem"]:
        found["digest"] = hashlib.sha256(Path(native.load().__file__).read_bytes()).hexdigest()
    return found
"""
SAY = "\nprint('told: ' + json.dumps(told()), flush=True)\n"
UPDATE = """
assert told()["digest"] == {digest!r}
bpy.ops.extensions.package_install_files(filepath={archive!r}, repo="user_default", enable_on_install=True)
"""
# What Windows does with a library that is loaded: its name can be changed, but not that of a folder that it is in.
WINDOWS = """
import builtins, os
from bl_ext.user_default.fovea import native
LOADED = Path(native.load().__file__)
inode = LOADED.stat().st_ino

def refuse(name):
    raise PermissionError(13, "it is used by another process", name)

def guarded(function, holds):
    def call(name, *words, **more):
        if holds(name, *words, **more):
            refuse(name)
        return function(name, *words, **more)
    return call

def is_loaded(name, *_words, dir_fd=None, **_more):
    try:
        return os.stat(name, dir_fd=dir_fd).st_ino == inode
    except (OSError, TypeError, ValueError):
        return False

os.unlink = guarded(os.unlink, is_loaded)
os.remove = guarded(os.remove, is_loaded)
os.rename = guarded(os.rename, lambda name, *_: Path(name) in [*LOADED.parents])
builtins.open = guarded(open, lambda name, mode="r", *_, **__: "w" in mode and is_loaded(name))
"""


def blender(home, *words):
    """Runs Blender with a home; returns what it said."""
    done = subprocess.run(
        [BLENDER, *map(str, words)], env=os.environ | {"HOME": str(home)}, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def told(home, code):
    said = blender(home, "-b", "--python-exit-code", "1", "--python-expr", code)
    return json.loads(next(line for line in said.splitlines() if line.startswith("told: ")).removeprefix("told: "))


def archive(folder, module):
    """A zip as that of a platform, whose wheel for this Python has a module."""
    staged = folder / "staged"
    left_out = shutil.ignore_patterns("_native*", "__pycache__", "docs", "papers", "textures")
    shutil.copytree(Path(addon.__file__).parent, staged, ignore=left_out)
    (staged / "wheels").mkdir()
    manifest = staged / "blender_manifest.toml"
    made = wheel.write(staged / "wheels", module, LINUX, PYTHON, "0.1.0", {})
    manifest.write_text(packages.with_wheels(manifest.read_text(), ["linux-x64"], [made.name]))
    file = folder / "fovea.zip"
    blender(folder, "--command", "extension", "build", "--source-dir", staged, "--output-filepath", file)
    return file


@pytest.fixture(scope="module")
def builds(tmp_path_factory):
    """[(zip, digest of its module)] of two builds, whose modules differ in one byte."""
    made = []
    for end in b"\0", b"\1":
        folder = tmp_path_factory.mktemp("build")
        module = folder / LINUX.module_name(PYTHON)
        module.write_bytes(Path(loader.load().__file__).read_bytes() + end)
        made.append((archive(folder, module), hashlib.sha256(module.read_bytes()).hexdigest()))
    return made


@pytest.fixture(scope="module")
def installed(builds, tmp_path_factory):
    """A home in which the first build is installed."""
    home = tmp_path_factory.mktemp("home")
    blender(home, "--command", "extension", "install-file", "-r", "user_default", "--enable", builds[0][0])
    return home


@pytest.mark.parametrize("system", ["", WINDOWS], ids=["Linux", "Windows"])
def test_an_update_while_the_module_is_loaded_asks_for_a_new_start_and_then_works(installed, builds, system, tmp_path):
    home = shutil.copytree(installed, tmp_path / "home")
    update = UPDATE.format(digest=builds[0][1], archive=str(builds[1][0]))
    assert "start Blender again" in told(home, ASK + system + update + SAY)["problem"]
    assert told(home, ASK + SAY) == {"problem": "", "digest": builds[1][1]}
    assert len(list(home.rglob("_native.*.so"))) == 1, "nothing of the old build is left"
