# SPDX-License-Identifier: GPL-3.0-or-later
"""The camera that `fovea draw` adds for a model sees all of it and is as near as the margin allows."""

import math
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest
from bare import STRANDS, bare_curve, emitter, hair_curves, point_cloud
from bpy_extras.object_utils import world_to_camera_view
from mathutils import Vector
from the_addon import box_mesh, empty_scene, new_mesh, new_object

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import framing


def framed(scene, azimuth=35.0, elevation=25.0, lens=50.0, margin=0.05):
    """Where the visible points lie in the frame: (n, 3), the frame is [0, 1], depth in the last column."""
    framing.frame(scene, azimuth, elevation, lens, margin)
    bpy.context.view_layer.update()
    points = framing.visible_points(bpy.context.evaluated_depsgraph_get())
    return np.array([world_to_camera_view(scene, scene.camera, Vector(point)) for point in points])


@pytest.mark.parametrize("size", [(1920, 1080), (600, 900)])
@pytest.mark.parametrize("azimuth, elevation", [(35, 25), (-120, 80), (0, 0)])
def test_all_is_seen_and_the_margin_is_met(size, azimuth, elevation):
    scene = empty_scene()
    scene.render.resolution_x, scene.render.resolution_y = size
    new_object(box_mesh(2.0), location=(100, -3, 7))
    new_object(box_mesh(0.5), location=(103, 1, 4))
    seen = framed(scene, azimuth, elevation)
    low, high = seen[:, :2].min(axis=0), seen[:, :2].max(axis=0)
    tight = min(range(2), key=lambda axis: low[axis])
    assert low[tight] == pytest.approx(0.05, abs=1e-4) and high[tight] == pytest.approx(0.95, abs=1e-4)
    assert (low >= 0.05 - 1e-4).all() and (high <= 0.95 + 1e-4).all()
    camera = scene.camera.data
    assert (seen[:, 2] > camera.clip_start).all() and (seen[:, 2] < camera.clip_end).all()


def test_the_view_is_from_the_front_left_and_above():
    scene = empty_scene()
    new_object(box_mesh())
    framed(scene)
    assert scene.camera.location.x < 0 and scene.camera.location.y < 0 and scene.camera.location.z > 0
    assert math.degrees(math.atan2(-scene.camera.location.x, -scene.camera.location.y)) == pytest.approx(35, abs=3)


def test_only_what_renders_is_framed():
    scene = empty_scene()
    new_object(box_mesh())
    new_object(box_mesh(), location=(50, 0, 0)).hide_render = True
    near = framed(scene)[:, 2].max()
    assert near < 20


@pytest.mark.parametrize("place", [(1e30, 0, 0), (50, -50, 50), (float("nan"), 0, 0)])
def test_a_vertex_that_nothing_is_drawn_of_is_not_framed(place):
    scene = empty_scene()
    box = box_mesh()
    vertices = [tuple(v.co) for v in box.vertices]
    polygons = [tuple(p.vertices) for p in box.polygons]
    new_object(box)
    expected = framed(scene)
    scene = empty_scene()
    new_object(new_mesh([*vertices, place], [], polygons))
    np.testing.assert_array_equal(framed(scene), expected)


def test_a_face_with_a_broken_vertex_is_not_framed():
    scene = empty_scene()
    box = box_mesh()
    vertices, polygons = [tuple(v.co) for v in box.vertices], [tuple(p.vertices) for p in box.polygons]
    new_object(box)
    expected = framed(scene)
    scene = empty_scene()
    broken = new_mesh([*vertices, (0, 0, 0), (0, 0, 1)], [], [*polygons, (0, 8, 9)])
    broken.vertices[8].co = (float("nan"), 0, 0)
    new_object(broken)
    np.testing.assert_array_equal(framed(scene), expected)


def test_nothing_to_frame_is_said():
    scene = empty_scene()
    new_object(new_mesh([], [], []))
    with pytest.raises(ValueError, match="nothing to frame"):
        framing.frame(scene, 35, 25, 50, 0.05)


def bounds():
    bpy.context.view_layer.update()
    points = framing.visible_points(bpy.context.evaluated_depsgraph_get())
    return points.min(axis=0), points.max(axis=0)


BARE = {  # what has no faces -> how it is made, and the corners of its box
    "a curve": (lambda: bare_curve([(0, 0, 0), (1, 2, 3)]), (0, 0, 0), (1, 2, 3)),
    "hair": (lambda: new_object(hair_curves(STRANDS, radius=0.25)), (-0.25, -0.25, -0.25), (1.25, 0.75, 2.25)),
    "points": (lambda: point_cloud([(0, 0, 0), (0, 3, 0)], 0.5), (-0.5, -0.5, -0.5), (0.5, 3.5, 0.5)),
}


@pytest.mark.parametrize("make, low, high", BARE.values(), ids=BARE.keys())
def test_what_has_no_faces_is_framed(make, low, high):
    scene = empty_scene()
    obj = make()
    np.testing.assert_allclose(bounds(), (low, high), atol=1e-6)
    obj.location = (10, 0, 0)
    np.testing.assert_allclose(bounds(), np.add((low, high), (10, 0, 0)), atol=1e-6)
    seen = framed(scene)
    assert (seen[:, :2] >= 0.05 - 1e-4).all() and (seen[:, :2] <= 0.95 + 1e-4).all()


def test_hair_of_particles_is_framed_though_its_emitter_is_not_seen():
    empty_scene()
    obj = emitter(hair_length=4.0)
    obj.show_instancer_for_render = obj.show_instancer_for_viewport = False
    assert bounds()[1][2] > 1.0


def test_a_curve_that_others_use_is_not_framed():
    empty_scene()
    new_object(box_mesh())
    path = bare_curve([(0, 0, 0), (50, 0, 0)], "Path")
    np.testing.assert_allclose(bounds()[1], (50, 1, 1))
    new_object(None, "Follower").constraints.new("FOLLOW_PATH").target = path
    np.testing.assert_allclose(bounds()[1], (1, 1, 1))


def test_an_excluded_object_is_not_framed():
    empty_scene()
    new_object(box_mesh())
    new_object(box_mesh(), location=(50, 0, 0)).fovea.usage = "IGNORE"
    np.testing.assert_allclose(bounds()[1], (1, 1, 1))
