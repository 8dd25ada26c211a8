# SPDX-License-Identifier: GPL-3.0-or-later
"""Cameras: a View projects points to where Blender projects them."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from bpy_extras.object_utils import world_to_camera_view
from mathutils import Euler, Matrix, Vector
from the_addon import add_camera, empty_scene, new_object, part

camera = part("scene.camera")
CannotDraw = part("scene.problem").CannotDraw


@pytest.fixture(autouse=True)
def fresh_scene():
    empty_scene()


def engine_of(scene):
    """What a render engine knows of its job."""
    percentage = scene.render.resolution_percentage / 100
    return SimpleNamespace(
        resolution_x=int(scene.render.resolution_x * percentage),
        resolution_y=int(scene.render.resolution_y * percentage),
        camera_override=None,
        camera_model_matrix=lambda obj, use_spherical_stereo: obj.matrix_world.normalized(),
        camera_shift_x=lambda obj, use_spherical_stereo: obj.data.shift_x,
    )


def rendered_view():
    return camera.of_render(engine_of(bpy.context.scene), bpy.context.evaluated_depsgraph_get())


def to_pixels(view, points):
    """(n, 2) pixels of (n, 3) world points."""
    clip = np.c_[points, np.ones(len(points))] @ (view.view_to_clip @ view.world_to_view).T
    return (clip[:, :2] / clip[:, 3:] * 0.5 + 0.5) * (view.width, view.height)


def random_camera(rng):
    """A camera with everything that can be set set at random."""
    scene, obj = bpy.context.scene, add_camera()
    obj.matrix_world = Matrix.LocRotScale(
        Vector(rng.uniform(-3, 3, 3)), Euler(rng.uniform(-3, 3, 3)), Vector(rng.uniform(0.5, 2, 3))
    )
    data = obj.data
    data.type = rng.choice(["PERSP", "ORTHO"])
    data.lens, data.ortho_scale = rng.uniform(15, 120), rng.uniform(2, 12)
    data.sensor_fit = rng.choice(["AUTO", "HORIZONTAL", "VERTICAL"])
    data.sensor_width, data.sensor_height = rng.uniform(10, 50, 2)
    data.shift_x, data.shift_y = rng.uniform(-0.5, 0.5, 2)
    render = scene.render
    # Multiples of 4, so that every percentage keeps the frame's proportions.
    render.resolution_x, render.resolution_y = (4 * int(n) for n in rng.integers(10, 500, 2))
    render.resolution_percentage = int(rng.choice([100, 50, 25]))
    render.pixel_aspect_x, render.pixel_aspect_y = rng.choice([(1, 1), (1, 2), (1.5, 1)])
    return obj


def points_in_front(obj, rng):
    """World points before a camera, in and out of its frame."""
    local = np.c_[rng.uniform(-3, 3, (50, 2)), -rng.uniform(1, 20, 50), np.ones(50)]
    return (local @ np.array(obj.matrix_world.normalized()).T)[:, :3]


@pytest.mark.parametrize("seed", range(40))
def test_projection_is_blenders(seed):
    rng = np.random.default_rng(seed)
    obj, scene = random_camera(rng), bpy.context.scene
    bpy.context.view_layer.update()
    view = rendered_view()
    points = points_in_front(obj, rng)
    blender = np.array([world_to_camera_view(scene, obj, Vector(point)) for point in points])
    # Blender computes in single precision.
    tolerance = 2e-3 + 1e-5 * max(view.width, view.height)
    assert np.abs(to_pixels(view, points) - blender[:, :2] * (view.width, view.height)).max() < tolerance
    depth = -(np.c_[points, np.ones(50)] @ view.world_to_view.T)[:, 2]
    assert np.allclose(depth, blender[:, 2], atol=1e-4)
    assert view.orthographic == (obj.data.type == "ORTHO")


@pytest.mark.parametrize("seed", range(10))
def test_a_border_crops_the_full_frame(seed):
    rng = np.random.default_rng(seed)
    obj, render = random_camera(rng), bpy.context.scene.render
    bpy.context.view_layer.update()
    full = rendered_view()
    render.use_border = True
    left, right = np.sort(rng.uniform(0, 1, 2))
    bottom, top = np.sort(rng.uniform(0, 1, 2))
    render.border_min_x, render.border_max_x = left, min(right + 0.1, 1)
    render.border_min_y, render.border_max_y = bottom, min(top + 0.1, 1)
    crop = rendered_view()
    points = points_in_front(obj, rng)
    corner = (int(np.float32(render.border_min_x) * full.width), int(np.float32(render.border_min_y) * full.height))
    assert np.allclose(to_pixels(crop, points) + corner, to_pixels(full, points), atol=1e-6 * full.width)
    assert crop.reference_scale == full.reference_scale


def test_clip_distances_and_scale_of_reference_pixels():
    obj = add_camera()
    obj.data.clip_start, obj.data.clip_end = 0.5, 50
    bpy.context.scene.render.resolution_y = 2160
    bpy.context.scene.render.resolution_percentage = 25
    view = rendered_view()
    assert (view.near_clip, view.far_clip, view.reference_scale) == (0.5, 50, 0.5)


def test_no_camera():
    with pytest.raises(CannotDraw, match="no camera"):
        rendered_view()


def test_panoramic_camera():
    add_camera().data.type = "PANO"
    with pytest.raises(CannotDraw, match="panoramic"):
        rendered_view()


ANY = {  # objects that are no cameras, and the lens that Blender gives them, for its sensor of 36 mm
    "an Empty": (lambda: None, 35.0),
    "a mesh": (lambda: bpy.data.meshes.new("Any"), 35.0),
    "a spot light": (lambda: bpy.data.lights.new("Any", "SPOT"), 16.0 / np.tan(np.pi / 8)),
}


@pytest.mark.parametrize("kind", ANY)
def test_any_object_may_be_the_camera(kind):
    make, lens = ANY[kind]
    like = add_camera()
    like.data.lens, like.data.sensor_width = lens, 36.0
    like.data.clip_start, like.data.clip_end = 0.1, 100.0
    bpy.context.view_layer.update()
    wanted = rendered_view()
    other = new_object(make(), "Any")
    other.matrix_world = like.matrix_world
    bpy.context.scene.camera = other
    bpy.context.view_layer.update()
    view = rendered_view()
    assert np.allclose(view.view_to_clip, wanted.view_to_clip, atol=1e-6)
    assert np.allclose(view.world_to_view, wanted.world_to_view, atol=1e-6)
    assert (view.near_clip, view.far_clip, view.orthographic) == pytest.approx((0.1, 100.0, False))


def test_a_viewport_sees_from_any_object_as_far_as_viewports_do():
    scene, depsgraph = bpy.context.scene, bpy.context.evaluated_depsgraph_get()
    scene.camera = new_object(None, "Empty")
    bpy.context.view_layer.update()
    full = scene.camera.calc_matrix_camera(depsgraph, x=400, y=300)
    view = camera.of_region(viewport(full, perspective="CAMERA"), depsgraph)
    assert (view.near_clip, view.far_clip) == (0.1, 100.0) and not view.orthographic


def test_places_in_the_frame_are_blenders():
    obj, scene = random_camera(np.random.default_rng(0)), bpy.context.scene
    bpy.context.view_layer.update()
    for point in points_in_front(obj, np.random.default_rng(1)):
        place = camera.in_frame(bpy.context.evaluated_depsgraph_get(), point)
        assert np.allclose(place, world_to_camera_view(scene, obj, Vector(point))[:2], atol=1e-4)


UNUSABLE = {
    "clips all": (
        lambda obj: setattr(obj.data, "clip_end", 0.05),
        "'Camera' sees from a distance of 0.1 up to one of 0.05",
    ),
    "clips all but a plane": (
        lambda obj: setattr(obj.data, "clip_start", 1000),
        "set its Clip Start below its Clip End",
    ),
    "scaled to 0": (lambda obj: setattr(obj, "scale", (0, 1, 1)), "'Camera' looks in no direction"),
    "far away": (lambda obj: setattr(obj, "location", (0, 1e30, 0)), "'Camera' is nowhere: .* beyond 1e"),
    "no number": (lambda obj: setattr(obj, "rotation_euler", (0, np.nan, 0)), "'Camera' is nowhere: .* not a number"),
    "shifted away": (lambda obj: setattr(obj.data, "shift_x", 1e30), "'Camera' shows nothing"),
}


@pytest.mark.parametrize("case", UNUSABLE)
@pytest.mark.parametrize("where", ["render", "viewport"])
def test_a_camera_that_sees_nothing_is_named(case, where):
    spoil, words = UNUSABLE[case]
    spoil(add_camera())
    bpy.context.view_layer.update()
    with pytest.raises(CannotDraw, match=words):
        if where == "render":
            rendered_view()
        else:
            camera.of_region(viewport(Matrix(), perspective="CAMERA"), bpy.context.evaluated_depsgraph_get())


def viewport(projection, *, perspective, width=400, height=300):
    """A 3D viewport's context, as far as the camera asks for it."""
    world_to_view = Matrix.LocRotScale(Vector((0.3, -0.2, -6)), Euler((0.4, 0.2, 0.1)), None)
    return SimpleNamespace(
        region=SimpleNamespace(width=width, height=height),
        region_data=SimpleNamespace(view_matrix=world_to_view, window_matrix=projection, view_perspective=perspective),
        space_data=SimpleNamespace(clip_start=0.1, clip_end=100.0, camera=None),
    )


def test_orthographic_viewport_sees_behind_its_eye():
    # Blender's: clips from -100 to 100.
    projection = Matrix(((0.2, 0, 0, 0), (0, 0.25, 0, 0), (0, 0, -0.01, 0), (0, 0, 0, 1)))
    context = viewport(projection, perspective="ORTHO")
    view = camera.of_region(context, bpy.context.evaluated_depsgraph_get())
    points = np.random.default_rng(0).uniform(-4, 4, (30, 3))
    direct = np.array([projection @ context.region_data.view_matrix @ Vector((*p, 1)) for p in points])
    assert np.allclose(to_pixels(view, points), (direct[:, :2] * 0.5 + 0.5) * (400, 300), atol=1e-3)
    assert view.orthographic and 0 < view.near_clip < 1
    depth = -(np.c_[points, np.ones(30)] @ view.world_to_view.T)[:, 2]
    assert np.allclose((depth - view.near_clip) / (view.far_clip - view.near_clip), direct[:, 2] * 0.5 + 0.5, atol=1e-5)


def test_reference_pixels_of_a_viewport_are_those_of_the_camera_frame():
    obj = add_camera()
    render = bpy.context.scene.render
    depsgraph = bpy.context.evaluated_depsgraph_get()
    full = obj.calc_matrix_camera(depsgraph, x=render.resolution_x, y=render.resolution_y)
    half = Matrix.Diagonal((0.5, 0.5, 1, 1)) @ full
    view = camera.of_region(viewport(half, perspective="CAMERA", height=1080), depsgraph)
    assert np.isclose(view.reference_scale, 0.5)
