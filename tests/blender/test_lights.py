# SPDX-License-Identifier: GPL-3.0-or-later
"""Lights as they are read, and the lines that they make."""

import math

import bpy
import numpy as np
import pytest
from the_addon import add_camera, box_mesh, empty_scene, new_object, part

api, scenes, surfaces, native = part("scene.api"), part("scene.scene"), part("scene.surfaces"), part("native")


@pytest.fixture(autouse=True)
def floating_cube():
    """A cube of 2 m whose middle is 3 m above a floor."""
    empty_scene()
    add_camera()
    new_object(box_mesh(1.0), "Cube", (0, 0, 3))
    bpy.ops.mesh.primitive_plane_add(size=40)


def add_light(kind, place=(0, 0, 0), turn=(0, 0, 0)):
    light = new_object(bpy.data.lights.new(kind.title(), kind), kind.title(), place)
    light.rotation_euler = turn
    return light


def depsgraph():
    bpy.context.view_layer.update()
    return bpy.context.evaluated_depsgraph_get()


def read():
    """The Lamps of the scene, by kind."""
    snapshot = scenes.gather(depsgraph(), surfaces.SurfaceCache(native.load()))
    return {lamp.kind: lamp for lamp in snapshot.lights}


def shadows(definition="cast_shadow"):
    return api.lines(definition, depsgraph=depsgraph())


def length(found):
    """Of all lines, in meters."""
    steps = np.linalg.norm(np.diff(found["points"], axis=0), axis=1)
    steps[found["offsets"][1:-1] - 1] = 0
    return steps.sum()


def test_lights_are_read_in_world_space():
    add_light("SUN", turn=(0, math.pi / 2, 0))
    add_light("POINT", (1, 2, 3))
    spot = add_light("SPOT", (0, 0, 9))
    spot.data.spot_size, spot.data.use_shadow = math.pi / 3, False
    area = add_light("AREA", (4, 0, 9), (0, math.pi / 2, 0))
    area.data.shape, area.data.size, area.data.size_y, area.scale = "RECTANGLE", 2, 6, (3, 1, 1)
    found = read()
    assert found["sun"].direction == pytest.approx((-1, 0, 0), abs=1e-6)
    assert found["point"].position == pytest.approx((1, 2, 3)) and found["point"].casts
    assert found["spot"].cos_outer == pytest.approx(math.cos(math.pi / 6)) and not found["spot"].casts
    assert found["area"].half_x == pytest.approx((0, 0, -3), abs=1e-6)
    assert found["area"].half_y == pytest.approx((0, 3, 0), abs=1e-6)
    assert len({lamp.id for lamp in found.values()}) == 4


def test_lights_have_the_size_that_makes_their_shadows_soft():
    add_light("SUN").data.angle = 0.2
    add_light("POINT").data.shadow_soft_size = 0.3
    found = read()
    assert found["sun"].radius == pytest.approx(math.tan(0.1)) and found["point"].radius == pytest.approx(0.3)


def test_the_shadow_of_a_cube_in_the_sun_is_a_square():
    sun = add_light("SUN")
    found = shadows()
    assert found["closed"].tolist() == [True] and set(found["object"].tolist()) == {"Plane"}
    assert length(found) == pytest.approx(8, abs=1e-3)
    sun.rotation_euler = (0.5, 0, 0)
    moved = shadows()
    assert length(moved) > 9 and moved["closed"].tolist() == [True]


@pytest.mark.parametrize("hide", ["use_shadow", "hide_viewport", "energy"])
def test_a_light_that_casts_none_has_no_lines(hide):
    sun = add_light("SUN")
    setattr(sun if hide == "hide_viewport" else sun.data, hide, hide == "hide_viewport")
    assert not len(shadows()["points"]) and not len(shadows("light_contour")["points"])


def test_a_lamp_shines_from_where_it_is():
    add_light("POINT", (0, 0, 8)).data.energy = 100
    assert length(shadows()) == pytest.approx(16, abs=1e-3)  # twice as large: the top is half way to the floor


def test_each_instance_of_a_light_has_lines_of_its_own():
    lamps = bpy.data.collections.new("Lamps")
    lamps.objects.link(bpy.data.objects.new("Lamp", bpy.data.lights.new("Lamp", "POINT")))
    for x in (-3, 3):
        instance = new_object(None, f"Lamps {x}", (x, 0, 12))
        instance.instance_type, instance.instance_collection = "COLLECTION", lamps
    found = shadows()
    assert found["closed"].tolist() == [True, True] and len(set(found["path_id"].tolist())) == 2
