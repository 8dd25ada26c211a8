# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension is packed and installed again only if the zip or the installed files are not those of the package."""

import os
import shutil

import pytest
from command import package, target

FILES = {"__init__.py": "", "blender_manifest.toml": "id = 'fovea'", "styles/plain.json": "{}"}


class Installation:
    """A package of a few files, and a Blender that only copies them, and bears nothing else in their place, which it
    would load. `count`: how often it was asked to."""

    def __init__(self, folder, monkeypatch):
        self.staged, self.count = folder / "staged", 0
        for name, text in FILES.items():
            (self.staged / name).parent.mkdir(parents=True, exist_ok=True)
            (self.staged / name).write_text(text)
        self.blender = folder / "blender"
        self.blender.touch()
        self.target = target.Target("sid", folder / "work", folder / "cache", str(self.blender), "")
        self.place = self.target.home / ".config/blender/5.2/extensions/user_default/fovea"
        monkeypatch.setattr(package, "stage", lambda target: self.staged)
        monkeypatch.setattr(package, "package", lambda target, folder: folder)
        monkeypatch.setattr(package, "extension", self.copy)

    def copy(self, target, sentence, *words):
        assert not self.place.exists() or package._content(self.place) == package._content(self.staged)
        shutil.rmtree(self.place, ignore_errors=True)
        shutil.copytree(words[-1], self.place)
        self.count += 1

    def install(self):
        package.install(self.target)
        return self.count


@pytest.fixture
def installation(tmp_path, monkeypatch):
    made = Installation(tmp_path, monkeypatch)
    assert made.install() == 1
    return made


def test_what_is_installed_is_left_alone(installation):
    assert installation.install() == 1


def test_what_python_compiled_may_be_damaged_and_is_not_loaded(installation):
    compiled = installation.place / "styles" / "__pycache__" / "plain.cpython-313.pyc"
    compiled.parent.mkdir()
    compiled.write_bytes(b"junk")
    assert installation.install() == 1 and not compiled.exists()


@pytest.mark.parametrize("name", FILES)
def test_a_lost_file_is_installed_again(installation, name):
    (installation.place / name).unlink()
    assert installation.install() == 2 and (installation.place / name).read_text() == FILES[name]


def test_a_changed_file_is_installed_again(installation):
    (installation.place / "__init__.py").write_text("import nothing")
    assert installation.install() == 2 and (installation.place / "__init__.py").read_text() == ""


def test_a_lost_folder_is_installed_again(installation):
    shutil.rmtree(installation.place)
    assert installation.install() == 2


def test_another_package_is_installed(installation):
    (installation.staged / "__init__.py").write_text("VERSION = 2")
    assert installation.install() == 2


def test_for_another_version_of_blender_it_is_installed_again(installation):
    installation.blender.write_text("of another version, which looks into another folder")
    assert installation.install() == 2


@pytest.mark.parametrize("damage", [lambda file: file.unlink(), lambda file: file.write_text("junk")])
def test_where_preferences_are_lost_or_damaged_it_is_installed_and_enabled_again(installation, damage):
    file = installation.place.parents[2] / "config/userpref.blend"
    file.parent.mkdir()
    file.write_text("enabled")
    assert installation.install() == 2 and installation.install() == 2
    damage(file)
    assert installation.install() == 3


def test_a_file_that_is_damaged_and_keeps_its_size_and_time_is_installed_again(installation):
    file = installation.place / "styles/plain.json"
    before = file.stat()
    file.write_text("[]")
    os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns))
    assert installation.install() == 2 and file.read_text() == "{}"


def test_what_another_part_installs_meanwhile_is_left_alone(installation, monkeypatch):
    (installation.staged / "__init__.py").write_text("VERSION = 2")

    def packed_while_another_part_installs(target, folder):
        monkeypatch.setattr(package, "package", lambda target, folder: folder)
        assert installation.install() == 2
        return folder

    monkeypatch.setattr(package, "package", packed_while_another_part_installs)
    assert installation.install() == 2


@pytest.fixture
def packed(tmp_path, monkeypatch):
    """Packs a package of one file where a damaged one is installed; returns the zip and how often it was built."""
    (tmp_path / "staged").mkdir()
    (tmp_path / "staged/blender_manifest.toml").write_text("version = '1.0.0'")
    made, built = target.Target("sid", tmp_path / "work", tmp_path / "cache", "blender", ""), []
    (made.work / "package").mkdir(parents=True)
    module = made.home / ".config/blender/5.2/extensions/user_default/fovea/_native.so"
    module.parent.mkdir(parents=True)
    module.write_bytes(b"damaged")

    def extension(target, sentence, *words):
        assert not module.exists()  # Blender would load it
        if words[0] == "build":
            built.append(words[-1].write_bytes(b"packed"))

    monkeypatch.setattr(package, "extension", extension)
    return lambda: (package.package(made, tmp_path / "staged"), len(built))


def test_a_zip_is_built_once(packed):
    assert packed() == packed() and packed()[1] == 1


@pytest.mark.parametrize("damage", [lambda file: os.truncate(file, 3), lambda file: file.unlink()])
def test_a_damaged_zip_is_built_again(packed, damage):
    damage(packed()[0])
    file, count = packed()
    assert file.read_bytes() == b"packed" and count == 2
