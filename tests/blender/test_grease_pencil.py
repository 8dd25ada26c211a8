# SPDX-License-Identifier: GPL-3.0-or-later
"""Strokes baked to Grease Pencil: their layers, frames, materials and ids, what baking again replaces, and how they
look where Blender renders them."""

import bpy
import numpy as np
import pytest
from pictures import SIZE, box_scene_of_one_set, drawn, ink
from the_addon import add_hidden, box_mesh, lines_of, new_object, part

pencil_bake = part("render.pencil_bake")


@pytest.fixture
def scene():
    return box_scene_of_one_set()


@pytest.fixture
def moving(scene):
    """The box goes to the right from frame 1 to 5."""
    box = scene.objects["Box"]
    box.keyframe_insert("location", frame=1)
    box.location.x = 2
    box.keyframe_insert("location", frame=5)
    scene.frame_set(1)
    return scene


def bake(first=None, last=None, **more):
    of = {} if first is None else {"frames": "RANGE", "frame_start": first, "frame_end": last}
    assert bpy.ops.fovea.bake_strokes(kind="GREASE_PENCIL", **of, **more) == {"FINISHED"}
    return pencil_bake.found_in(bpy.context.scene)


def keys(obj, layer=0):
    return [frame.frame_number for frame in obj.data.layers[layer].frames]


def drawing(obj, number, layer=0):
    return obj.data.layers[layer].get_frame_at(number).drawing


def values(drawing, name, what="value", columns=1, kind=np.float32):
    attribute = drawing.attributes[name]
    found = np.empty((len(attribute.data), columns), kind)
    attribute.data.foreach_get(what, found.ravel())
    return found


def ids(drawing):
    """The (R,) ids of the paths of strokes."""
    return values(drawing, "path_id", columns=2, kind=np.int32).view(np.uint64)[:, 0]


def draw_by_hand(drawing):
    drawing.add_strokes([2])
    drawing.attributes["position"].data[-1].vector = (0, 0, 9)


def by_hand(drawing):
    """How many strokes were drawn by hand."""
    return int((ids(drawing) == 0).sum()) if "path_id" in drawing.attributes else len(drawing.strokes)


def test_frames_of_an_animation_are_baked_at_once(moving):
    obj = bake(1, 5)
    assert keys(obj) == [1, 2, 3, 4, 5, 6]
    at = [values(drawing(obj, number), "position", "vector", 3)[:, 0].max() for number in range(1, 6)]
    assert at[0] == pytest.approx(1, abs=0.01) and at[4] == pytest.approx(3, abs=0.01)
    assert at == sorted(at) and len(drawing(obj, 6).strokes) == 0, "after the last frame there is nothing"
    assert moving.frame_current == 1


def test_a_range_is_that_of_the_scene_if_no_other_is_given(moving):
    moving.frame_start, moving.frame_end = 2, 3
    assert bpy.ops.fovea.bake_strokes(kind="GREASE_PENCIL", frames="RANGE") == {"FINISHED"}
    assert keys(pencil_bake.found_in(moving)) == [2, 3, 4]


def test_on_twos_each_drawing_stands_for_two_frames(moving):
    obj = bake(1, 4, step=2)
    assert keys(obj) == [1, 3, 5] and len(drawing(obj, 5).strokes) == 0


def test_a_frame_is_baked_alike_alone_and_in_an_animation(moving):
    obj = bake(1, 5)
    moving.frame_set(3)
    bake(into="NEW")
    alone = next(other for other in moving.objects if other.type == "GREASEPENCIL" and other != obj)
    for name, what, columns in (("position", "vector", 3), ("radius", "value", 1), ("opacity", "value", 1)):
        of = [values(drawing(of, 3), name, what, columns) for of in (obj, alone)]
        np.testing.assert_array_equal(*of)


def test_strokes_are_in_the_order_of_their_ids_in_every_frame(moving):
    obj = bake(1, 5)
    found = [ids(drawing(obj, number)) for number in range(1, 6)]
    for each in found:
        assert (np.sort(each) == each).all() and (each != 0).all()
    assert set(found[0]) == set(found[1]), "edges of the box are the same lines"


def test_each_line_set_has_a_layer_and_its_hidden_lines_another_one_below(scene):
    add_hidden(lines_of(scene))
    name = lines_of(scene).name.title()
    obj = bake()
    assert [layer.name for layer in obj.data.layers] == [f"{name} Hidden", name]
    assert [material.name for material in obj.data.materials] == [f"{name} Hidden", name]
    assert len(drawing(obj, 1, 0).strokes) == 3 and not any(layer.use_lights for layer in obj.data.layers)


def test_baked_again_only_what_was_baked_is_replaced(moving):
    obj = bake(1, 5)
    layer, own = obj.data.layers[0], obj.data.layers.new("Mine")
    draw_by_hand(own.frames.new(2).drawing)
    draw_by_hand(layer.get_frame_at(3).drawing)
    obj.location.z, material = 0.5, obj.data.materials[0]
    obj.modifiers.new("Noise", "GREASE_PENCIL_NOISE")
    bpy.context.view_layer.update()
    before = values(drawing(obj, 5), "position", "vector", 3)
    moving.objects["Box"].scale *= 0.5
    assert bake(2, 4) == obj and [other.name for other in moving.objects if other.type == "GREASEPENCIL"] == [obj.name]
    assert keys(obj) == [1, 2, 3, 4, 5, 6] and [frame.frame_number for frame in own.frames] == [2]
    assert [by_hand(drawing(obj, number)) for number in (1, 2, 3, 4)] == [0, 0, 1, 0]
    assert by_hand(own.get_frame_at(2).drawing) == 1
    np.testing.assert_array_equal(before, values(drawing(obj, 5), "position", "vector", 3))
    z = values(drawing(obj, 4), "position", "vector", 3)[:, 2]
    assert z.max() == pytest.approx(0.5 - 0.5, abs=0.01), "half the box, in the space of the moved object"
    assert list(obj.data.materials) == [material] and len(obj.modifiers) == 1


def test_what_was_shown_after_the_frames_that_are_baked_again_stays(moving):
    obj = bake(1, 5, step=4)
    late = values(drawing(obj, 4), "position", "vector", 3)
    bake(2, 3)
    assert keys(obj) == [1, 2, 3, 4, 5, 6]
    np.testing.assert_array_equal(late, values(drawing(obj, 4), "position", "vector", 3))


def test_lines_of_a_line_set_that_is_gone_go_too(scene):
    add_hidden(lines_of(scene))
    obj = bake()
    lines_of(scene).hidden.clear()
    bake()
    assert [len(drawing(obj, 1, layer).strokes) > 0 for layer in (0, 1)] == [False, True]


def test_a_material_follows_its_pen_until_it_is_given_another_color(scene):
    obj, pen = bake(), lines_of(scene).pen
    (material,) = obj.data.materials
    pen.color = (0.5, 0, 0)
    bake()
    assert tuple(material.grease_pencil.color)[:3] == pytest.approx((0.5, 0, 0))
    material.grease_pencil.color = (0, 1, 0, 1)
    pen.color = (0, 0, 0.5)
    bake()
    assert list(obj.data.materials) == [material]
    assert tuple(material.grease_pencil.color)[:3] == pytest.approx((0, 1, 0))
    assert (values(drawing(obj, 1), "vertex_color", "color", 4)[:, 3] == 0).all()


def test_frames_in_which_nothing_is_seen_are_empty(moving):
    box = moving.objects["Box"]
    for number, hidden in ((1, False), (3, True), (4, False)):
        box.hide_render = hidden
        box.keyframe_insert("hide_render", frame=number)
    obj = bake(1, 4)
    assert [len(drawing(obj, number).strokes) > 0 for number in (1, 2, 3, 4)] == [True, True, False, True]


@pytest.mark.parametrize("given, said", [
    ({"kind": "MESH", "frames": "RANGE"}, "Meshes are of one frame: bake an animation with the type Grease Pencil"),
    ({"frames": "RANGE", "frame_start": 5, "frame_end": 4}, "no frames from 5 to 4: set End to Start or later"),
])  # fmt: skip
def test_what_cannot_be_baked_is_said(scene, given, said):
    with pytest.raises(RuntimeError, match=said):
        bpy.ops.fovea.bake_strokes(**given)


def test_an_animation_that_needs_too_much_memory_is_refused_and_nothing_is_changed(moving, monkeypatch):
    monkeypatch.setattr(part("render.bake_operators"), "MOST_MEMORY", 1)
    with pytest.raises(RuntimeError, match="until frame 1 need over 2 GB: bake fewer frames, or a larger step"):
        bake(1, 5)
    assert "Lines" not in bpy.data.collections


def overlap(a, b):
    """Pixels that are dark in two pictures, of all that are in either."""
    return (a & b).sum() / (a | b).sum()


@pytest.mark.parametrize("orthographic", [False, True])
def test_baked_strokes_cover_what_the_film_does_where_blender_renders_them(scene, tmp_path, orthographic):
    render, pen = scene.render, lines_of(scene).pen
    render.resolution_x, render.resolution_y = 4 * SIZE[0], 4 * SIZE[1]
    pen.width, pen.pressure = 16, 0.7  # strokes are thinner at their ends
    lines_of(scene).overshoot = 20
    if orthographic:
        scene.camera.data.type, scene.camera.data.ortho_scale = "ORTHO", 6.0
    new_object(box_mesh(0.5), "Small", (1.5, -1.5, 0.2))
    film = ink(drawn(scene, tmp_path / "film.png")) > 0.5
    bake()
    collection = bpy.data.collections["Lines"]
    collection.hide_render = False
    for name in ("Box", "Small"):
        scene.objects[name].hide_render = True
    world = scene.world = bpy.data.worlds.new("White")
    world.color = (1, 1, 1)
    render.engine, render.film_transparent = "BLENDER_WORKBENCH", False
    baked = ink(drawn(scene, tmp_path / "baked.png")) > 0.5
    assert film.sum() > 1000 and overlap(film, baked) > 0.9
