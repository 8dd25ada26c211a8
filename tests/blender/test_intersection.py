# SPDX-License-Identifier: GPL-3.0-or-later
"""Intersection lines in pictures, where objects pass through each other, on both backends."""

import bpy
import numpy as np
import pytest
from native_frames import exact_samples, frame_of, room, style, view_of
from pictures import SIZE, drawn, ink
from test_gpu_visibility import both
from the_addon import add_camera, box_mesh, empty_scene, lines_of, new_mesh, new_object, only_lines, use_style


def only(scene, *names):
    only_lines(scene, *names)


@pytest.fixture
def scene():
    """A box stands half above a square sheet; seen straight from above, four units across."""
    scene = empty_scene()
    new_object(box_mesh(0.5), "Box")
    sheet = new_mesh([(-9, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0)], [], [(0, 1, 2, 3)], "Sheet")
    new_object(sheet, "Sheet")
    camera = add_camera((0, 0, 10), (0, 0, 0))
    camera.rotation_euler = (0, 0, 0)
    camera.data.type, camera.data.ortho_scale = "ORTHO", 4.0
    scene.render.engine, scene.render.resolution_x, scene.render.resolution_y = "FOVEA", *SIZE
    scene.render.dither_intensity = 0.0
    scene.view_settings.view_transform = "Standard"
    use_style(scene, "technical")
    scene.fovea.backend, lines_of(scene).pen.width = "CPU", 30.0
    only(scene, "intersection")
    return scene


def test_a_box_in_a_sheet_is_outlined_on_it(scene, tmp_path):
    # From a slant: two of the four sides are seen, and no crease is drawn.
    scene.camera.location, scene.camera.rotation_euler = (6, -6, 8.5), (0.7854, 0, 0.7854)
    both_sides = ink(drawn(scene, tmp_path / "in.png"))
    assert 0.005 < (both_sides > 0.9).mean() < 0.1
    only(scene, "crease")
    creases = ink(drawn(scene, tmp_path / "creases.png"))
    only(scene, "crease", "intersection")
    all_lines = ink(drawn(scene, tmp_path / "all.png"))
    assert np.abs(all_lines - np.maximum(creases, both_sides)).mean() < 0.01
    # The upper creases alone are seen without it, and with it there is more than either.
    assert (all_lines > 0.9).sum() > 1.1 * (creases > 0.9).sum()


def test_a_box_on_a_sheet_has_none(scene, tmp_path):
    bpy.data.objects["Box"].location.z = 0.5
    assert ink(drawn(scene, tmp_path / "on.png")).max() == 0


def test_it_moves_with_the_box(scene, tmp_path):
    box = bpy.data.objects["Box"]
    box.rotation_euler.x = 0.7  # so that it is seen beside the box from above
    first = ink(drawn(scene, tmp_path / "first.png"))
    again = ink(drawn(scene, tmp_path / "again.png"))
    box.location.x = 1
    moved = ink(drawn(scene, tmp_path / "moved.png"))
    assert first.max() > 0.9
    np.testing.assert_array_equal(first, again)
    np.testing.assert_allclose(moved[:, 40:], first[:, :-40], atol=0.02)


@pytest.mark.gpu
@pytest.mark.parametrize("orthographic", [False, True])
def test_sampled_visibility(orthographic):
    lines = style.Style(line_sets=(style.LineSet(kinds={"intersection": {}}),))
    view = view_of(960, 600, orthographic)
    frame = frame_of(room(), view, lines)
    on_gpu, on_cpu = both(frame)
    exact = exact_samples(room(), view, lines)
    assert 0.05 < np.mean(exact) < 0.5
    assert np.mean(on_gpu == on_cpu) > 0.999
    assert np.mean((on_gpu >= 0.5) == (exact >= 0.5)) > 0.97
