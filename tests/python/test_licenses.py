# SPDX-License-Identifier: GPL-3.0-or-later
"""Every source names its license in one of its first lines."""

from pathlib import Path

import pytest

PROJECT = Path(__file__).parents[2]
FOLDERS = ("addon", "blender_scripts", "native", "shaders", "tests", ".ci")
SUFFIXES = {".py", ".h", ".cpp", ".glsl", ".sh"}
LINE = "SPDX-License-Identifier: GPL-3.0-or-later"


def without_license(root):
    """Names of the sources that lack the line."""
    files = [
        root / "CMakeLists.txt",
        *(file for folder in FOLDERS for file in (root / folder).rglob("*") if is_source(file)),
    ]
    return sorted(str(file.relative_to(root)) for file in files if LINE not in opening(file))


def is_source(file):
    """By its suffix, or as a script that says what runs it."""
    return file.is_file() and (file.suffix in SUFFIXES or not file.suffix and file.read_bytes().startswith(b"#!"))


def opening(file):
    return "\n".join(file.read_text(encoding="utf-8").splitlines()[:2])


def test_every_source_has_its_license():
    assert without_license(PROJECT) == []


@pytest.mark.parametrize(
    "name", ["native/fovea/new.cpp", "addon/new.py", "shaders/new_lib.glsl", "tests/new.h", "blender_scripts/new"]
)
def test_a_source_without_license_is_found(tmp_path, name):
    (tmp_path / "CMakeLists.txt").write_text(f"# {LINE}\n")
    file = tmp_path / name
    file.parent.mkdir(parents=True)
    for text, found in (("#!/bin/sh\n", [name]), (f"#!/bin/sh\n# {LINE}\n", [])):
        file.write_text(text)
        assert without_license(tmp_path) == found
