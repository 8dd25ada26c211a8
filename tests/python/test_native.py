# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user hears when the native module cannot be used."""

import importlib
import shutil
import sys
from pathlib import Path

import pytest

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
    (package / "_native.abi3.so").write_bytes(b"not a library")
    assert "does not load" in complaint()


def test_a_module_that_loads(package):
    (package / "_native.py").write_text("answer = 42")
    assert importlib.import_module("without_native.native").load().answer == 42


def test_a_module_that_was_replaced_while_it_was_loaded(package):
    (package / "_native.py").write_text("answer = 42")
    native = importlib.import_module("without_native.native")
    assert native.load() is native.load() and native.problem() == ""
    (package / "_native.py").write_text("answer = 'newer'")
    assert "start Blender again" in complaint()
    # The add-on's own modules are new after an update, the native one is still the old one.
    del sys.modules["without_native.native"]
    assert "start Blender again" in complaint()
