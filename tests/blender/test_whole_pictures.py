# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture that `fovea draw` reports is complete: truncation by a full disk is detected, and the previous file
stays."""

import resource
import signal
import subprocess
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest
from pictures import box_scene, pixels_of
from the_addon import fovea

SCRIPTS = Path(__file__).parents[2] / "blender_scripts"
sys.path.insert(0, str(SCRIPTS))

import picture

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
    assert picture.is_whole(path)


@pytest.mark.parametrize("missing", [1, 4, 12, 13, 100, 0.1, 0.5, 0.9, 0.999, 1.0])
def test_a_picture_that_breaks_off_is_not_whole(noise, missing):
    path, data = noise
    path.write_bytes(data[: len(data) - (missing if isinstance(missing, int) else round(missing * len(data)))])
    assert not picture.is_whole(path)


def test_a_picture_with_a_hole_is_not_whole(noise):
    path, data = noise
    third = len(data) // 3
    path.write_bytes(data[:third] + bytes(third) + data[2 * third :])
    assert not picture.is_whole(path)


def test_a_missing_picture_is_not_whole(tmp_path):
    assert not picture.is_whole(tmp_path / "none.png")


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
    words = [bpy.app.binary_path, "-b", "--factory-startup", "--addons", fovea.__name__, "--python-exit-code", "1"]
    words += ["-P", SCRIPTS / "draw.py", "--", "boxes:3", "--size", "480x270", "--frames", "1-2"]
    words += ["-o", tmp_path / f"x{suffix}"]
    done = subprocess.run(words, capture_output=True, text=True, preexec_fn=no_room, restore_signals=False)
    (said,) = [line for line in done.stderr.splitlines() if line.startswith("fovea: ")]
    assert done.returncode == 1 and f"{before} could not be written" in said
    assert list(tmp_path.iterdir()) == [before] and before.read_text() == "of an earlier run"


def no_room():
    """Writing more than 2 kB to a file fails from now on, as on a full disk."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2048, 2048))
