# SPDX-License-Identifier: GPL-3.0-or-later
"""Image-space lines in whole renders: both definitions, both backends."""

import math

import bpy
import numpy as np
import pytest
from native_frames import ball, box, core, exact_samples, frame_of, moved, scene_of, style, view_of
from pictures import box_scene, drawn, ink
from the_addon import only_lines, part

DEFINITIONS = ("image_edge", "abstracted_shading")


def disc_scene(name):
    """A ball before an orthographic camera: 36 pixels across, in the middle of the picture."""
    scene = box_scene()
    bpy.data.objects.remove(bpy.data.objects["Box"])
    bpy.ops.mesh.primitive_uv_sphere_add(segments=128, ring_count=64, radius=1.0)
    camera = scene.camera
    camera.data.type, camera.data.ortho_scale = "ORTHO", 160 / 18
    camera.location, camera.rotation_euler = (0, -10, 0), (math.pi / 2, 0, 0)
    only_lines(scene, name)
    return scene


@pytest.mark.parametrize("backend", ["CPU", "GPU"])
@pytest.mark.parametrize("visibility", ["EXACT", "ATLAS"])
@pytest.mark.parametrize("name", DEFINITIONS)
def test_a_ball_is_drawn_as_a_ring(name, visibility, backend, tmp_path):
    if backend == "GPU" and part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    scene = disc_scene(name)
    scene.fovea.visibility, scene.fovea.backend = visibility, backend
    picture = ink(drawn(scene, tmp_path / "ring.png"))
    y, x = np.nonzero(picture > 0.5)
    radius = np.hypot(x + 0.5 - 80, y + 0.5 - 45)
    # Half the pen's 30 reference pixels are 1.25 pixels here; the rim's valley lies a little inside the outline.
    assert radius.min() > 18 - 2.5 and radius.max() < 18 + 2
    angles = np.floor(np.arctan2(y + 0.5 - 45, x + 0.5 - 80) / (2 * math.pi) * 60)
    assert len(np.unique(angles)) == 60  # all around
    assert part("render.session").last_statistics()["strokes"] >= 1


@pytest.mark.parametrize("name", DEFINITIONS)
def test_half_the_percentage_is_the_same_drawing(name, tmp_path):
    scene = disc_scene(name)
    full = ink(drawn(scene, tmp_path / "full.png"))
    scene.render.resolution_percentage = 50
    half = ink(drawn(scene, tmp_path / "half.png"))
    assert np.abs(half - full.reshape(45, 2, 80, 2).mean(axis=(1, 3))).mean() < 0.02
    assert half.max() > 0.5


@pytest.mark.gpu
@pytest.mark.parametrize("orthographic", [False, True])
def test_nothing_hides_them_on_either_backend(orthographic):
    scene = scene_of([(box(), moved((0, 0, 0))), (ball(), moved((1.2, -1.5, 0.3), scale=0.8))])
    kinds = {name: {} for name in DEFINITIONS}
    lines = style.Style(line_sets=(style.LineSet(kinds=kinds),))
    view = view_of(orthographic=orthographic)
    frame = frame_of(scene, view, lines)
    assert frame.clipped.samples > 200 and (frame.paths.placement == 0xFFFFFFFF).all()
    for backend in (part("gpu.backend").Backend(), core.CpuBackend()):
        np.testing.assert_array_equal(backend.visibility(frame), 1.0)
    np.testing.assert_allclose(exact_samples(scene, view, lines), 1.0, atol=1e-5)
