# SPDX-License-Identifier: GPL-3.0-or-later
"""Zips and wheels of all platforms: equal bytes, what wheels have in them, the manifest, and which zip fits."""

import base64
import csv
import hashlib
import importlib
import io
import re
import shutil
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest
from command import packages
from command.standalone import archive, sources, toolchain, wheel

from addon import native as loader

PROJECT = Path(__file__).parents[2]
LINUX = toolchain.PLATFORMS["linux-x64"]


@pytest.fixture
def written(tmp_path):
    """A wheel of a module that is a text."""
    module = tmp_path / LINUX.module_name("3.11")
    module.write_text("a module")
    return wheel.write(tmp_path, module, LINUX, "3.11", "0.1.0", {"LICENSE": b"free"})


def test_a_zip_has_equal_bytes_whatever_the_time_and_the_order(tmp_path):
    one, other = tmp_path / "one.zip", tmp_path / "other.zip"
    for file, names, year in ((one, "ab", 1999), (other, "ba", 2026)):
        with zipfile.ZipFile(file, "w") as made:
            for name in names:
                made.writestr(zipfile.ZipInfo(name, (year, 1, 1, 0, 0, 0)), f"content of {name}")
    assert one.read_bytes() != other.read_bytes()
    for file in (one, other):
        archive.normalize(file)
    assert one.read_bytes() == other.read_bytes()
    with zipfile.ZipFile(one) as made:
        assert made.namelist() == ["a", "b"] and made.read("b") == b"content of b"


def test_a_wheel_names_build_python_and_platform(written):
    digest = hashlib.sha256(b"a module").hexdigest()[:8]
    assert written.name == f"fovea_native_{digest}-0.1.0-cp311-cp311-manylinux_2_28_x86_64.whl"


def test_a_wheel_records_each_of_its_files(written):
    with zipfile.ZipFile(written) as made:
        (record,) = (name for name in made.namelist() if name.endswith("RECORD"))
        rows = {row[0]: row[1:] for row in csv.reader(io.StringIO(made.read(record).decode()))}
        assert set(rows) == set(made.namelist())
        for name in set(rows) - {record}:
            digest = base64.urlsafe_b64encode(hashlib.sha256(made.read(name)).digest()).decode().rstrip("=")
            assert rows[name] == [f"sha256={digest}", str(len(made.read(name)))]
        assert any(name.endswith("licenses/LICENSE") for name in rows)


def test_the_manifest_with_wheels_differs_in_nothing_else():
    text = (PROJECT / "addon" / "blender_manifest.toml").read_text()
    told = tomllib.loads(packages.with_wheels(text, ["linux-x64", "windows-x64"], ["a.whl", "b.whl"]))
    assert told.pop("wheels") == ["./wheels/a.whl", "./wheels/b.whl"]
    assert told == tomllib.loads(text) | {"platforms": ["linux-x64", "windows-x64"]}


def test_a_manifest_without_platforms_is_refused():
    with pytest.raises(ValueError, match="one line of platforms"):
        packages.with_wheels('id = "fovea"\n', ["linux-x64"], [])


def test_the_version_is_declared_by_the_extension_alone():
    assert not re.search(r"project\([^)]*VERSION \d", (PROJECT / "CMakeLists.txt").read_text())


def test_the_addon_knows_the_platforms_and_pythons_of_wheels():
    assert loader.PYTHONS == toolchain.PYTHONS and loader.WHEEL == wheel.PACKAGE
    assert loader.BUILT_FOR == tuple(name.replace("-", "_") for name in toolchain.PLATFORMS)


@pytest.fixture
def without_module(tmp_path, monkeypatch):
    """The add-on's loader and manifest without a module, as a package."""
    folder = tmp_path / "no_module"
    folder.mkdir()
    (folder / "__init__.py").touch()
    for name in ("native.py", "blender_manifest.toml"):
        shutil.copy(PROJECT / "addon" / name, folder)
    monkeypatch.syspath_prepend(tmp_path)
    importlib.invalidate_caches()
    yield importlib.import_module("no_module.native")
    for name in [name for name in sys.modules if name.startswith(("no_module", "fovea_native"))]:
        del sys.modules[name]


def test_without_a_module_the_zip_that_fits_is_named(without_module, monkeypatch):
    version = tomllib.loads((PROJECT / "addon" / "blender_manifest.toml").read_text())["version"]
    monkeypatch.setattr(without_module.platform, "machine", lambda: "AMD64")
    monkeypatch.setattr(without_module, "sys", Windows())
    assert without_module.problem().endswith(f"install fovea-{version}-windows_x64.zip")
    monkeypatch.setattr(without_module.platform, "machine", lambda: "arm64")
    assert "for windows_arm64 with Python 3.11 install the zip that `" in without_module.problem()


class Windows:
    """`sys` of a Python 3.11 on Windows."""

    platform = "win32"

    class version_info:
        major, minor = 3, 11


@pytest.fixture
def unpacked(without_module, tmp_path):
    """unpacked(package): a wheel for this Python is in the extension, and is unpacked as a package."""

    def make(package, text="answer, notes = 42, {}"):
        wheels = Path(without_module.__file__).parent / "wheels"
        shutil.rmtree(wheels, ignore_errors=True)
        wheels.mkdir()
        python = f"cp{sys.version_info.major}{sys.version_info.minor}"
        (wheels / f"{package}-0.1.0-{python}-{python}-any.whl").touch()
        (tmp_path / package).mkdir()
        (tmp_path / package / "__init__.py").write_text(wheel.INIT)
        (tmp_path / package / "_native.py").write_text(text)
        importlib.invalidate_caches()
        return tmp_path / package

    return make


def test_the_module_of_the_wheel_is_taken(without_module, unpacked, tmp_path):
    unpacked("fovea_native_2")
    shutil.copytree(tmp_path / "fovea_native_2", tmp_path / "fovea_native_1")  # of an extension that is no more
    assert without_module.load().__name__ == "fovea_native_2._native" and without_module.load().answer == 42


def test_the_module_of_another_wheel_waits_for_a_new_start(without_module, unpacked):
    unpacked("fovea_native_1")
    assert without_module.problem() == ""
    unpacked("fovea_native_2")
    assert without_module.problem() == without_module.UPDATED and "fovea_native_2._native" not in sys.modules


def test_a_wheel_that_is_not_unpacked_is_named(without_module, unpacked):
    shutil.rmtree(unpacked("fovea_native_1"))
    importlib.invalidate_caches()
    assert "not unpacked Fovea's native module, fovea_native_1-0.1.0-cp" in without_module.problem()


def test_wheels_of_another_python_are_named(without_module):
    wheels = Path(without_module.__file__).parent / "wheels"
    wheels.mkdir()
    (wheels / "fovea_native_1-0.1.0-cp37-cp37-manylinux_2_28_x86_64.whl").touch()
    assert "only fovea_native_1-0.1.0-cp37-cp37-manylinux_2_28_x86_64.whl; " in without_module.problem()


def test_every_source_is_pinned_and_what_modules_consist_of_has_its_license():
    table = sources.declared()
    assert all(re.fullmatch(r"[0-9a-f]{64}", source.sha256) for source in table)
    assert all(bool(source.npm) != bool(source.file and source.suite) for source in table)
    built_in = {
        "onetbb",
        "embree",
        "opensubdiv",
        "openmesh",
        "zlib",
        "libpng",
        "xxhash",
        "glm",
        "nlohmann_json",
        "pybind11",
    }
    assert {source.name for source in table if source.licenses} == built_in | {"zig_lib"}


@pytest.mark.parametrize("name, part", [("linux-x64", "LICENSES"), ("windows-x64", "COPYING"), ("macos-arm64", None)])
def test_a_wheel_has_the_license_of_the_c_library_of_its_system(name, part, tmp_path):
    for source in sources.declared():
        for each in (*map(source.place, source.licenses), "libc/glibc/LICENSES", "libc/mingw/COPYING"):
            file = tmp_path / source.name / each
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(f"license of {each}")
    found = wheel.licenses(tmp_path, PROJECT / "LICENSE", toolchain.PLATFORMS[name])
    assert [each for each in found if each.startswith(name)] == ([f"{name}-{part}"] if part else [])
    assert {"zig_lib-LICENSE.TXT", "embree-LICENSE.txt"} < set(found)


def test_an_archive_with_another_checksum_is_not_taken(tmp_path, monkeypatch):
    source = sources.Source("zlib", "1", "0" * 64, file="main/z/zlib.tar.gz", suite="trixie")
    monkeypatch.setattr(sources, "_from_debian", lambda _source, folder: (folder / "zlib.tar.gz").write_text("other"))
    with pytest.raises(sources.StepFailed, match="is another file than it was"):
        sources.unpacked(tmp_path, [source])
    assert not (tmp_path / "archives" / "zlib.tar.gz").exists()


def test_a_source_that_is_not_to_be_had_is_named(tmp_path, monkeypatch):
    source = sources.Source("zlib", "1", "0" * 64, file="main/z/zlib.tar.gz", suite="trixie")
    monkeypatch.setattr(sources, "_from_debian", lambda _source, _folder: "404 Not Found")
    with pytest.raises(
        sources.StepFailed, match=r"zlib 1 .* cannot be had .*404 Not Found.*put a file with the SHA256 0"
    ):
        sources.unpacked(tmp_path, [source])
