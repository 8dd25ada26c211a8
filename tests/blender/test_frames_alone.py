# SPDX-License-Identifier: GPL-3.0-or-later
"""A frame is bit-identical in every pass, whatever was drawn before it."""

import math
import random

import bmesh
import bpy
import pytest
from long_tests import IS_LONG
from pictures import box_scene, drawn
from test_cut_out import card, leaf
from the_addon import (
    add_camera,
    add_hidden,
    box_mesh,
    empty_scene,
    lines_of,
    new_object,
    only_lines,
    own_style,
    part,
    use_style,
)

session = part("render.session")
FRAMES = range(1, 13 if IS_LONG else 6)
LINES = [definition["name"] for definition in part("catalogue").definitions()]
IN_IMAGE = ("image_edge", "abstracted_shading")  # take most of a frame, unless they smooth much


def deforming_scene(lines):
    """A sheet with a running wave, and a cage on its way to another shape that is drawn on the limit of its
    subdivision."""
    scene = empty_scene()
    scene.render.engine, scene.render.resolution_x, scene.render.resolution_y = "FOVEA", 64, 36
    scene.view_layers[0].use_pass_z = True
    scene.fovea.backend = "CPU"
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=24, y_subdivisions=24, size=4)
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
    only_lines(scene, *lines)
    for name in IN_IMAGE:
        part("scene.line_kinds").set_parameters(lines_of(scene).kinds, name, {"sigma": 8.0})
    camera = add_camera((3, -4, 3), (0, 0, 0))
    for frame in (FRAMES[0], FRAMES[-1]):
        camera.location.x = 3 + math.sin(frame)
        camera.keyframe_insert("location", frame=frame)
    return scene


def rigged_limb():
    """A smooth tube that two bones bend."""
    bpy.ops.mesh.primitive_cylinder_add(vertices=16, radius=0.3, depth=2, location=(-1, 0.4, 1))
    limb = bpy.context.object
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.subdivide(number_cuts=4)
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.object.shade_smooth()
    bpy.ops.object.armature_add(location=(-1, 0.4, 0))
    rig = bpy.context.object
    bpy.ops.object.mode_set(mode="EDIT")
    upper = rig.data.edit_bones.new("Upper")
    upper.head, upper.tail = (0, 0, 1), (0, 0, 2)
    upper.parent = rig.data.edit_bones[0]
    bpy.ops.object.mode_set(mode="POSE")
    for name, chosen in ((rig.data.bones[0].name, lambda z: z < 0), ("Upper", lambda z: z >= 0)):
        group = limb.vertex_groups.new(name=name)
        group.add([v.index for v in limb.data.vertices if chosen(v.co.z)], 1.0, "REPLACE")
    limb.modifiers.new("Armature", "ARMATURE").object = rig
    bone = rig.pose.bones["Upper"]
    bone.rotation_mode = "XYZ"
    for frame, angle in ((FRAMES[0], 0.0), (FRAMES[-1], 1.2)):
        bone.rotation_euler.x = angle
        bone.keyframe_insert("rotation_euler", frame=frame)
    bpy.ops.object.mode_set(mode="OBJECT")


def changing_scene(lines, smoothed):
    """That of deforming meshes with all that is kept between frames: a limb of bones, instances that move through each
    other, steps whose number grows, a plate that lies on another until it leaves, and leaves cut out of a card; hidden
    lines, and line thinning smoothed over so many frames before and after."""
    scene = deforming_scene(lines)
    rigged_limb()
    collection = bpy.data.collections.new("Bricks")
    brick = new_object(box_mesh(0.3), "Brick", collection=collection)
    new_object(box_mesh(0.2), "Knob", (0.3, 0.1, 0.25), collection)
    assert brick.users_collection == (collection,)
    for number in range(3):
        empty = new_object(None, f"Bricks {number}", (0.5 * number - 1, -1, 0.5))
        empty.instance_type, empty.instance_collection = "COLLECTION", collection
        key(empty, "location", (0.3 - 0.25 * number, 0.2, 0.1 * number))
        key(empty, "rotation_euler", (0.2, 0.0, 0.3 * number))
    steps = new_object(box_mesh(0.15), "Steps", (1.2, 0.6, 0.2)).modifiers.new("Array", "ARRAY")
    steps.relative_offset_displace = (0.0, 0.5, 1.0)
    for number in FRAMES:
        steps.count = 1 + number // 2
        steps.keyframe_insert("count", frame=number)
    plates = [new_object(box_mesh(0.4, name), name, (-0.9, -1.2, 0.9)) for name in ("Lower", "Upper")]
    for plate, by in zip(plates, ((0.4, 0, 0), (0.4, 0.3, 0))):
        plate.scale.z = 0.1
        key(plate, "location", by)
    plates[1].location.z += 0.08
    key(card(leaf(), half=0.5, location=(0.9, -1.1, 1.2)), "rotation_euler", (1.0, 0.0, 0.5))
    style = own_style(scene)
    style.elision.enabled, style.elision.frames = True, smoothed
    add_hidden(style.line_sets[-1])
    layer = scene.view_layers[0]
    layer.use_pass_cryptomatte_object, layer.pass_cryptomatte_depth = True, 2
    layer.fovea.hidden_lines = layer.fovea.line_depth = layer.fovea.line_id = True
    return scene


def key(obj, name, by):
    """Keyframes a vector of an object, which moves by so much from the first frame to the last."""
    first = getattr(obj, name).copy()
    for frame, share in ((FRAMES[0], 0.0), (FRAMES[-1], 1.0)):
        setattr(obj, name, [a + share * b for a, b in zip(first, by)])
        obj.keyframe_insert(name, frame=frame)


@pytest.fixture
def handed(monkeypatch):
    """{frame: {pass: pixels}} that the engine has handed over for final renders."""
    found, hand_over = {}, session._hand_over

    def keeping(engine, layer, filled):
        passes = found.setdefault(layer.id_data.frame_current, {})
        passes.update({name: pixels.copy() for name, (_, pixels) in filled.items()})
        hand_over(engine, layer, filled)

    monkeypatch.setattr(session, "_hand_over", keeping)
    return found


@pytest.fixture
def frame(handed):
    """frame(scene, number): {pass: pixels} of a frame that is rendered by itself."""

    def render(scene, number):
        scene.frame_set(number)
        bpy.ops.render.render()
        return handed.pop(number)

    return render


@pytest.mark.parametrize(
    ("lines", "smoothed"), [(LINES, 0), ([name for name in LINES if name not in IN_IMAGE], 2)], ids=["all", "smoothed"]
)
def test_a_frame_is_the_same_alone_in_order_backwards_and_shuffled(frame, handed, tmp_path, lines, smoothed):
    alone = {number: frame(changing_scene(lines, smoothed), number) for number in FRAMES}
    of_lines = {"Lines", "LinesHidden", "LineDepth", "LineId", "CryptoObject00"}
    assert alone[1].keys() == {"Combined", *of_lines, "Color", "Focus", "Depth"}

    def compare(number, found):
        differing = {name: int((found[name] != alone[number][name]).sum()) for name in found}
        assert found.keys() == alone[number].keys() and not any(differing.values()), (number, differing)

    shuffled = random.Random(4).sample(FRAMES, len(FRAMES))
    for order, persistent in ((reversed(FRAMES), False), (shuffled, True)):
        scene = changing_scene(lines, smoothed)
        scene.render.use_persistent_data = persistent
        for number in order:
            compare(number, frame(scene, number))
    scene.frame_start, scene.frame_end = FRAMES[0], FRAMES[-1]
    scene.render.filepath = str(tmp_path / "frame_####")
    for persistent in (True, False):
        scene.render.use_persistent_data = persistent
        bpy.ops.render.render(animation=True)
        for number in FRAMES:
            compare(number, handed.pop(number))
    for name, pixels in alone[FRAMES[1]].items():
        assert (pixels != alone[FRAMES[-2]][name]).any(), name


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
