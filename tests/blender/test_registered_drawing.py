# SPDX-License-Identifier: GPL-3.0-or-later
"""Scans of drawings brought to where a scene's lines are, in Blender."""

from contextlib import contextmanager

import bpy
import numpy as np
import pytest
from the_addon import part

comparison, native = part("comparison"), part("native")
register_operators = part("render.register_operators")
SIZE = 480, 360
SCALE = 1.5  # pixels of the scan per pixel of the frame


@pytest.fixture
def bottle():
    """A monkey and a cube before a camera: nothing about them is symmetric."""
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.mesh.primitive_monkey_add(location=(-0.6, 0, 0))
    bpy.ops.mesh.primitive_cube_add(size=0.9, location=(1.3, 0, -0.4), rotation=(0.4, 0.2, 0.5))
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.location, camera.rotation_euler = (0.2, -7, 0.4), (np.radians(87), 0, 0)
    scene = bpy.context.scene
    scene.collection.objects.link(camera)
    scene.camera, scene.render.engine = camera, "FOVEA"
    scene.render.resolution_x, scene.render.resolution_y = SIZE
    return scene


def lines_of(scene):
    lines = register_operators.lines_of_render(bpy.context)
    assert lines.size == SIZE
    return lines.bitmap(SIZE)


def scan_of(bitmap, turn=4.0):
    """(H, W, 3) of lines in red on yellowish paper, larger, turned by some degrees and moved."""
    angle = np.radians(turn)
    c, s = np.cos(angle) / SCALE, np.sin(angle) / SCALE
    to_frame = np.array([[c, -s, 10.0], [s, c, -30.0], [0, 0, 1]])
    ink = native.load().GrayImage((255 * (1 - bitmap.pixels)).astype(np.uint8))
    width, height = (int(SCALE * side) + 40 for side in SIZE)
    share = 1 - ink.resampled(to_frame, width, height).values[..., None] / 255
    return np.rint((1 - share) * (250, 245, 225) + share * (200, 20, 20)).astype(np.uint8)


def saved(path, picture):
    path.write_bytes(native.load().png_bytes(picture))
    return path


def test_a_scan_is_registered_beside_it_and_shown_behind_the_camera(bottle, tmp_path):
    lines = lines_of(bottle)
    path = saved(tmp_path / "scan.png", scan_of(lines))
    with pytest.raises(ValueError, match="pixels"):
        comparison.of_drawings([comparison.read(path), comparison.Drawing("a", SIZE, lambda _: lines)])
    assert bpy.ops.fovea.register_drawing(filepath=str(path), tolerance=2.0) == {"FINISHED"}
    made = tmp_path / "scan_registered.png"
    assert sorted(file.name for file in tmp_path.iterdir()) == ["scan.png", "scan_registered.png"]
    assert comparison.read(made).size == SIZE
    found = lines.measures(comparison.read(made).bitmap(SIZE), 1.5)
    assert found["precision"] > 0.98 and found["recall"] > 0.98
    color = native.load().pixels_of_png(made.read_bytes())[lines.pixels > 0].mean(axis=0)
    assert color[0] > 1.2 * color[1], "ink stays red"
    (shown,) = bottle.camera.data.background_images
    assert bottle.camera.data.show_background_images and shown.show_background_image
    assert bpy.path.abspath(shown.image.filepath) == str(made) and shown.display_depth == "BACK"
    assert tuple(shown.image.size) == SIZE and shown.frame_method == "STRETCH"


def test_registering_again_keeps_one_picture_and_reads_it_anew(bottle, tmp_path):
    lines = lines_of(bottle)
    path = saved(tmp_path / "scan.png", scan_of(lines))
    other = bottle.camera.data.background_images.new()
    bpy.ops.fovea.register_drawing(filepath=str(path), tolerance=2.0)
    first = (tmp_path / "scan_registered.png").read_bytes()
    saved(path, scan_of(lines, turn=-3.0))
    bpy.ops.fovea.register_drawing(filepath=str(path), tolerance=2.0)
    assert (tmp_path / "scan_registered.png").read_bytes() != first
    assert len(bottle.camera.data.background_images) == 2 and other.image is None


def test_a_registration_that_is_canceled_writes_nothing(bottle, tmp_path, monkeypatch):
    path = saved(tmp_path / "scan.png", scan_of(lines_of(bottle)))
    session, register, cancels = part("render.session"), comparison.registered_png, []

    @contextmanager
    def watched(_engine, cancel):
        cancels.append(cancel)
        yield

    def canceled(*words):
        cancels[-1].cancel()  # as the thread does that sees the escape key, once lines are drawn
        return register(*words)

    monkeypatch.setattr(session, "watched", watched)
    monkeypatch.setattr(comparison, "registered_png", canceled)
    with pytest.raises(RuntimeError, match="Stopped before it was done: nothing has changed"):
        bpy.ops.fovea.register_drawing(filepath=str(path), tolerance=2.0)
    assert [file.name for file in tmp_path.iterdir()] == ["scan.png"]
    assert not len(bottle.camera.data.background_images)


def test_the_registration_of_lines_itself_stops_when_it_is_canceled(bottle):
    core, lines = native.load(), lines_of(bottle)
    cancel = core.Cancel()
    cancel.cancel()
    with pytest.raises(core.Cancelled), cancel:
        lines.registration(lines, 2.0)
    assert lines.registration(lines, 2.0)["outer_share"] == 1.0


def test_a_scan_says_how_large_its_paper_is(bottle, tmp_path):
    path = saved(tmp_path / "scan.png", scan_of(lines_of(bottle)))
    how = {"filepath": str(path), "unit": "MILLIMETERS", "tolerance": 1.0}
    with pytest.raises(RuntimeError, match="name its width with Paper Width"):
        bpy.ops.fovea.register_drawing(**how)
    assert not (tmp_path / "scan_registered.png").exists()
    assert bpy.ops.fovea.register_drawing(**how, paper_width=200.0) == {"FINISHED"}
    with pytest.raises(RuntimeError, match="Register one drawing after the other"):
        bpy.ops.fovea.register_drawing(directory=str(tmp_path), files=[{"name": "a.png"}, {"name": "b.png"}])


def test_what_cannot_be_registered_is_refused_and_writes_nothing(bottle, tmp_path):
    other = native.load().Bitmap(np.zeros(SIZE[::-1], np.uint8))
    rows = other.pixels.copy()
    rows[20::40, 30:-200] = 1
    path = saved(tmp_path / "other.png", scan_of(native.load().Bitmap(rows)))
    with pytest.raises(RuntimeError, match="other could not be registered"):
        bpy.ops.fovea.register_drawing(filepath=str(path))
    with pytest.raises(RuntimeError, match="the marks of a prompt sheet are not found"):
        bpy.ops.fovea.register_drawing(filepath=str(path), register_by="MARKS")
    (tmp_path / "a.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>')
    with pytest.raises(RuntimeError, match="a.svg is no scan: a PNG is registered"):
        bpy.ops.fovea.register_drawing(filepath=str(tmp_path / "a.svg"))
    assert sorted(file.name for file in tmp_path.iterdir()) == ["a.svg", "other.png"]
    assert not len(bottle.camera.data.background_images)
