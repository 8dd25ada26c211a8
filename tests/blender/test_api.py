# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripting API returns the documented arrays, in world space, for shapes whose lines are known."""

import bpy
import numpy as np
import pytest
from the_addon import add_camera, box_mesh, empty_scene, new_object, part

api = part("scene.api")


@pytest.fixture
def box():
    empty_scene()
    add_camera()
    return new_object(box_mesh(), "Box", location=(1, 2, 3))


def ends(found):
    """Points at which polylines begin or end or bend, rounded."""
    return {tuple(point) for point in np.round(found["points"], 4).tolist()}


def corners(center, half=1.0):
    return {
        tuple(np.add(center, (x, y, z)).tolist()) for x in (-half, half) for y in (-half, half) for z in (-half, half)
    }


def test_a_surface_is_the_evaluated_mesh(box):
    box.modifiers.new("Subdivide", "SUBSURF").subdivision_type = "SIMPLE"
    surface = api.surface(box)
    assert surface.positions.shape == (26, 3) and surface.triangles.shape == (48, 3)
    assert api.surfaces().keys() == {"Box"}


def test_an_object_without_a_surface_is_named(box):
    with pytest.raises(ValueError, match="'Camera' has no surface"):
        api.surface(bpy.context.scene.camera)


def test_the_curvature_of_a_sphere():
    empty_scene()
    bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, radius=2.0)
    found = api.fields(bpy.context.object)
    assert np.allclose(np.abs(found["k1"]), 0.5, atol=0.02) and np.allclose(np.abs(found["k2"]), 0.5, atol=0.02)
    radial = api.surface(bpy.context.object).positions / 2.0
    assert ((radial * found["normal"]).sum(axis=1) > 0.99).all()


def test_creases_of_a_box_lie_at_its_corners_in_the_world(box):
    found = api.lines("crease", corner_angle=10.0)
    assert len(found["closed"]) == 12 and ends(found) == corners((1, 2, 3))
    assert set(found["object"]) == {"Box"}


def test_uneven_scale_and_instances_are_in_the_world(box):
    box.scale = (2, 1, 1)
    other = new_object(box.data, "Other", location=(-4, 0, 0))
    found = api.lines("crease", [other], corner_angle=10.0)
    assert ends(found) == corners((-4, 0, 0)) and set(found["object"]) == {"Other"}
    width = np.ptp(api.lines("crease", [box])["points"][:, 0])
    assert width == pytest.approx(4.0)


def test_visible_runs_are_those_in_front(box):
    box.location = (0, 0, 0)
    seen = api.lines("crease", visible=True, corner_angle=10.0)
    assert len(seen["closed"]) == 9 and (seen["invisibility"] == 0).all()
    both = api.lines("crease", hidden=True, corner_angle=10.0)
    assert len(both["closed"]) == 12 and sorted(both["invisibility"])[-3:] == [1, 1, 1]
    # Where the camera sees them, they are.
    size = [bpy.context.scene.render.resolution_x, bpy.context.scene.render.resolution_y]
    assert (seen["px"] >= 0).all() and (seen["px"] <= size).all()


def test_others_hide_but_have_no_lines(box):
    box.location = (0, 0, 0)
    wall = new_object(box_mesh(3.0), "Wall", location=(2.5, -3.5, 2.0))
    assert len(api.lines("crease", [box], visible=True)["closed"]) == 0
    wall.hide_render = wall.hide_viewport = True
    bpy.context.view_layer.update()
    assert set(api.lines("crease", [box], visible=True)["object"]) == {"Box"}


def test_parameters_are_those_of_the_registry(box):
    assert len(api.lines("crease", angle=91.0)["closed"]) == 0
    with pytest.raises(ValueError, match="angel"):
        api.lines("crease", angel=91.0)
    with pytest.raises(ValueError, match="nonsense"):
        api.lines("nonsense")


def test_what_cannot_be_done_is_told(box):
    bpy.context.scene.camera = None
    with pytest.raises(part("scene.problem").CannotDraw, match="no camera"):
        api.lines("crease")
    empty_scene()
    with pytest.raises(part("scene.problem").CannotDraw, match="empty"):
        api.surfaces()
