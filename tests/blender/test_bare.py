# SPDX-License-Identifier: GPL-3.0-or-later
"""Point clouds, bare curves, loose edges, colors of what has no faces, and what the report says of all of them."""

import math

import bpy
import numpy as np
import pytest
from bare import STRANDS, bare_curve, hair_curves, node_modifier, point_cloud, read, shown, told
from pictures import box_scene, drawn
from scenes import hair as hair_scene
from scenes import stage
from snapshots import fresh_scene
from the_addon import add_camera, box_mesh, new_mesh, new_object, part, use_style

api = part("scene.api")
pytestmark = pytest.mark.usefixtures(fresh_scene.__name__)


def test_a_point_cloud_has_spheres_of_its_radius():
    point_cloud([(0, 0, 0), (0, 3, 0)], 0.5)
    snapshot = read()
    assert snapshot.objects == ["Points"] and shown(snapshot) == [{"contour", "silhouette"}]
    first = np.array(snapshot.surfaces[0].positions)
    first = first[first[:, 1] < 1.5]
    assert np.abs(np.linalg.norm(first, axis=1) - 0.5).max() < 0.001
    assert len(first) == len(snapshot.surfaces[0].positions) / 2


@pytest.mark.parametrize("name", part("style").names())
def test_a_point_cloud_has_outlines_in_every_style(name):
    scene_ = box_scene()
    bpy.data.objects.remove(bpy.data.objects["Box"])
    point_cloud([(0, 0, 0)], 1)
    use_style(scene_, name)
    bpy.ops.render.render()
    assert part("render.session").last_statistics()["strokes"]


def test_point_clouds_are_instanced():
    obj = new_object(new_mesh([(0, 0, 0), (4, 0, 0)], [], [], "Points"), "Points")
    points, _ = node_modifier(obj, "GeometryNodeMeshToPoints", "GeometryNodeInstanceOnPoints")
    tree = points.id_data
    tree.links.new(points.outputs[0], tree.nodes["Instance on Points"].inputs["Instance"])
    snapshot = read()
    assert snapshot.surface_of_placement.tolist() == [0, 0]
    assert snapshot.object_to_world[:, 0, 3].tolist() == [0, 4]


def test_a_bare_curve_is_one_path_with_its_points():
    points = [(0, 0, 0), (1, 0, 0.2), (2, 0, 0.1), (3, 0, 0.5)]
    bare_curve(points)
    add_camera((1.5, -8, 0), (1.5, 0, 0))
    bpy.context.view_layer.update()
    found = api.lines("border")
    assert found["offsets"].tolist() == [0, 4] and found["object"].tolist() == ["Curve"]
    assert np.allclose(found["points"], points) or np.allclose(found["points"][::-1], points)


def test_text_without_a_fill_and_loose_edges_are_lines():
    text = bpy.data.curves.new("Text", "FONT")
    text.body, text.fill_mode = "Fovea", "NONE"
    new_object(text, "Text")
    new_object(new_mesh([(0, 0, 0), (1, 0, 0)], [(0, 1)], [], "Wire"), "Wire")
    add_camera()
    bpy.context.view_layer.update()
    assert set(api.lines("border")["object"]) == {"Text", "Wire"} and not told()


def test_curves_that_others_use_are_not_drawn_and_parents_are():
    path, parent = bare_curve(STRANDS[0], "Path"), bare_curve(STRANDS[0], "Parent")
    profile = bare_curve([(0, 0, 0), (0.2, 0, 0), (0.2, 0.1, 0)], "Profile")
    follower = new_object(box_mesh(), "Follower")
    follower.constraints.new("FOLLOW_PATH").target = path
    bare_curve(STRANDS[0], "Rail").data.bevel_mode = "OBJECT"
    bpy.data.objects["Rail"].data.bevel_object = profile
    new_object(box_mesh(), "Child").parent = parent
    assert set(read().objects) == {"Follower", "Rail", "Child", "Parent"}
    assert set(told()) == {"Path", "Profile"} and "other objects or nodes use" in told()["Path"]


def test_curves_beside_what_else_geometry_nodes_make_are_named():
    obj = new_object(box_mesh(), "Box")
    node_modifier(obj, "GeometryNodeMeshToCurve")
    assert read().objects == [] and "Curve to Mesh" in told()["Box"]


def test_hair_and_points_are_colored_by_their_material(tmp_path):
    scene_ = box_scene()
    bpy.data.objects.remove(bpy.data.objects["Box"])
    scene_.camera.location, scene_.camera.rotation_euler = (0, -8, 0), (math.pi / 2, 0, 0)
    use_style(scene_, "watercolor")
    red = stage.material("Red", (0.8, 0.02, 0.02))
    hair, points = hair_curves([[(-1, 0, -1), (-1, 0, 1)]], radius=0.6), point_cloud([(1.5, 0, 0)], 1.0)
    (set_material,) = node_modifier(points, "GeometryNodeSetMaterial")
    set_material.inputs["Material"].default_value = red
    hair.materials.append(red)
    new_object(hair, "Hair")
    picture = drawn(scene_, tmp_path / "red.png")
    for x in (-1.0, 1.5):  # in the middle of both
        column = round(80 + x / 8 * 80 / (18 / 50))
        spot = picture[42:48, column - 3 : column + 3, :3].mean(axis=(0, 1))
        assert spot[0] > 1.5 * spot[1], (x, spot)


def test_metaballs_of_a_family_are_one_and_what_never_has_lines_says_why():
    for x in (0.0, 1.0):
        ball = bpy.data.metaballs.new("Ball")
        ball.elements.new()
        new_object(ball, "Ball", (x, 0, 0))
    hair_scene.ring((0, 0, 0))
    new_object(bpy.data.lattices.new("Cage"), "Cage")
    new_object(bpy.data.volumes.new("Smoke"), "Smoke")
    image = new_object(None, "Image")
    image.empty_display_type, image.data = "IMAGE", bpy.data.images.new("Image", 4, 4)
    new_object(None, "Empty")
    assert read().objects == ["Ball"]
    said = told()
    assert set(said) == {"Ball.001", "Ring", "Cage", "Smoke", "Image"}
    assert said["Ball.001"] == "is drawn as one with the metaball 'Ball'"
    assert "Blender draws over the picture" in said["Ring"] and "Volume to Mesh" in said["Smoke"]
    assert "not rendered" in said["Cage"] and "viewports alone" in said["Image"]


def test_blender_draws_grease_pencil_over_the_picture(tmp_path):
    """As the report says: also where it lies behind a box."""
    scene_ = box_scene()
    scene_.camera.location, scene_.camera.rotation_euler = (0, -10, 0), (math.pi / 2, 0, 0)
    bpy.data.objects["Box"].location = (0, -6, 0)
    hair_scene.ring((0, 0, 0))
    bpy.data.objects["Ring"].rotation_euler = (math.pi / 2, 0, 0)

    def red(name):
        picture = drawn(scene_, tmp_path / name)
        return (picture[..., 0] - picture[..., 1] > 0.2).sum()

    assert red("over.png") > 100
    bpy.data.objects["Ring"].hide_render = True
    assert not red("without.png")
