# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension zip in a separate home: builds, installs, draws, is disabled and uninstalled without a trace."""

import os
import subprocess
import zipfile
from pathlib import Path

import pytest

import addon

BLENDER = os.environ.get("FOVEA_BLENDER")
DRAW = Path(__file__).parents[2] / "blender_scripts" / "draw.py"
MODULE = "bl_ext.user_default.fovea"
# Suffixes of what the extension reads, or its user; folders have none.
USED = {"", ".py", ".so", ".toml", ".json", ".glsl", ".png", ".jpg", ".md", ".js", ".sbatch"}

pytestmark = pytest.mark.skipif(not BLENDER, reason="FOVEA_BLENDER names no Blender")


@pytest.fixture(scope="module")
def home(tmp_path_factory):
    return tmp_path_factory.mktemp("home")


@pytest.fixture(scope="module")
def blender(home):
    """Runs Blender with that home; returns its exit status and what it said."""

    def run(*words):
        command = [BLENDER, *(str(word) for word in words)]
        done = subprocess.run(
            command, env=os.environ | {"HOME": str(home)}, capture_output=True, text=True, stdin=subprocess.DEVNULL
        )
        return done.returncode, done.stdout + done.stderr

    return run


@pytest.fixture(scope="module")
def archive(blender, tmp_path_factory):
    file = tmp_path_factory.mktemp("archive") / "fovea.zip"
    status, said = blender(
        "--command", "extension", "build", "--source-dir", Path(addon.__file__).parent, "--output-filepath", file
    )
    assert status == 0 and file.is_file(), said
    return file


@pytest.fixture(scope="module")
def installed(blender, archive):
    status, said = blender("--command", "extension", "install-file", "-r", "user_default", "--enable", archive)
    assert status == 0, said


def ask(blender, expression):
    """Evaluates an expression in a Blender that starts anew."""
    code = f"import bpy, addon_utils; print('answer:', {expression})"
    status, said = blender("-b", "--python-exit-code", "1", "--python-expr", code)
    assert status == 0 and "Traceback" not in said, said
    return next(line.removeprefix("answer: ") for line in said.splitlines() if line.startswith("answer: "))


HAS_ENGINE = "bpy.types.RenderEngine.bl_rna_get_subclass_py('FOVEA') is not None, hasattr(bpy.types.Scene, 'fovea')"


def test_the_archive_is_valid(blender, archive):
    status, said = blender("--command", "extension", "validate", archive)
    assert status == 0, said


def test_the_archive_is_small_and_has_the_documentation(archive):
    with zipfile.ZipFile(archive) as packed:
        names = {name.partition("docs/")[2] for name in packed.namelist() if "docs/" in name}
    docs = Path(addon.__file__).parent / "docs"
    assert (
        names - {""} >= {str(path.relative_to(docs)) for path in docs.rglob("*.*")} >= {"README.md", "lines/ridge.png"}
    )
    assert archive.stat().st_size < 6 << 20


def test_the_archive_has_license_and_changes_and_nothing_that_only_developers_need(archive):
    with zipfile.ZipFile(archive) as packed:
        places = [Path(name) for name in packed.namelist()]
    inside = {place.name: place for place in places}
    root = inside["blender_manifest.toml"].parent
    assert inside["LICENSE"].parent == inside["CHANGELOG.md"].parent == root
    assert not [place for place in places if any(part.startswith((".", "__pycache__")) for part in place.parts)]
    assert {place.suffix for place in places if place.name != "LICENSE"} <= USED


def test_installed_it_is_enabled_at_every_start(blender, installed):
    assert ask(blender, HAS_ENGINE) == "True True"


def test_it_draws(blender, installed, tmp_path):
    model, picture = tmp_path / "a model.obj", tmp_path / "a picture.png"
    model.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 1\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n")
    status, said = blender("-b", "--python-exit-code", "1", "-P", DRAW, "--", model, "-o", picture, "--size", "96x54")
    assert status == 0 and picture.stat().st_size > 300, said


@pytest.mark.parametrize(
    "text, reason", [("o empty\n", "nothing in this file to draw"), ("v 0 0 0\n", "no size to frame")]
)
def test_what_cannot_be_drawn_writes_no_picture(blender, installed, tmp_path, text, reason):
    model, picture = tmp_path / "empty.obj", tmp_path / "picture.png"
    model.write_text(text)
    status, said = blender("-b", "--python-exit-code", "1", "-P", DRAW, "--", model, "-o", picture)
    assert status == 1 and reason in said and not picture.exists()


def test_disabled_and_enabled_again_in_one_session(blender, installed):
    again = f"addon_utils.disable('{MODULE}'), {HAS_ENGINE}, addon_utils.enable('{MODULE}') is not None, {HAS_ENGINE}"
    assert ask(blender, again) == "None False False True True True"


def test_disabled_it_stays_so(blender, installed):
    ask(blender, f"addon_utils.disable('{MODULE}', default_set=True), bpy.ops.wm.save_userpref()")
    assert ask(blender, HAS_ENGINE) == "False False"


def test_uninstalled_nothing_is_left(blender, installed, home):
    status, said = blender("--command", "extension", "remove", "user_default.fovea")
    assert status == 0, said
    assert not list(home.glob(".config/blender/*/extensions/user_default/fovea/*"))
    assert ask(blender, HAS_ENGINE) == "False False"
