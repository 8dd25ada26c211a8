# SPDX-License-Identifier: GPL-3.0-or-later
"""Output files of commands are complete, or unchanged."""

import os
import resource
import signal
from contextlib import contextmanager
from pathlib import Path

import pytest
from command import output


def write(path, text="new", **how):
    with output.written(path, **how) as fresh:
        fresh.write_text(text)


def test_a_file_is_written_under_another_name_and_then_moved(tmp_path):
    path = tmp_path / "out.png"
    path.write_text("old")
    with output.written(path) as fresh:
        fresh.write_text("new")
        assert fresh.parent == tmp_path and fresh.suffix == ".png" and fresh.name.startswith(".")
        assert path.read_text() == "old"
    assert path.read_text() == "new" and list(tmp_path.iterdir()) == [path]


def test_a_link_stays_one(tmp_path):
    path, link = tmp_path / "out.png", tmp_path / "link.png"
    link.symlink_to(path)
    write(link)
    assert link.is_symlink() and path.read_text() == "new"


@pytest.mark.parametrize("how", [{"is_whole": lambda path: False}, {"text": "\udc80"}])
def test_what_fails_leaves_what_was_there(tmp_path, how):
    path = tmp_path / "out.png"
    path.write_text("old")
    with pytest.raises(ValueError):
        write(path, **how)
    assert path.read_text() == "old" and list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("error", [OSError(28, "No space left on device"), RuntimeError("Error: cannot save")])
def test_what_could_not_be_written_is_named(tmp_path, error):
    with pytest.raises(
        ValueError, match=f"^{tmp_path}/out.png could not be written .*: make room, or name another place"
    ):
        with output.written(tmp_path / "out.png"):
            raise error


def test_nothing_written_is_said(tmp_path):
    with pytest.raises(ValueError, match="could not be written"), output.written(tmp_path / "out.png"):
        pass


def test_what_can_be_written_passes(tmp_path):
    output.check(tmp_path / "new.png")
    (tmp_path / "old.png").touch()
    output.check(tmp_path / "old.png")
    assert len(list(tmp_path.iterdir())) == 1


def test_what_cannot_be_written_is_told_before(tmp_path, monkeypatch):
    (tmp_path / "folder.png").mkdir()
    (tmp_path / "full.png").symlink_to("/dev/full")
    (tmp_path / "read_only.png").touch()
    monkeypatch.setattr(output.os, "access", lambda path, mode: Path(path).name != "read_only.png")
    for name, reason in (
        ("folder.png", "is a folder"),
        ("none/x.png", "there is no folder"),
        ("full.png", "cannot be replaced"),
        ("read_only.png", "cannot be replaced"),
        ("/proc/x.png", "nothing can be written to the folder /proc \\(.*\\): name another folder"),
    ):
        with pytest.raises(ValueError, match=reason):
            output.check(tmp_path / "good.png", tmp_path / name)
    assert not (tmp_path / "good.png").exists()


def test_a_sandbox_has_no_folder_of_its_own_where_an_output_would_be_lost():
    mounts = [line.split() for line in Path("/proc/self/mounts").read_text().splitlines()]
    own = [place for _, place, kind, *_ in mounts if kind == "tmpfs" and place in ("/", "/dev", "/run")]
    if "/" not in own:
        pytest.skip("this is no sandbox")
    for place in own:
        with pytest.raises(ValueError, match=f"nothing can be written to the folder {place} "):
            output.check(f"{place}/x.png")


@contextmanager
def no_room():
    """Context with a disk that takes 2 kB of a file, that of the tests' own output included."""
    handler, limits = signal.signal(signal.SIGXFSZ, signal.SIG_IGN), resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2048, limits[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        signal.signal(signal.SIGXFSZ, handler)


@pytest.mark.parametrize("left", [0, 100, 2048])
def test_why_a_file_broke_off_is_found_where_its_writer_does_not_say(tmp_path, left):
    with pytest.raises(ValueError, match=r"out.png could not be written \(File too large\)"):
        with no_room(), output.written(tmp_path / "out.png", lambda path: False) as fresh:
            fresh.write_bytes(bytes(left))
    assert not list(tmp_path.iterdir())


def test_a_folder_that_came_in_its_place_meanwhile_is_named(tmp_path):
    with pytest.raises(ValueError, match=r"out.png could not be written \(Is a directory\)"):
        with output.written(tmp_path / "out.png") as fresh:
            fresh.touch()
            (tmp_path / "out.png").mkdir()
    assert [path.name for path in tmp_path.iterdir()] == ["out.png"]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full")
def test_a_full_disk_is_named_as_the_reason(tmp_path):
    with pytest.raises(ValueError, match=r"out.npz could not be written \(No space left on device\)"):
        with output.written(tmp_path / "out.npz"), open("/dev/full", "wb") as file:
            os.write(file.fileno(), b"new")
