# SPDX-License-Identifier: GPL-3.0-or-later
"""A GPU is tried once before it draws: one that draws otherwise than the CPU draws nothing, and that is said."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from pictures import box_scene, drawn
from the_addon import part

gpu_check, session, stage_labels = part("render.gpu_check"), part("render.session"), part("render.stage_labels")


@pytest.fixture(autouse=True)
def untried():
    """No GPU has been tried, before the test and after it."""
    gpu_check.forget()
    session.forget()
    yield
    gpu_check.forget()


def backend_class():
    return part("gpu.backend").Backend  # imported late: not every Blender that runs the other tests has a GPU


def altered(monkeypatch, method, change):
    """What a method of the gpu backend gives is changed, in the array that it is written to."""
    right = getattr(backend_class(), method)

    def wrong(*given):
        array = right(*given)
        array[...] = change(array)
        return array

    monkeypatch.setattr(backend_class(), method, wrong)


def failing(_result):
    raise RuntimeError("the compiler gave up\nat line 4")


SEEN = "% of the pixels differ"
WRONG = {
    "nothing is drawn": ("draw", np.zeros_like, SEEN),
    "the picture is upside down": ("draw", lambda image: image[::-1].copy(), SEEN),
    "the picture is a pixel off": ("draw", lambda image: np.roll(image, 1, axis=0), SEEN),
    "lines are paler": ("draw", lambda image: 0.8 * image, SEEN),
    "a pixel is no number": ("draw", lambda image: image * np.where(np.arange(4) == 3, np.nan, 1), "are no numbers"),
    "all is visible": ("visibility", np.ones_like, SEEN),
    "nothing is visible": ("visibility", np.zeros_like, SEEN),
    "nothing crowds": ("elide", lambda crowding: crowding * (0, 1), SEEN),
    "a program does not compile": ("draw", failing, "RuntimeError: the compiler gave up"),
}
METHODS = ["exact", "atlas", "spine", "item_buffer"]


@pytest.mark.gpu
@pytest.mark.parametrize("method", METHODS)
def test_a_gpu_that_draws_as_the_cpu_does_is_trusted(method):
    assert gpu_check.note(backend_class(), method) == ""
    (line,) = gpu_check.lines()
    assert f"with visibility {method} it draws as the CPU does, tried in" in line and "driver" in line


@pytest.mark.gpu
@pytest.mark.parametrize("case", WRONG)
def test_a_gpu_that_draws_otherwise_is_not(case, monkeypatch):
    part_of_it, change, why = WRONG[case]
    altered(monkeypatch, part_of_it, change)
    assert gpu_check.note(backend_class(), "atlas") == gpu_check.NOTE
    (line,) = gpu_check.lines()
    assert "it draws otherwise than the CPU, which draws instead: " in line and why in line and "\n" not in line


@pytest.mark.gpu
def test_a_gpu_is_tried_once_for_each_method():
    made = []
    for method in 3 * METHODS[:2]:
        assert gpu_check.note(lambda: made.append(backend_class()()) or made[-1], method) == ""
    assert len(made) == 2


@pytest.mark.gpu
def test_another_gpu_is_tried_on_its_own(monkeypatch):
    assert gpu_check.note(backend_class(), "exact") == ""
    monkeypatch.setattr(gpu_check.device, "description", lambda: "another one")
    altered(monkeypatch, "draw", np.zeros_like)
    assert gpu_check.note(backend_class(), "exact") == gpu_check.NOTE
    assert len(list(gpu_check.lines())) == 2


@pytest.mark.gpu
@pytest.mark.parametrize("is_right", [True, False])
def test_a_viewport_of_a_wrong_gpu_is_exact_and_the_cpus(is_right, monkeypatch):
    methods = part("render.methods")
    monkeypatch.setattr(methods.gpu_context, "available", lambda: True)
    monkeypatch.setattr(methods.gpu_viewport, "is_software", lambda: False)
    if not is_right:
        altered(monkeypatch, "draw", np.zeros_like)
    engine = SimpleNamespace(backend=None, report=lambda *_: None)
    for _ in range(2):
        settings = SimpleNamespace(backend="AUTO", visibility="AUTO")
        backend, method = methods.choose(engine, settings, in_viewport=True)
        assert (backend.name, method) == (("gpu", "atlas") if is_right else ("cpu", "exact"))
        assert engine.backend is backend and engine.note == ("" if is_right else gpu_check.NOTE)


@pytest.fixture
def scene():
    if part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    return box_scene()


def test_a_frame_of_a_wrong_gpu_is_the_cpus_and_says_so(scene, tmp_path, monkeypatch):
    by_cpu = drawn(scene, tmp_path / "cpu.png")
    altered(monkeypatch, "draw", np.zeros_like)
    said, shown = [], []
    monkeypatch.setattr(session, "report_once", lambda _engine, remark: said.append(remark))
    monkeypatch.setattr(session.stage_labels, "show", lambda engine, text="": shown.append((text, engine.note)))
    scene.fovea.backend = "GPU"
    for _ in range(2):
        assert np.array_equal(drawn(scene, tmp_path / "gpu.png"), by_cpu)
        assert session.last_statistics()["backend"] == "cpu"
    assert said.count(gpu_check.NOTE) == 2
    assert shown and all(note == gpu_check.NOTE for _, note in shown)
    bpy.ops.fovea.report()
    report = bpy.data.texts["Fovea Report"].as_string()
    assert "draws otherwise than the CPU, which draws instead" in report and "by the cpu" in report


def test_a_frame_of_a_right_gpu_is_the_same_whether_it_was_tried_or_not(scene, tmp_path):
    scene.fovea.backend = "GPU"
    first, second = (drawn(scene, tmp_path / f"{name}.png") for name in ("first", "second"))
    assert session.last_statistics()["backend"] == "gpu"
    assert np.array_equal(first, second)


def test_the_header_of_a_picture_has_the_note_beside_the_stage_and_after_it():
    shown = []
    engine = SimpleNamespace(note="the GPU is wrong", update_stats=lambda *words: shown.append(words))
    stage_labels.show(engine, "Strokes")
    stage_labels.show(engine)
    engine.note = ""
    stage_labels.show(engine, "Strokes")
    stage_labels.show(engine)
    assert shown == [
        ("Fovea", "Strokes | the GPU is wrong"),
        ("Fovea", "the GPU is wrong"),
        ("Fovea", "Strokes"),
        ("", ""),
    ]
