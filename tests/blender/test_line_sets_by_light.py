# SPDX-License-Identifier: GPL-3.0-or-later
"""Line sets that have lines in light, or in shade, only; the lights are Blender's lamps."""

import bpy
import numpy as np
import pytest
from pictures import box_scene_of_one_set, drawn
from the_addon import box_mesh, lines_of, new_object, only_lines, own_style

RED, BLUE = (1, 0, 0), (0, 0, 1)


@pytest.fixture
def cube_under_a_lamp():
    """A cube that floats above a floor, and a small one in its shadow; a lamp above and to the left."""
    scene = box_scene_of_one_set()
    bpy.data.objects["Box"].scale = (0.5, 0.5, 0.5)
    bpy.data.objects["Box"].location.z = 1.2
    bpy.ops.mesh.primitive_plane_add(size=6)
    new_object(box_mesh(0.2), "In Shadow", (0.85, 0, 0.2))
    new_object(bpy.data.lights.new("Lamp", "POINT"), "Lamp", (-2, 0, 4))
    only_lines(scene, "contour", "crease", "border")
    lines_of(scene).pen.width = 12.0
    scene.render.resolution_x, scene.render.resolution_y = 480, 270
    return scene


def by_light(scene):
    """Two sets: what is lit in red, what is in shade in blue."""
    bpy.ops.fovea.line_set_duplicate()
    lit, shaded = own_style(scene).line_sets[-2:]
    for line_set, light, color in ((lit, "LIT", RED), (shaded, "SHADED", BLUE)):
        line_set.light, line_set.pen.color = light, color
    return lit, shaded


def colored(picture, color):
    """Pixels of a pen."""
    return (np.abs(picture[..., :3] - color) < 0.3).all(axis=-1)


def test_lit_and_shaded_lines_have_pens_of_their_own(cube_under_a_lamp, tmp_path):
    scene = cube_under_a_lamp
    by_light(scene)
    picture = drawn(scene, tmp_path / "both.png")
    assert colored(picture, RED).sum() > 100 and colored(picture, BLUE).sum() > 30
    bpy.data.objects["Lamp"].location.z = -4  # below the floor, nothing that the camera sees is lit
    dark = drawn(scene, tmp_path / "dark.png")
    assert colored(dark, BLUE).sum() > 100 and not colored(dark, RED).any()


def test_a_lamp_that_casts_no_shadow_does_not_count(cube_under_a_lamp, tmp_path):
    scene = cube_under_a_lamp
    by_light(scene)
    bpy.data.lights["Lamp"].use_shadow = False
    picture = drawn(scene, tmp_path / "no_shadow.png")
    assert colored(picture, RED).any() and not colored(picture, BLUE).any()


def test_what_no_set_wants_is_not_drawn(cube_under_a_lamp, tmp_path):
    scene = cube_under_a_lamp
    lines_of(scene).light = "ATTACHED"
    lines_of(scene).pen.color = RED
    attached = colored(drawn(scene, tmp_path / "attached.png"), RED).sum()
    lines_of(scene).light = "SHADED"
    shaded = colored(drawn(scene, tmp_path / "shaded.png"), RED).sum()
    lines_of(scene).light = "ANY"
    everything = colored(drawn(scene, tmp_path / "any.png"), RED).sum()
    assert 0 < attached < shaded < everything
