# SPDX-License-Identifier: GPL-3.0-or-later
"""A frame is bit-identical in every pass, whatever was drawn before it."""

import math
import random

import bmesh
import bpy
import pytest
from pictures import box_scene, drawn
from the_addon import add_camera, empty_scene, new_object, only_lines, part, use_style

session = part("render.session")
FRAMES = range(1, 13)
LINES = ("contour", "crease", "intersection", "suggestive_contour", "smooth_contour")
LINES += ("image_edge", "abstracted_shading")


def deforming_scene():
    """A sheet with a running wave, and a cage on its way to another shape that is drawn on the limit of its
    subdivision."""
    scene = empty_scene()
    scene.render.engine, scene.render.resolution_x, scene.render.resolution_y = "FOVEA", 128, 72
    scene.view_layers[0].use_pass_z = True
    scene.fovea.backend = "CPU"
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=40, y_subdivisions=40, size=4)
    wave = bpy.context.object.modifiers.new("Wave", "WAVE")
    wave.height, wave.width, wave.narrowness = 0.4, 0.8, 1.2
    bpy.ops.mesh.primitive_cube_add(size=1.4, location=(0, 0, 0.7))
    cage = bpy.context.object
    cage.shape_key_add(name="Basis")
    bent = cage.shape_key_add(name="Bent")
    for point in bent.data:
        point.co.x += 1.5 * point.co.z**2
    for frame in (FRAMES[0], FRAMES[-1]):
        bent.value = frame / FRAMES[-1]
        bent.keyframe_insert("value", frame=frame)
    cage.modifiers.new("Subdivision", "SUBSURF").render_levels = 2
    mark = new_object(None, "Mark", (0, -1, 0.5))
    scene.fovea.focus_model, scene.fovea.focus_object = "SCENE", mark
    use_style(scene, "watercolor")
    only_lines(scene, *LINES)
    camera = add_camera((3, -4, 3), (0, 0, 0))
    for frame in (FRAMES[0], FRAMES[-1]):
        camera.location.x = 3 + math.sin(frame)
        camera.keyframe_insert("location", frame=frame)
    return scene


@pytest.fixture
def frame(monkeypatch):
    """frame(scene, number): {pass: pixels} of a final render."""
    final_image, drawn = session.final_image, []

    def keeping(*arguments, **options):
        drawn.append(final_image(*arguments, **options))
        return drawn[-1]

    monkeypatch.setattr(session, "final_image", keeping)

    def render(scene, number):
        scene.frame_set(number)
        bpy.ops.render.render()
        image = drawn.pop()
        return {name: getattr(image, name) for name in ("combined", "lines", "depth", "color", "focus")}

    return render


def test_a_frame_of_deforming_meshes_is_the_same_alone_in_order_backwards_and_shuffled(frame):
    alone = {number: frame(deforming_scene(), number) for number in FRAMES}
    shuffled = random.Random(4).sample(FRAMES, len(FRAMES))
    for order in (FRAMES, reversed(FRAMES), shuffled):
        scene = deforming_scene()
        for number in order:
            found = frame(scene, number)
            differing = {name: int((found[name] != alone[number][name]).sum()) for name in found}
            assert not any(differing.values()), (number, differing)
    for name, pixels in alone[3].items():
        assert (pixels != alone[9][name]).any(), name


@pytest.mark.parametrize("style", ["charcoal", "watercolor"])
def test_a_frame_is_the_same_in_whatever_order_a_mesh_has_its_edges(style, tmp_path):
    """Blender numbers the edges that it makes in an order that depends on the number of cores."""
    scene = box_scene()
    bpy.ops.mesh.primitive_torus_add(location=(0.6, -0.6, 1))
    mesh = bpy.context.object.data
    mesh.attributes.new("sharp_edge", "BOOLEAN", "EDGE").data[100].value = True
    use_style(scene, style)
    before, first = [tuple(edge.vertices) for edge in mesh.edges], drawn(scene, tmp_path / "first.png")
    shuffle_edges(mesh)
    assert [tuple(edge.vertices) for edge in mesh.edges] != before
    second = drawn(scene, tmp_path / "second.png")
    assert first.std() > 0.01 and (first == second).all()


def shuffle_edges(mesh):
    order = list(range(len(mesh.edges)))
    random.Random(3).shuffle(order)
    changed = bmesh.new()
    changed.from_mesh(mesh)
    for edge, index in zip(changed.edges, order):
        edge.index = index
    changed.edges.sort()
    changed.to_mesh(mesh)
    changed.free()
    mesh.update()
