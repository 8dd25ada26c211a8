# SPDX-License-Identifier: GPL-3.0-or-later
"""The messages to the user when the native module cannot be used."""

import importlib
import os
import shutil
import subprocess
import sys
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path

import pytest

from addon import native as loader

LOADER = Path(__file__).parents[2] / "addon" / "native.py"


@pytest.fixture
def package(tmp_path, monkeypatch):
    """An add-on with nothing in it but the loader; its folder is returned."""
    folder = tmp_path / "without_native"
    folder.mkdir()
    (folder / "__init__.py").touch()
    shutil.copy(LOADER, folder)
    monkeypatch.syspath_prepend(tmp_path)
    importlib.invalidate_caches()
    yield folder
    for name in [name for name in sys.modules if name.startswith("without_native")]:
        del sys.modules[name]


def complaint():
    native = importlib.import_module("without_native.native")
    with pytest.raises(native.Unavailable) as error:
        native.load()
    return str(error.value)


def test_a_missing_module(package):
    assert "missing" in complaint()


def test_a_module_for_another_python(package):
    (package / "_native.cpython-37-x86_64-linux-gnu.so").touch()
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    assert version in complaint() and "cpython-37" in complaint()


def test_a_module_that_does_not_load(package):
    (package / f"_native{EXTENSION_SUFFIXES[-1]}").write_bytes(b"not a library")
    assert "does not load" in complaint()


def test_a_module_that_loads(package):
    (package / "_native.py").write_text("answer, notes = 42, {}")
    assert importlib.import_module("without_native.native").load().answer == 42


def test_a_module_that_was_replaced_while_it_was_loaded(package):
    (package / "_native.py").write_text("answer, notes = 42, {}")
    native = importlib.import_module("without_native.native")
    assert native.load() is native.load() and native.problem() == ""
    (package / "_native.py").write_text("answer, notes = 'newer', {}")
    assert "start Blender again" in complaint()
    # The add-on's own modules are new after an update, the native one is still the old one.
    del sys.modules["without_native.native"]
    assert "start Blender again" in complaint()


def test_code_that_keeps_no_notes_is_of_an_older_version(package):
    (package / "_native.py").write_text("answer = 42")
    assert "start Blender again" in complaint()


UPDATE = """
import importlib, os, shutil, sys
from pathlib import Path
folder = Path(sys.argv[1])
importlib.import_module(f"{folder.name}.native").load()
# As Blender updates an extension: its modules are forgotten, its files are new ones.
file = next(folder.glob("_native.*"))
shutil.copy(file, folder / "newer")
os.replace(folder / "newer", file)
for name in [name for name in sys.modules if name.startswith(folder.name)]:
    del sys.modules[name]
print(importlib.import_module(f"{folder.name}.native").problem())
"""


def test_the_native_module_replaced_while_it_was_loaded(package):
    """In a process of its own: one process loads native code once."""
    shutil.copy(loader.load().__file__, package)
    words = [sys.executable, "-c", UPDATE, str(package)]
    environment = {**os.environ, "PYTHONPATH": str(package.parent)}
    told = subprocess.run(words, env=environment, capture_output=True, text=True, check=True).stdout
    assert "start Blender again" in told
