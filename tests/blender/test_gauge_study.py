# SPDX-License-Identifier: GPL-3.0-or-later
"""Places and true normals of gauge studies, on a ball before a wall, and the pictures that are drawn of it."""

import sys
from pathlib import Path

import bmesh
import bpy
import numpy as np
import pytest
from mathutils import Vector
from the_addon import add_camera, empty_scene, new_object

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import picture
import study
from command import draw_options
from gauges import formulas, strings

SIZE = 256, 192


@pytest.fixture
def scene():
    """A smooth ball of radius 1, three units before a wall; seen from the front."""
    scene = empty_scene()
    for name, make in (
        ("Ball", lambda mesh: bmesh.ops.create_icosphere(mesh, subdivisions=5, radius=1)),
        ("Wall", lambda mesh: bmesh.ops.create_cube(mesh, size=1)),
    ):
        made, mesh = bmesh.new(), bpy.data.meshes.new(name)
        make(made)
        for face in made.faces:
            face.smooth = name == "Ball"
        made.to_mesh(mesh)
        new_object(mesh, name, (0, 0, 0) if name == "Ball" else (0, 3.5, 0))
    bpy.data.objects["Wall"].scale = (9, 1, 5)
    add_camera((0, -8, 0), (0, 0, 0))
    scene.render.engine, scene.render.resolution_x, scene.render.resolution_y = "FOVEA", *SIZE
    scene.render.resolution_percentage = 100
    bpy.context.view_layer.update()
    return scene


def hit(scene, gauge):
    """(place of the ball's surface in the world, or None) that a gauge is drawn over."""
    camera = scene.camera
    corners = [camera.matrix_world @ corner for corner in camera.data.view_frame(scene=scene)]
    right, up, lower_left = corners[0] - corners[3], corners[0] - corners[1], corners[2]
    at = lower_left + right * (gauge["x"] / SIZE[0]) + up * (1 - gauge["y"] / SIZE[1])
    eye = camera.matrix_world.translation
    along = (at - eye).normalized()
    b, c = eye.dot(along), eye.dot(eye) - 1
    return eye + along * (-b - np.sqrt(b * b - c)) if b * b > c else None


def test_normals_are_those_of_what_is_seen_there(scene):
    found = study.gauges(scene, 60, 0)["gauges"]
    on_ball = [gauge for gauge in found if gauge["object"] == "Ball"]
    on_wall = [gauge for gauge in found if gauge["object"] == "Wall"]
    assert len(on_ball) > 5 and len(on_wall) > 5 and len(found) == 60
    for gauge in on_wall:
        assert hit(scene, gauge) is None
        assert gauge["n"] == pytest.approx((0, 0, 1), abs=1e-3), "parallel to the picture"
    turned = scene.camera.matrix_world.to_3x3().transposed()
    for gauge in on_ball:
        normal = turned @ Vector(hit(scene, gauge))
        # Perspective turns gauges by some degrees at most, away from the middle of the picture.
        assert formulas.angles(np.array(gauge["n"]), np.array(normal)) < 12
        assert np.linalg.norm(gauge["n"]) == pytest.approx(1)
    assert scene.render.resolution_x == SIZE[0]


def test_no_gauge_is_near_the_outline(scene):
    clear = study.CLEAR * SIZE[1] / 768
    for gauge in study.gauges(scene, 60, 0)["gauges"]:
        sides = [hit(scene, gauge | {"x": gauge["x"] + dx, "y": gauge["y"] + dy}) is None
                 for dx, dy in ((clear, 0), (-clear, 0), (0, clear), (0, -clear))]  # fmt: skip
        assert len(set(sides)) == 1


def test_places_are_the_same_each_time_and_others_with_another_seed(scene):
    first, again, other = (study.gauges(scene, 12, seed) for seed in (0, 0, 1))
    assert first == again and first["gauges"] != other["gauges"] and first["tried"] >= 12


def test_a_string_lies_on_what_is_seen_and_has_its_profile(scene):
    found = study.gauges(scene, 12, 0)
    study.add_strings(scene, [(0.5, 0.5, 30.0), (0.5, 0.45, -60.0)], found)
    assert found["strings"] == [[12, 27], [27, 42]] and len(found["gauges"]) == 42
    for first, end in found["strings"]:
        own = found["gauges"][first:end]
        assert {gauge["object"] for gauge in own} == {"Ball"}
        places = np.array([(gauge["x"], gauge["y"]) for gauge in own])
        along, spacing = strings.line(places)
        assert spacing == pytest.approx(5 * SIZE[1] / 768, rel=1e-3)
        radius = SIZE[1] / 2 / scene.camera.data.view_frame(scene=scene)[0].y * 1 / 8  # pixels, of a ball 8 units away
        bends = strings.curvature(np.array([gauge["n"] for gauge in own]), along, spacing)
        assert bends == pytest.approx(np.full(14, 1 / radius), rel=0.35), "a ball, in perspective"
    bpy.data.objects["Ball"].scale, bpy.data.objects["Wall"].hide_render = (0.03, 0.03, 0.03), True
    bpy.context.view_layer.update()
    with pytest.raises(ValueError, match="--string 0.5,0.5,0: .* of its 15 gauges are not on a surface"):
        study.add_strings(scene, [(0.5, 0.5, 0.0)], found)


def test_a_scene_with_too_few_places_says_so(scene):
    for name in ("Ball", "Wall"):
        bpy.data.objects[name].scale = (0.01, 0.01, 0.01)
    with pytest.raises(ValueError, match="--gauges 12: only 0 places.*ask for fewer, or come nearer"):
        study.gauges(scene, 12, 0)


def test_a_shaded_picture_is_gray_and_follows_the_surface(scene, tmp_path):
    bpy.data.objects["Wall"].hide_render = True
    options = draw_options.parse(["suzanne:1", "-o", str(tmp_path / "drawing.png")])
    study.draw.set_output(scene, options)
    world = scene.world
    study.render(scene, options, tmp_path / "shaded.png", True)
    assert scene.world == world, "colors of drawings depend on it"
    colors = picture.pixels(tmp_path / "shaded.png")[..., :3]
    assert np.ptp(colors, axis=2).max() < 0.05 and colors[:4, :4].min() > 0.98
    middle, below = colors[96, 128].mean(), colors[66, 128].mean()
    assert 0.1 < middle < 0.98 and abs(middle - below) > 0.02


def test_gauges_are_set_in_a_window_and_what_is_no_study_is_named(tmp_path):
    (tmp_path / "study.json").write_text("{}")
    with pytest.raises(RuntimeError, match="Gauges are set in a window: start Blender without --background"):
        bpy.ops.fovea.set_gauges(filepath=str(tmp_path / "study.json"))
