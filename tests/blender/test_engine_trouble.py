# SPDX-License-Identifier: GPL-3.0-or-later
"""The render engine on errors: the messages, and that no file is written."""

import math
import os
import subprocess
import time
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from pictures import box_scene, drawn, ink, pixels_of
from the_addon import fovea, new_object, part

native = part("native")
session = part("render.session")


@pytest.fixture
def scene():
    return box_scene()


ERRORS = {
    "no camera": (lambda scene: bpy.data.objects.remove(scene.camera), "no camera"),
    "panoramic": (lambda scene: setattr(scene.camera.data, "type", "PANO"), "panoramic"),
    "clips all": (lambda scene: setattr(scene.camera.data, "clip_end", 0.05), "set its Clip Start below its Clip End"),
    "scaled to 0": (lambda scene: setattr(scene.camera, "scale", (1, 0, 1)), "clear its scale"),
    "far away": (lambda scene: setattr(scene.camera, "location", (1e30, 0, 0)), "'Camera' is nowhere: its location"),
    "no number": (lambda scene: setattr(scene.camera, "location", (math.nan, 0, 0)), "is not a number"),
    "empty": (lambda scene: bpy.data.objects.remove(bpy.data.objects["Box"]), "empty"),
}


@pytest.mark.parametrize("case", ERRORS)
def test_what_cannot_be_drawn_is_said_and_writes_no_file(scene, tmp_path, case, caplog):
    spoil, words = ERRORS[case]
    spoil(scene)
    with pytest.raises(RuntimeError, match=f"(?i){words}"):
        drawn(scene, tmp_path / "none.png")
    assert not (tmp_path / "none.png").exists()
    assert not caplog.records


def test_a_missing_native_module_is_said(scene, tmp_path, monkeypatch):
    def missing():
        raise native.Unavailable("the native module is missing")

    monkeypatch.setattr(native, "load", missing)
    with pytest.raises(RuntimeError, match="native module is missing"):
        drawn(scene, tmp_path / "none.png")


def test_what_the_core_refuses_is_said_in_its_sentence_alone(scene, tmp_path, monkeypatch, caplog):
    unseeing = part("stages").View(np.zeros((4, 4)), np.eye(4), 160, 90, True, 0.1, 10.0)
    monkeypatch.setattr(session.camera, "of_render", lambda *_arguments: unseeing)
    with pytest.raises(RuntimeError, match="^Error: camera: it looks in no direction; reset its location"):
        drawn(scene, tmp_path / "none.png")
    assert not (tmp_path / "none.png").exists() and not caplog.records


def test_any_other_failure_is_said_too(scene, tmp_path, monkeypatch, caplog):
    def broken(*_arguments, **_options):
        raise ValueError("ink ran out")

    monkeypatch.setattr(session.pipeline, "draw", broken)
    with pytest.raises(RuntimeError, match="ValueError: ink ran out"):
        drawn(scene, tmp_path / "none.png")
    assert not (tmp_path / "none.png").exists()
    assert "ink ran out" in caplog.text


def test_too_little_memory_is_said_in_one_sentence(scene, tmp_path, monkeypatch, caplog):
    def too_much(*_arguments, **_options):
        raise MemoryError("std::bad_alloc")

    monkeypatch.setattr(session.pipeline, "draw", too_much)
    with pytest.raises(RuntimeError, match="Memory is too small for a picture of 160 x 90 pixels: make it smaller"):
        drawn(scene, tmp_path / "none.png")
    assert not (tmp_path / "none.png").exists() and not caplog.records


def test_a_scene_is_drawn_from_an_empty_that_is_its_camera(scene, tmp_path):
    like = scene.camera
    like.data.lens, like.data.sensor_width = 35.0, 36.0
    wanted = drawn(scene, tmp_path / "camera.png")
    scene.camera = new_object(None, "Empty")
    scene.camera.matrix_world = like.matrix_world
    assert np.abs(drawn(scene, tmp_path / "empty.png") - wanted).max() < 0.02 and ink(wanted).max() > 0.9


def test_a_scene_whose_objects_are_all_hidden_is_blank_paper(scene, tmp_path):
    bpy.data.objects["Box"].hide_render = True
    assert (drawn(scene, tmp_path / "blank.png") == 1).all()


def test_a_scene_of_grease_pencil_alone_is_paper_for_blender_to_draw_on(scene, tmp_path):
    bpy.data.objects.remove(bpy.data.objects["Box"])
    with pytest.raises(RuntimeError, match="The scene is empty"):
        drawn(scene, tmp_path / "none.png")
    bpy.ops.object.grease_pencil_add(type="EMPTY")
    assert (drawn(scene, tmp_path / "blank.png") == 1).all()


def test_nan_vertices_are_left_out(scene, tmp_path):
    bpy.data.objects["Box"].data.vertices[0].co.x = math.nan
    picture = drawn(scene, tmp_path / "broken.png")
    assert ink(picture).max() > 0.9


def test_what_was_left_out_is_said_once():
    said = []
    engine = SimpleNamespace(report=lambda kind, message: said.append((kind, message)))
    report = SimpleNamespace(
        **dict.fromkeys(part("scene.surfaces").REMARKS, 0) | {"degenerate_polygons": 3, "non_finite_vertices": 1}
    )
    session.report_skipped(engine, [SimpleNamespace(name="Box", report=report)])
    ((kind, message),) = said
    assert kind == {"INFO"} and "'Box'" in message and "3 faces have no area" in message and "loose" not in message


class StoppedEngine:
    """An engine whose user pressed Escape."""

    backend = None

    def __init__(self):
        self.asked = 0

    def test_break(self):
        self.asked += 1
        return True

    def report(self, kind, message):
        raise AssertionError(message)

    def update_progress(self, share):
        pass

    update_stats = report


def test_cancel_reaches_what_runs_natively():
    cancel = native.load().Cancel()
    engine = StoppedEngine()
    with session.watched(engine, cancel):
        for _ in range(100):
            if cancel.requested:
                break
            time.sleep(0.02)
    assert cancel.requested and engine.asked == 1


def test_a_stopped_render_gives_no_picture(scene, monkeypatch):
    def stopped(*_arguments, cancel, **_options):
        raise native.load().Cancelled("cancelled")

    monkeypatch.setattr(session.pipeline, "draw", stopped)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    view = part("stages").View(np.eye(4), np.eye(4), 4, 4, True, 0.1, 10.0)
    monkeypatch.setattr(session.camera, "of_render", lambda *_arguments: view)
    assert session.final_image(StoppedEngine(), depsgraph) is None


def in_child(tmp_path, scene, environment):
    """Exit code, output and picture of `blender -b` that renders the scene's file."""
    blend, out = tmp_path / "scene.blend", tmp_path / "child_"
    scene.render.image_settings.file_format = "PNG"
    bpy.ops.wm.save_as_mainfile(filepath=str(blend))
    command = [bpy.app.binary_path, "-b", "--factory-startup", "--addons", fovea.__name__, str(blend)]
    command += ["-E", "FOVEA", "-o", str(out), "-f", "1"]
    kept = {key: value for key, value in os.environ.items() if not key.startswith("FOVEA_GL")}
    done = subprocess.run(command, env={**kept, **environment}, capture_output=True, text=True, timeout=300)
    return done.returncode, done.stdout + done.stderr, tmp_path / "child_0001.png"


def test_background_render_without_a_camera_fails(scene, tmp_path):
    bpy.data.objects.remove(scene.camera)
    code, output, picture = in_child(tmp_path, scene, {})
    assert code != 0 and not picture.exists()
    assert "no camera" in output and "Traceback" not in output


def test_background_render_without_opengl_uses_the_cpu(scene, tmp_path):
    scene.fovea.backend = "GPU"
    code, output, picture = in_child(tmp_path, scene, {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent"})
    assert code == 0, output
    assert ink(pixels_of(picture)).max() > 0.9
