# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea package --all -o FOLDER`: files of a folder are whole, or as they were, and the place is looked at first."""

from pathlib import Path

import pytest
from command import actions, packages


@pytest.fixture
def packed(tmp_path, monkeypatch):
    """packed(words): what `fovea package --all` writes, as texts, and prints the paths of."""
    for name in ("fovea-debian.zip", "repository/fovea-linux.zip", "repository/index.json"):
        file = tmp_path / "packages" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("new")
    monkeypatch.setattr(packages, "write", lambda target, platforms: tmp_path / "packages")
    return lambda *words: actions.package(None, ["--all", *map(str, words)])


def test_packages_are_written_into_a_folder_and_no_others_are_told(packed, tmp_path, capsys):
    place = tmp_path / "a" / "b"
    place.mkdir(parents=True)
    (place / "older.zip").write_text("old")
    (place / "fovea-debian.zip").write_text("old")
    packed("-o", place)
    names = ["fovea-debian.zip", "repository/fovea-linux.zip", "repository/index.json"]
    assert capsys.readouterr().out.splitlines() == [str(place / name) for name in names]
    assert [(place / name).read_text() for name in names] == ["new"] * 3 and (place / "older.zip").read_text() == "old"
    packed("-o", tmp_path / "c" / "d")
    assert (tmp_path / "c" / "d" / names[2]).exists()


@pytest.mark.parametrize(
    "error, raised", [(OSError(28, "No room"), ValueError), (KeyboardInterrupt(), KeyboardInterrupt)]
)
def test_a_package_that_breaks_off_leaves_what_was_there(packed, tmp_path, monkeypatch, capsys, error, raised):
    place = tmp_path / "out"
    (place / "repository").mkdir(parents=True)
    (place / "repository" / "fovea-linux.zip").write_text("old")

    def copy(file, fresh):
        Path(fresh).write_text("n")
        if "linux" in file.name:
            raise error

    monkeypatch.setattr(actions.shutil, "copy2", copy)
    with pytest.raises(raised):
        packed("-o", place)
    assert capsys.readouterr().out == f"{place}/fovea-debian.zip\n"
    assert [file.name for file in (place / "repository").iterdir()] == ["fovea-linux.zip"]
    assert (place / "repository" / "fovea-linux.zip").read_text() == "old"


@pytest.mark.parametrize(
    "name, reason",
    [
        ("a.zip", "a.zip is a file: name a folder"),
        ("a.zip/b", "a.zip is a file: name a folder"),
        ("out", "repository is a file: name a folder"),
        ("/proc/out", "nothing can be written to the folder /proc .*: name another folder"),
    ],
)
def test_a_place_for_packages_is_refused_before_they_are_built(tmp_path, monkeypatch, name, reason):
    (tmp_path / "a.zip").touch()
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "repository").touch()
    monkeypatch.setattr(packages, "write", lambda *_: pytest.fail("packages are built"))
    with pytest.raises(ValueError, match=reason):
        actions.package(None, ["--all", "-o", str(tmp_path / name)])
