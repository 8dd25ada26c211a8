# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames of background renders with FOVEA_ATOMIC: whole, recorded, and rendered once, whatever ends Blender."""

import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import bpy
import pytest
from pictures import box_scene, pixels_of
from the_addon import fovea, part

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import render

whole, records, check = part("render.whole_frames"), part("frame_records"), part("render.frame_check")
FRAMES = range(1, 5)


@pytest.fixture
def atomic(monkeypatch):
    """Switches it on for this process, which stays."""
    monkeypatch.setenv("FOVEA_ATOMIC", "1")
    monkeypatch.setattr(whole, "exits", False)
    whole.register()
    yield monkeypatch
    whole.unregister()
    whole.finished.clear()
    whole.failures.clear()


def moving(folder, engine="FOVEA"):
    """A box before a camera that moves, saved; frames go to FOLDER/out/box_####.png."""
    scene = box_scene()
    scene.render.engine = engine
    scene.render.image_settings.file_format = "PNG"
    scene.frame_start, scene.frame_end = FRAMES[0], FRAMES[-1]
    for frame in (FRAMES[0], FRAMES[-1]):
        scene.camera.location.x += 0.5
        scene.camera.keyframe_insert("location", frame=frame)
    scene.render.filepath = str(folder / "out" / "box_####")
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / "box.blend"))
    return scene


def rendered():
    """Frames that one call of Blender renders."""
    whole.finished.clear()
    bpy.ops.render.render(animation=True)
    return [int(path.stem[-4:]) for path in whole.finished]


def names(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


def test_frames_are_recorded_under_their_own_names_and_nothing_else_is_left(tmp_path, atomic):
    scene, out = moving(tmp_path), tmp_path / "out"
    before = scene.render.filepath, scene.render.use_overwrite, scene.render.use_placeholder
    assert rendered() == [*FRAMES]
    files = [f"box_{frame:04}.png" for frame in FRAMES]
    assert names(out) == sorted([".fovea", ".fovea/.lock", ".fovea/frames.jsonl", *files])
    assert (scene.render.filepath, scene.render.use_overwrite, scene.render.use_placeholder) == before
    found = records.read(out)
    assert [found[name]["frame"] for name in files] == [*FRAMES]
    assert len({found[name]["pixels_sha256"] for name in files}) == len(FRAMES)
    assert check.check([out], FRAMES)["equal"]


def test_vectors_with_every_render_are_beside_the_frames_that_are_moved_into_place(tmp_path, atomic):
    scene, out = moving(tmp_path), tmp_path / "out"
    scene.fovea.vectors.kind = "SVG"
    assert rendered() == [*FRAMES] and not whole.failures
    assert [name for name in names(out) if name.endswith(".svg")] == [f"box_{frame:04}.svg" for frame in FRAMES]


def test_only_what_is_not_as_it_was_recorded_is_rendered_again(tmp_path, atomic):
    moving(tmp_path)
    out = tmp_path / "out"
    rendered()
    shutil.copytree(out, tmp_path / "first")
    atomic.setenv("FOVEA_RESUME", "1")
    assert rendered() == []
    (out / "box_0001.png").unlink()
    shutil.copy(out / "box_0003.png", out / "box_0002.png")
    data = (out / "box_0004.png").read_bytes()
    (out / "box_0004.png").write_bytes(data[:-20])
    assert rendered() == [1, 2, 4]
    assert check.check([out, tmp_path / "first"], FRAMES)["equal"]


def test_another_size_or_file_is_rendered_anew(tmp_path, atomic):
    scene = moving(tmp_path)
    atomic.setenv("FOVEA_RESUME", "1")
    assert rendered() == [*FRAMES]
    scene.render.resolution_x += 8
    assert rendered() == [*FRAMES] and rendered() == []
    bpy.ops.wm.save_mainfile()
    assert rendered() == [*FRAMES] and rendered() == []


def test_without_overwrite_frames_that_are_done_stay(tmp_path, atomic):
    scene = moving(tmp_path)
    scene.render.use_overwrite = False
    assert rendered() == [*FRAMES]
    (tmp_path / "out" / "box_0003.png").write_bytes(b"")  # as Blender's placeholders, which Blender would skip
    assert rendered() == [3]
    scene.render.use_overwrite = True
    assert rendered() == [*FRAMES]


def test_a_frame_that_is_not_whole_is_said_and_leaves_what_was_there(tmp_path, atomic, capfd):
    moving(tmp_path)
    place = tmp_path / "out" / "box_0002.png"
    place.parent.mkdir()
    place.write_text("of an earlier run")
    hashed = part("render.whole_pictures").pixels_sha256
    atomic.setattr(whole.whole_pictures, "pixels_sha256", lambda path: None if "0002" in path.name else hashed(path))
    assert rendered() == [1, 3, 4] and place.read_text() == "of an earlier run"
    assert f"{place} could not be written" in capfd.readouterr().err and len(whole.failures) == 1


@pytest.mark.parametrize("layers", [False, True])
def test_any_engine_and_layers_are_recorded_by_their_pixels_alone(tmp_path, atomic, layers):
    scene = moving(tmp_path, "BLENDER_WORKBENCH")
    settings = scene.render.image_settings
    if hasattr(settings, "media_type"):
        settings.media_type = "MULTI_LAYER_IMAGE" if layers else "IMAGE"
    settings.file_format = "OPEN_EXR_MULTILAYER" if layers else "OPEN_EXR"
    assert rendered() == [*FRAMES]
    first = {name: record["pixels_sha256"] for name, record in records.read(tmp_path / "out").items()}
    scene.render.use_stamp_note, scene.render.stamp_note_text = True, "something else"
    assert rendered() == [*FRAMES]
    assert {name: record["pixels_sha256"] for name, record in records.read(tmp_path / "out").items()} == first
    assert len(set(first.values())) == len(FRAMES)


def test_both_eyes_of_a_stereo_pair_are_recorded(tmp_path, atomic):
    scene = moving(tmp_path)
    scene.render.use_multiview, scene.frame_end = True, 1
    atomic.setenv("FOVEA_RESUME", "1")
    assert rendered_names() == ["box_0001_L.png", "box_0001_R.png"] and rendered_names() == []
    (tmp_path / "out" / "box_0001_R.png").unlink()
    assert rendered_names() == ["box_0001_L.png", "box_0001_R.png"]


def rendered_names():
    whole.finished.clear()
    bpy.ops.render.render(animation=True)
    return [path.name for path in whole.finished]


def test_a_still_is_moved_into_place_too(tmp_path, atomic):
    scene = moving(tmp_path)
    scene.render.filepath = str(tmp_path / "still.png")
    bpy.ops.render.render(write_still=True)
    assert pixels_of(tmp_path / "still.png").shape[:2] == (90, 160)
    assert list(records.read(tmp_path)) == ["still.png"]


def test_what_writes_nothing_leaves_nothing(tmp_path, atomic):
    moving(tmp_path)
    bpy.ops.render.render()
    assert names(tmp_path) == ["box.blend", "out"]


@pytest.fixture
def no_place(tmp_path):
    """Where frames of `moving` cannot be recorded."""
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / ".fovea").touch()
    return ["box.blend", "out", "out/.fovea"]


def test_blender_ends_before_it_renders_where_nothing_can_be_written(tmp_path, atomic, no_place):
    moving(tmp_path)
    words = [bpy.app.binary_path, "-b", "--factory-startup", "--addons", fovea.__name__, tmp_path / "box.blend", "-a"]
    done = subprocess.run(words, capture_output=True, text=True, errors="replace")
    assert done.returncode == 1 and "box_0001.png could not be written" in done.stderr
    assert "Traceback" not in done.stderr and names(tmp_path) == no_place


def test_the_command_says_where_nothing_can_be_written(tmp_path, atomic, no_place):
    moving(tmp_path)
    with pytest.raises(ValueError, match="box_0001.png could not be written"):
        render.main([str(tmp_path / "box.blend")])
    assert names(tmp_path) == no_place


def test_a_frame_that_cannot_be_recorded_is_said(tmp_path, atomic, capfd):
    moving(tmp_path)
    (tmp_path / "out" / ".fovea" / records.NAME).mkdir(parents=True)
    bpy.ops.render.render(write_still=True)
    assert "Frame 1 could not be recorded (Is a directory)" in capfd.readouterr().err and whole.failures


def test_the_command_renders_by_the_file_s_own_engine_where_it_is_told(tmp_path, atomic, capfd):
    moving(tmp_path, "BLENDER_WORKBENCH")
    bpy.ops.wm.read_homefile(use_empty=True)
    place = tmp_path / "a{b}#" / "x_##"
    render.main([str(tmp_path / "box.blend"), "--frames", "2-3", "-o", str(place)])
    assert bpy.context.scene.render.engine == "BLENDER_WORKBENCH"
    assert list(records.read(place.parent)) == ["x_02.png", "x_03.png"]
    assert [line for line in capfd.readouterr().out.splitlines() if line.startswith("fovea wrote: ")] == [
        f'fovea wrote: "{place.parent / name}"' for name in ("x_02.png", "x_03.png")
    ]


def test_the_command_refuses_a_movie(tmp_path, atomic):
    settings = moving(tmp_path).render.image_settings
    if hasattr(settings, "media_type"):
        settings.media_type = "VIDEO"
    settings.file_format = "FFMPEG"
    bpy.ops.wm.save_mainfile()
    with pytest.raises(ValueError, match="box.blend renders a movie"):
        render.main([str(tmp_path / "box.blend"), "-o", str(tmp_path / "x_##")])


def test_a_killed_blender_leaves_whole_frames_and_the_next_one_does_the_rest(tmp_path, atomic):
    moving(tmp_path)
    out = tmp_path / "out"
    rendered()
    out.rename(tmp_path / "undisturbed")
    words = [bpy.app.binary_path, "-b", "--factory-startup", "--addons", fovea.__name__, tmp_path / "box.blend", "-a"]
    blender = subprocess.Popen(words, stdout=subprocess.PIPE, text=True, errors="replace")
    seen = next(line for line in blender.stdout if line.startswith("Saved: ") and ".fovea" not in line)
    os.kill(blender.pid, signal.SIGKILL)
    blender.wait()
    assert Path(seen[len("Saved: '") : -2]) == out / "box_0001.png"
    left = check.check([out])
    assert left["equal"] and left["frames"] >= 1
    atomic.setenv("FOVEA_RESUME", "1")
    assert rendered() == [*FRAMES][left["frames"] :]
    assert check.check([out, tmp_path / "undisturbed"], FRAMES)["equal"]
    assert len(names(out / ".fovea")) == 2, "what the killed one had begun is gone"
