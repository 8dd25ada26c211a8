# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea farm check`: what is missing, broken, changed or different among rendered frames is told."""

import bpy
import numpy as np
import pytest
from the_addon import part

check, records, whole = part("render.frame_check"), part("frame_records"), part("render.whole_pictures")


def write(path, value):
    path.parent.mkdir(exist_ok=True)
    image = bpy.data.images.new("Plain", 6, 4)
    image.pixels.foreach_set(np.full(6 * 4 * 4, value, np.float32))
    image.filepath_raw, image.file_format = str(path), "PNG"
    image.save()
    bpy.data.images.remove(image)


def record(path, frame):
    found = {"frame": frame, "file": path.name, "key": "", "pixels_sha256": whole.pixels_sha256(path)}
    records.append(path.parent, found)


@pytest.fixture
def pair(tmp_path):
    """Two folders of three frames, with names of their own."""
    folders = tmp_path / "a", tmp_path / "b"
    for folder in folders:
        for frame in (1, 2, 3):
            path = folder / f"{folder.name}_{frame:04}.png"
            write(path, frame / 4)
            record(path, frame)
    return folders


def test_equal_frames_are_equal_whatever_their_names(pair):
    found = check.check(pair, range(1, 4))
    assert found["equal"] and list(check.sentences(found)) == ["3 frames: all as they should be"]


def test_frames_that_are_not_there_are_told(pair):
    (pair[1] / "b_0002.png").unlink()
    write(pair[0] / "a_0007.png", 0.5)
    found = check.check(pair, range(1, 6))
    assert found["missing"] == {str(pair[0]): [4, 5], str(pair[1]): [4, 5, 7]} and not found["equal"]
    told = [f"{pair[0]} lacks frames 4-5", f"{pair[1]} lacks frames 4-5, 7", f"{pair[1] / 'b_0002.png'} is not there"]
    assert list(check.sentences(found)) == [*told, "6 frames: not as they should be"]


def test_a_file_that_breaks_off_and_one_that_was_replaced_are_told(pair):
    broken, changed = pair[0] / "a_0001.png", pair[0] / "a_0003.png"
    broken.write_bytes(broken.read_bytes()[:-1])
    write(changed, 0.5)
    found = check.check(pair[:1])
    assert found["broken"] == [str(broken)] and found["changed"] == [str(changed)] and not found["different"]


def test_how_much_frames_differ_is_told(pair):
    path = pair[1] / "b_0002.png"
    write(path, 0.6)
    record(path, 2)
    (different,) = check.check(pair)["different"]
    assert different["frame"] == 2 and different["max_difference"] == pytest.approx(0.1, abs=0.01)


def test_without_records_frames_are_told_by_their_names(pair):
    for folder in pair:
        (folder / ".fovea" / "frames.jsonl").unlink()
    assert check.check(pair, range(1, 4))["equal"]


def test_a_folder_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(ValueError, match="there is no folder"):
        check.check([tmp_path / "none"])


def test_the_command_of_blender_has_the_status_of_what_it_finds(pair, capsys):
    assert check._command([str(folder) for folder in pair]) == 0
    write(pair[0] / "a_0001.png", 0.9)
    assert check._command([str(folder) for folder in pair]) == 1
    assert "a_0001.png is not what was rendered there" in capsys.readouterr().out
    assert check._command([str(pair[0] / "none")]) == 2
