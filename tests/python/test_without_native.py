# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension installed without its native module, or with that of another Python: it can be enabled, and reports
it."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import addon

BLENDER = os.environ.get("FOVEA_BLENDER")
MODULE = "bl_ext.user_default.fovea"
VERSION = f"{sys.version_info.major}.{sys.version_info.minor}"

pytestmark = pytest.mark.skipif(not BLENDER, reason="FOVEA_BLENDER names no Blender")

RENDER = """
import bpy, sys
bpy.ops.wm.read_homefile(app_template="")
bpy.context.scene.render.engine = "FOVEA"
bpy.context.scene.render.filepath = sys.argv[-1]
try:
    bpy.ops.render.render(write_still=True)
except RuntimeError as error:
    print("answer:", error)
"""
ABOUT = f"""
import bpy, importlib
held = bpy.context.scene.fovea
native = importlib.import_module("{MODULE}.native")
preferences = bpy.context.preferences.addons["{MODULE}"].preferences
preferences.threads, preferences.log_level = 2, "DEBUG"
print("answer:", bpy.types.RenderEngine.bl_rna_get_subclass_py("FOVEA") is not None, native.problem())
"""


@pytest.fixture(scope="module", params=["missing", "another"])
def case(request, tmp_path_factory):
    """Which way it is spoiled, and a function that runs Blender with it installed."""
    folder = tmp_path_factory.mktemp("spoiled")
    source, home, archive = folder / "source", folder / "home", folder / "fovea.zip"
    home.mkdir()
    shutil.copytree(Path(addon.__file__).parent, source, ignore=shutil.ignore_patterns("__pycache__"))
    for module in source.glob("_native*"):
        if request.param == "another":
            module.with_name("_native.cpython-37-x86_64-linux-gnu.so").write_bytes(b"of another Python")
        module.unlink()

    def blender(*words):
        done = subprocess.run(
            [BLENDER, *(str(word) for word in words)],
            env=os.environ | {"HOME": str(home)},
            capture_output=True,
            text=True,
            stdin=subprocess.DEVNULL,
        )
        return done.returncode, done.stdout + done.stderr

    build = ("--command", "extension", "build", "--source-dir", source, "--output-filepath", archive)
    install = ("--command", "extension", "install-file", "-r", "user_default", "--enable", archive)
    for words in (build, install):
        status, said = blender(*words)
        assert status == 0 and "Traceback" not in said, said
    return request.param, blender


def answer(said):
    return next(line.removeprefix("answer: ") for line in said.splitlines() if line.startswith("answer: "))


def test_it_is_enabled_and_says_what_is_wrong(case):
    spoiled, blender = case
    status, said = blender("-b", "--python-exit-code", "1", "--python-expr", ABOUT)
    assert status == 0 and "Traceback" not in said, said
    engine, problem = answer(said).split(" ", 1)
    assert engine == "True"
    assert ("missing" in problem and "install" in problem) if spoiled == "missing" else VERSION in problem


def test_a_render_says_it_too(case, tmp_path):
    _, blender = case
    picture = tmp_path / "picture.png"
    status, said = blender("-b", "--python-exit-code", "1", "--python-expr", RENDER, "--", picture)
    assert status == 1 and "Traceback" not in said, said
    assert "native module" in answer(said) and not picture.exists()
