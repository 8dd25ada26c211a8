# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture that `fovea draw` reports is complete: truncation by a full disk is detected, and the previous file
stays."""

import sys
from pathlib import Path

import bpy
import numpy as np
import pytest
from pictures import box_scene, in_blender_without_room, pixels_of
from the_addon import part

SCRIPTS = Path(__file__).parents[2] / "blender_scripts"
sys.path.insert(0, str(SCRIPTS))

import picture

whole = part("render.whole_pictures")
FORMATS = {".png": "PNG", ".exr": "OPEN_EXR"}


@pytest.fixture(scope="module", params=FORMATS)
def noise(request, tmp_path_factory):
    """A picture's file, of noise, and its bytes."""
    scene, path = bpy.context.scene, tmp_path_factory.mktemp("noise") / f"noise{request.param}"
    image = bpy.data.images.new("Noise", 60, 40, float_buffer=True)
    image.pixels.foreach_set(np.random.default_rng(0).random(60 * 40 * 4, np.float32))
    scene.render.image_settings.file_format = FORMATS[request.param]
    image.save_render(str(path), scene=scene)
    return path, path.read_bytes()


def test_a_written_picture_is_whole(noise):
    path, data = noise
    path.write_bytes(data)
    assert whole.is_whole(path)


@pytest.mark.parametrize("missing", [1, 4, 12, 13, 100, 0.1, 0.5, 0.9, 0.999, 1.0])
def test_a_picture_that_breaks_off_is_not_whole(noise, missing):
    path, data = noise
    path.write_bytes(data[: len(data) - (missing if isinstance(missing, int) else round(missing * len(data)))])
    assert not whole.is_whole(path)


def test_a_picture_with_a_hole_is_not_whole(noise):
    path, data = noise
    third = len(data) // 3
    path.write_bytes(data[:third] + bytes(third) + data[2 * third :])
    assert not whole.is_whole(path)


@pytest.mark.parametrize("kind", ["JPEG", "OPEN_EXR_MULTILAYER", "TIFF", "WEBP", "BMP"])
def test_pictures_of_other_formats_are_whole_or_break_off(tmp_path, kind):
    render = box_scene().render
    if "media_type" in render.image_settings.bl_rna.properties:
        render.image_settings.media_type = "MULTI_LAYER_IMAGE" if "LAYER" in kind else "IMAGE"
    render.image_settings.file_format, render.filepath = kind, str(tmp_path / "box")
    bpy.ops.render.render(write_still=True)
    (path,) = tmp_path.iterdir()
    assert whole.is_whole(path)
    data = path.read_bytes()
    for kept in (0, 100, len(data) // 2, len(data) - 100):
        path.write_bytes(data[:kept])
        assert not whole.is_whole(path), kept


def test_a_missing_picture_is_not_whole(tmp_path):
    assert not whole.is_whole(tmp_path / "none.png")


@pytest.mark.parametrize("name", ["a{b}c", "50%#"])
def test_folders_may_have_any_name(tmp_path, name):
    scene, path = box_scene(), tmp_path / name / "box.png"
    path.parent.mkdir()
    picture.render(scene, path)
    assert pixels_of(path).shape[:2] == (90, 160)


def test_what_keeps_a_scene_from_being_drawn_is_said_as_it_is(tmp_path):
    scene = box_scene()
    bpy.data.objects.remove(scene.camera)
    with pytest.raises(ValueError, match="camera"):
        picture.render(scene, tmp_path / "none.png")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("suffix", FORMATS)
def test_a_full_disk_is_said_and_leaves_what_was_there(tmp_path, suffix):
    before = tmp_path / f"x_0001{suffix}"
    before.write_text("of an earlier run")
    words = ["-P", SCRIPTS / "draw.py", "--", "boxes:3", "--size", "480x270", "--frames", "1-2"]
    done = in_blender_without_room([*words, "-o", tmp_path / f"x{suffix}"])
    (said,) = [line for line in done.stderr.splitlines() if line.startswith("fovea: ")]
    assert done.returncode == 1 and f"{before} could not be written (File too large)" in said
    assert "fovea wrote" not in done.stdout
    assert list(tmp_path.iterdir()) == [before] and before.read_text() == "of an earlier run"
