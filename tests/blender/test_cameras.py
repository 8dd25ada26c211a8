# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture from each camera of a file, in one go."""

import sys
from pathlib import Path

import bpy
import numpy as np
import pytest
from pictures import box_scene, drawn, in_blender_without_room, pixels_of
from the_addon import add_camera, part

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import draw
import ending

cameras = part("render.cameras")


@pytest.fixture
def scene():
    """A box seen by three cameras; the names of two are alike as names of files."""
    scene = box_scene()
    scene.camera.name = "Front"
    for name, place in (("Side/1", (8, 0, 2)), ("side 1", (0, 0, 9))):
        add_camera(place).name = name
    scene.camera = scene.objects["Front"]
    return scene


FILES = ["Front", "Side_1", "side_1_2"]


def names_in(folder):
    return sorted(path.name for path in folder.glob("*.png"))


def test_no_two_cameras_have_the_same_file(scene):
    assert cameras.file_names(cameras.of(scene)) == FILES


def alone(scene, camera, path):
    scene.camera = scene.objects[camera]
    return drawn(scene, path)


def test_every_camera_of_a_file_is_drawn(scene, tmp_path, capsys):
    out, expected = tmp_path / "out", {}
    out.mkdir()
    for camera, name in zip(cameras.of(scene), FILES):
        expected[f"box_{name}.png"] = alone(scene, camera.name, tmp_path / "alone.png")
    blend = str(tmp_path / "box.blend")
    bpy.ops.wm.save_as_mainfile(filepath=blend)
    draw.main([blend, "--cameras", "all", "-o", str(out / "box.png")])
    assert names_in(out) == sorted(expected)
    for name, picture in expected.items():
        np.testing.assert_array_equal(pixels_of(out / name)[..., :3], picture[..., :3])
    draw.main([blend, "--cameras", "side 1,Front", "--frames", "1-2", "-o", str(out / "two.png")])
    found = [name for name in names_in(out) if name.startswith("two")]
    assert found == [f"two_{name}_{frame:04}.png" for name in ("Front", "side_1_2") for frame in (1, 2)]
    told = [Path(path) for path in map(ending.announced, capsys.readouterr().out.splitlines()) if path]
    assert sorted(told) == sorted(out.iterdir())


def test_a_camera_that_is_not_there_is_named(scene, tmp_path):
    blend = str(tmp_path / "box.blend")
    bpy.ops.wm.save_as_mainfile(filepath=blend)
    with pytest.raises(ValueError, match="no camera 'Back'; there are: Front, Side/1, side 1"):
        draw.main([blend, "--cameras", "Front,Back", "-o", str(tmp_path / "box.png")])


@pytest.mark.parametrize("names", ["all", "Front"])
def test_of_a_scene_without_cameras_none_are_drawn(tmp_path, names):
    scene = box_scene()
    bpy.data.objects.remove(scene.camera)
    blend = str(tmp_path / "box.blend")
    bpy.ops.wm.save_as_mainfile(filepath=blend)
    with pytest.raises(ValueError, match="the scene has no camera; leave it out"):
        draw.main([blend, "--cameras", names, "--focus", "0,0,0", "-o", str(tmp_path / "box.png")])


def test_a_linked_camera_of_the_same_name_has_a_picture_of_its_own(scene, tmp_path):
    library = str(tmp_path / "library.blend")
    bpy.data.libraries.write(library, {bpy.data.objects["Front"]})
    with bpy.data.libraries.load(library, link=True) as (_, linked):
        linked.objects = ["Front"]
    scene.collection.objects.link(linked.objects[0])
    blend, out = str(tmp_path / "box.blend"), tmp_path / "out"
    bpy.ops.wm.save_as_mainfile(filepath=blend)
    out.mkdir()
    draw.main([blend, "--cameras", "Front", "-o", str(out / "box.png")])
    assert names_in(out) == ["box_Front.png", "box_Front_2.png"]


@pytest.mark.parametrize("output, expected", [("box", [f"box_{name}.png" for name in FILES]), ("", None)])
def test_the_operator_renders_from_all_and_leaves_camera_markers_and_path(scene, tmp_path, output, expected):
    marker = scene.timeline_markers.new("Cut", frame=1)
    marker.camera = scene.objects["side 1"]
    scene.render.image_settings.file_format = "PNG"
    path = scene.render.filepath = f"{tmp_path}/{output}"
    scene.camera = scene.objects["Front"]
    assert bpy.ops.fovea.render_cameras() == {"FINISHED"}
    assert names_in(tmp_path) == sorted(expected or [f"{name}.png" for name in FILES])
    pictures = [pixels_of(tmp_path / name) for name in names_in(tmp_path)]
    assert all(np.abs(a - b).max() > 0.3 for a, b in zip(pictures, pictures[1:]))
    assert (scene.camera.name, marker.camera.name, scene.render.filepath) == ("Front", "side 1", path)


def test_the_operator_writes_files_of_any_format_into_new_folders_and_from_templates(scene, tmp_path):
    scene.render.image_settings.file_format = "JPEG"
    scene.render.use_multiview = True
    template = "{scene_name}" if bpy.app.version >= (5, 0, 0) else scene.name
    scene.render.filepath = f"{tmp_path}/new/{template}"
    assert bpy.ops.fovea.render_cameras() == {"FINISHED"}
    expected = [f"{scene.name}_{name}_{eye}.jpg" for name in FILES for eye in "LR"]
    assert sorted(path.name for path in (tmp_path / "new").iterdir()) == sorted(expected)


@pytest.mark.parametrize("kind, suffix", [("PNG", ".png"), ("JPEG", "")])
def test_the_operator_says_what_a_full_disk_did_not_take_and_leaves_what_was_there(tmp_path, kind, suffix):
    script, before = tmp_path / "script.py", tmp_path / "out" / "box_Camera.png"
    before.parent.mkdir()
    before.write_text("of an earlier run")
    script.write_text(
        "import sys, bpy\n"
        f"sys.path.insert(0, {str(Path(__file__).parent)!r})\n"
        "from pictures import box_scene\n"
        "scene = box_scene()\n"
        f"scene.render.filepath = {str(before.with_name('box'))!r}\n"
        f"scene.render.image_settings.file_format = {kind!r}\n"
        "bpy.ops.fovea.render_cameras()\n"
    )
    done = in_blender_without_room(["-P", str(script)])
    assert done.returncode == 1 and f"box_Camera{suffix} could not be written (File too large)" in done.stderr
    assert list(before.parent.iterdir()) == [before] and before.read_text() == "of an earlier run"


def test_a_place_that_takes_no_files_is_named_by_the_operator(scene):
    scene.render.filepath = "/proc/box"
    with pytest.raises(RuntimeError, match="/proc"):
        bpy.ops.fovea.render_cameras()
    assert scene.render.filepath == "/proc/box"


def test_without_cameras_the_operator_says_so(scene):
    for camera in cameras.of(scene):
        bpy.data.objects.remove(camera)
    assert not bpy.ops.fovea.render_cameras.poll()
