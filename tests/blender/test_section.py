# SPDX-License-Identifier: GPL-3.0-or-later
"""Section planes, drawings to scale and pens in ISO widths, as scenes have them."""

import math
import re
import xml.etree.ElementTree as ElementTree

import bpy
import numpy as np
import pytest
from the_addon import empty_scene, own_style, part, use_style

api, drawing_scale, native = part("scene.api"), part("render.drawing_scale"), part("native")
section, vectors, problem = part("scene.section"), part("render.vectors"), part("scene.problem")


@pytest.fixture
def scene():
    """A cube of 2 m around the origin, seen from above without perspective."""
    scene = empty_scene()
    bpy.ops.mesh.primitive_cube_add()
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.location, camera.data.type, camera.data.ortho_scale = (0, 0, 8), "ORTHO", 6
    scene.collection.objects.link(camera)
    scene.camera, scene.render.engine = camera, "FOVEA"
    scene.render.resolution_x, scene.render.resolution_y = 600, 400
    use_style(scene, "plan")
    return scene


def plane(scene, at=(0, 0, 0), turn=(0, 0, 0)):
    """An Empty as the scene's section plane."""
    empty = bpy.data.objects.new("Cut", None)
    empty.location, empty.rotation_euler = at, turn
    scene.collection.objects.link(empty)
    scene.fovea.section = empty
    return empty


def depsgraph():
    bpy.context.view_layer.update()
    return bpy.context.evaluated_depsgraph_get()


def svg(scene, **asked):
    return vectors.drawing(bpy.context, "svg", vectors.options(**asked)).file().decode()


def corners_of(text):
    """(n, 2) corners of the filled section in an SVG, in millimeters."""
    (fill,) = (path for path in ElementTree.fromstring(text).iter() if path.get("id") == "section-fill")
    steps = []
    for letter, numbers in re.findall(r"([Mlhv])([^A-Za-z]*)", fill.get("d")):
        found = np.array(re.findall(r"-?(?:\d+\.?\d*|\.\d+)", numbers), float)
        alone = {"h": np.multiply.outer(found, (1, 0)), "v": np.multiply.outer(found, (0, 1))}
        steps.append(alone[letter] if letter in alone else found.reshape(-1, 2))
    return np.concatenate(steps).cumsum(axis=0)


def test_the_plane_is_the_local_xy_plane_of_an_object_and_cuts_its_plus_z_side(scene):
    assert section.plane_of(depsgraph()) is None
    empty = plane(scene, (1, 2, 3))
    assert section.plane_of(depsgraph()) == pytest.approx((0, 0, 1, -3))
    empty.rotation_euler = (0, math.pi / 2, 0)
    assert section.plane_of(depsgraph()) == pytest.approx((1, 0, 0, -1), abs=1e-6)
    empty.scale = (-2, 3, 4)
    assert section.plane_of(depsgraph()) == pytest.approx((1, 0, 0, -1), abs=1e-6)


def test_a_plane_that_is_scaled_to_nothing_is_told_by_its_name(scene):
    plane(scene).scale = (0, 0, 0)
    with pytest.raises(problem.CannotDraw, match="'Cut' has no direction.*clear its scale"):
        section.plane_of(depsgraph())


def test_the_cut_of_a_cube_is_a_square_that_is_filled_and_to_scale(scene):
    assert "section-fill" not in svg(scene)
    plane(scene)
    scene.fovea.drawing_scale = 50
    for sheet in ({}, {"sheet": "a3", "to_scale": True}):
        text = svg(scene, **sheet)
        assert 'data-line-set="section"' in text
        assert np.ptp(corners_of(text), axis=0) == pytest.approx((40, 40), abs=1.1e-3)  # files have micrometers
    assert np.ptp(corners_of(svg(scene, sheet="a3")), axis=0) != pytest.approx((40, 40), abs=1)
    with pytest.raises(native.Refused, match="to scale the picture is 315 x 210 mm"):
        svg(scene, sheet="a5", to_scale=True)


def test_the_filled_cut_ends_where_the_picture_does(scene):
    plane(scene)
    scene.camera.data.ortho_scale, scene.camera.location.x = 3, 1  # 315 x 210 mm for 3 x 2 m, from a half to five
    corners = corners_of(svg(scene))
    assert np.ptp(corners, axis=0) == pytest.approx((157.5, 210), abs=2e-3)
    assert corners.min(axis=0) == pytest.approx((0, 0), abs=2e-3)


def test_a_mesh_that_stands_for_the_plane_is_not_drawn(scene):
    bpy.ops.mesh.primitive_plane_add(size=10)
    assert len(api.lines("border", depsgraph=depsgraph())["points"])
    scene.fovea.section = bpy.context.object
    assert not len(api.lines("border", depsgraph=depsgraph())["points"])
    found = api.lines("section_cut", depsgraph=depsgraph())["points"]
    assert np.abs(found[:, 2]).max() < 1e-5 and np.ptp(found, axis=0)[:2] == pytest.approx((2, 2))


def test_the_scale_is_shown_and_set_and_a_meter_at_1_to_50_is_20_mm(scene):
    assert drawing_scale.scale_of(scene) == pytest.approx(1000 * 4 / 210)
    scene.fovea.drawing_scale = 50
    assert scene.fovea.drawing_scale == pytest.approx(50, rel=1e-6)
    assert scene.camera.data.ortho_scale == pytest.approx(6 * 50 / (4000 / 210), rel=1e-6)
    scene.unit_settings.scale_length = 0.01  # a unit is a centimeter
    assert scene.fovea.drawing_scale == pytest.approx(0.5, rel=1e-6)


def test_without_an_orthographic_camera_there_is_no_scale(scene):
    scene.camera.data.type = "PERSP"
    assert scene.fovea.drawing_scale == 0
    scene.fovea.drawing_scale = 50
    assert scene.fovea.drawing_scale == 0
    with pytest.raises(ValueError, match="'Camera' is not orthographic"):
        drawing_scale.fit_page(scene, 50)


def test_a_sheet_gives_the_page_its_height_and_the_picture_its_proportions_and_keeps_the_scale(scene):
    scene.fovea.drawing_scale = 50
    assert bpy.ops.fovea.sheet(sheet="a3", margin=10.0) == {"FINISHED"}
    assert own_style(scene).paper.height_mm == pytest.approx(277)
    assert scene.render.resolution_x / scene.render.resolution_y == pytest.approx(400 / 277, abs=2e-3)
    assert scene.fovea.drawing_scale == pytest.approx(50, rel=1e-5)
    with pytest.raises(RuntimeError, match="leaves no room"):
        bpy.ops.fovea.sheet(sheet="a5", margin=80.0)


def test_a_pen_gets_a_width_of_technical_pens(scene):
    held = own_style(scene)
    pen = held.line_sets[0].pen
    assert bpy.ops.fovea.pen_width(pen=pen.path_from_id(), width="0.7") == {"FINISHED"}
    assert (pen.width_unit, pen.width) == ("MILLIMETRES", pytest.approx(0.7))
