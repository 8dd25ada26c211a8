# SPDX-License-Identifier: GPL-3.0-or-later
"""A .blend that `fovea scene` reports is complete: truncation by a full disk is detected; the previous file stays."""

import sys
from pathlib import Path

import bpy
import pytest
from pictures import box_scene, in_blender_without_room

SCRIPTS = Path(__file__).parents[2] / "blender_scripts"
sys.path.insert(0, str(SCRIPTS))

import save_scene


@pytest.fixture
def saved(tmp_path):
    box_scene()
    save_scene.save(tmp_path / "box.blend")
    return tmp_path / "box.blend"


def test_a_saved_scene_is_whole_and_can_be_opened(saved):
    assert save_scene.is_whole(saved) and list(saved.parent.iterdir()) == [saved]
    bpy.ops.wm.open_mainfile(filepath=str(saved))
    assert "Box" in bpy.data.objects


@pytest.mark.parametrize("kept", [0, 8, 16, 100, 0.1, 0.5, 0.9, -100, -24, -1])
def test_a_scene_that_breaks_off_is_not_whole(saved, kept):
    data = saved.read_bytes()
    saved.write_bytes(data[: kept if isinstance(kept, int) else round(kept * len(data))])
    assert not save_scene.is_whole(saved)


@pytest.mark.parametrize("head", [24, 32])
def test_a_scene_with_a_hole_is_not_whole(saved, head):
    """Between two blocks, and as long as heads of either format: read as heads, its zeros lead to the second block."""
    data = saved.read_bytes()
    start = data.index(b"DATA", len(data) // 3)
    end = data.index(b"DATA", 2 * len(data) // 3)
    saved.write_bytes(data[:start] + bytes(head * ((end - start) // head)) + data[end:])
    assert not save_scene.is_whole(saved)


def test_a_missing_scene_is_not_whole(tmp_path):
    assert not save_scene.is_whole(tmp_path / "none.blend")


def test_a_full_disk_is_said_and_leaves_what_was_there(tmp_path):
    path = tmp_path / "x.blend"
    path.write_text("of an earlier run")
    done = in_blender_without_room(["-P", SCRIPTS / "save_scene.py", "--", "boxes:3", "-o", path])
    (said,) = [line for line in done.stderr.splitlines() if line.startswith("fovea: ")]
    assert done.returncode == 1 and f"{path} could not be written (File too large)" in said
    assert "fovea wrote" not in done.stdout
    assert list(tmp_path.iterdir()) == [path] and path.read_text() == "of an earlier run"
