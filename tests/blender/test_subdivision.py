# SPDX-License-Identifier: GPL-3.0-or-later
"""Cages of subdivided objects, and the limit surfaces on which they are drawn."""

import bpy
import numpy as np
import pytest
from snapshots import NATIVE, capture_engine, fresh_scene, in_render, in_viewport, new_cache  # noqa: F401 (fixtures)
from the_addon import box_mesh, lines_of, mark_edges, new_mesh, new_object, part

subdivision = part("scene.subdivision")
pytestmark = pytest.mark.usefixtures("fresh_scene")


def subdivided(obj, levels=2, render_levels=2, **settings):
    modifier = obj.modifiers.new("Subdivision", "SUBSURF")
    modifier.levels, modifier.render_levels, modifier.quality = levels, render_levels, 6
    for name, value in settings.items():
        setattr(modifier, name, value)
    return modifier


def monkey():
    bpy.ops.mesh.primitive_monkey_add()
    return bpy.context.object


def crease(mesh, name, domain, weights):
    attribute = mesh.attributes.new(name, "FLOAT", domain)
    attribute.data.foreach_set("value", np.asarray(weights, np.float32))


def evaluated_positions(obj):
    mesh = obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    positions = np.empty((len(mesh.vertices), 3), np.float32)
    mesh.attributes["position"].data.foreach_get("vector", positions.ravel())
    return positions


def farthest_apart(a, b):
    """Largest distance from a point of one set to the nearest of the other."""
    return max(np.linalg.norm(a - point, axis=1).min() for point in b)


def only_surface(cache=None):
    (surface,) = in_viewport(cache or new_cache(NATIVE)).surfaces
    return surface


def is_refined(surface):
    return isinstance(surface, NATIVE.RefinedSurface)


@pytest.mark.parametrize("boundary", ["ALL", "PRESERVE_CORNERS"])
def test_vertices_are_where_blender_puts_its_limit(boundary):
    # Blender's patches end somewhere, too: near creases and irregular vertices its points are off a little.
    obj = monkey()
    edges, vertices = len(obj.data.edges), len(obj.data.vertices)
    crease(obj.data, "crease_edge", "EDGE", np.where(np.arange(edges) % 5, 0, 0.4))
    crease(obj.data, "crease_vert", "POINT", np.where(np.arange(vertices) % 7, 0, 1.0))
    subdivided(obj, boundary_smooth=boundary)
    surface = only_surface()
    assert is_refined(surface)
    blender = evaluated_positions(obj)
    assert len(surface.positions) == len(blender)
    assert farthest_apart(surface.positions, blender) < 2e-4


def test_creases_are_left_out_where_the_modifier_does():
    obj = new_object(box_mesh())
    crease(obj.data, "crease_edge", "EDGE", np.ones(12))
    modifier = subdivided(obj)
    assert only_surface().positions.max() == pytest.approx(1)
    modifier.use_creases = False
    assert only_surface().positions.max() < 0.9


def test_a_sharp_cage_stays_as_it_is():
    obj = new_object(box_mesh())
    crease(obj.data, "crease_edge", "EDGE", np.ones(12))
    mark_edges(obj.data, sharp=[0], freestyle=[1])
    subdivided(obj)
    surface = only_surface()
    assert np.abs(surface.positions).max(axis=1) == pytest.approx(1)


def test_what_comes_before_the_modifier_is_in_the_cage():
    obj = monkey()
    obj.shape_key_add(name="Basis")
    key = obj.shape_key_add(name="Tall")
    for point in key.data:
        point.co.z *= 2
    key.value = 0.5
    obj.modifiers.new("Wave", "WAVE")
    subdivided(obj)
    bpy.context.scene.frame_set(9)
    surface = only_surface()
    assert is_refined(surface)
    assert farthest_apart(surface.positions, evaluated_positions(obj)) < 2e-4


def test_nothing_of_the_users_changes():
    obj = monkey()
    obj.modifiers.new("Wave", "WAVE")
    modifier = subdivided(obj)
    before = set(bpy.data.meshes), evaluated_positions(obj)
    seen = []

    def note(scene, depsgraph):
        seen.append(subdivision.is_echo(depsgraph.updates))

    bpy.context.view_layer.update()
    bpy.app.handlers.depsgraph_update_post.append(note)
    cache = new_cache(NATIVE)
    for _ in range(3):
        assert is_refined(only_surface(cache))
    bpy.app.handlers.depsgraph_update_post.remove(note)
    assert seen == [True]  # of the first time; then the cage is known
    assert modifier.show_viewport and modifier.show_render
    evaluated = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    assert all(m.show_viewport and m.show_render for m in evaluated.modifiers)
    assert set(bpy.data.meshes) == before[0]
    assert np.array_equal(evaluated_positions(obj), before[1])


@pytest.mark.usefixtures("capture_engine")
def test_renders_take_the_levels_of_renders(monkeypatch):
    monkeypatch.setattr("snapshots.new_cache", lambda: new_cache(NATIVE))
    subdivided(new_object(box_mesh()), levels=1, render_levels=3)
    (snapshot,) = in_render().values()
    assert is_refined(snapshot.surfaces[0]) and snapshot.surfaces[0].polygon_count == 6 * 4**3
    assert only_surface().polygon_count == 6 * 4
    bpy.context.scene.render.use_simplify = True
    bpy.context.scene.render.simplify_subdivision_render = 2
    (snapshot,) = in_render().values()
    assert snapshot.surfaces[0].polygon_count == 6 * 4**2


def wave_after(obj):
    subdivided(obj)
    obj.modifiers.new("Wave", "WAVE")


@pytest.mark.parametrize(
    "prepare",
    [
        lambda obj: subdivided(obj, subdivision_type="SIMPLE"),
        lambda obj: subdivided(obj, use_limit_surface=False),
        lambda obj: subdivided(obj, levels=0),
        lambda obj: subdivided(obj, show_viewport=False),
        wave_after,
    ],
)
def test_other_objects_are_drawn_as_they_are(prepare):
    obj = new_object(box_mesh())
    prepare(obj)
    assert not is_refined(only_surface())


def test_a_modifier_that_is_off_does_not_count():
    obj = new_object(box_mesh())
    subdivided(obj)
    obj.modifiers.new("Wave", "WAVE").show_viewport = False
    assert is_refined(only_surface())


def test_refine():
    obj = new_object(box_mesh())
    obj.fovea.refine, obj.fovea.refine_level = True, 3
    surface = only_surface()
    assert surface.polygon_count == 6 * 4**3
    assert np.linalg.norm(surface.positions, axis=1).max() == pytest.approx(np.sqrt(0.75), abs=1e-5)
    # With the modifier the cage is the same.
    subdivided(obj, levels=1)
    assert only_surface().polygon_count == 6 * 4**3
    obj.fovea.refine_level = 1
    assert only_surface().polygon_count == 6 * 4


def test_a_cage_that_moves_keeps_its_refinement():
    obj = monkey()
    obj.modifiers.new("Wave", "WAVE")
    subdivided(obj)
    cache = new_cache(NATIVE)
    bpy.context.scene.frame_set(1)
    before = only_surface(cache)
    positions = before.positions.copy()
    bpy.context.scene.frame_set(10)
    after = only_surface(cache)
    assert after is before and cache.moved == [after] and cache.rebuilt == []
    assert not np.array_equal(positions, after.positions)
    assert farthest_apart(after.positions, evaluated_positions(obj)) < 2e-4


def test_a_cage_without_limit_is_said_once():
    mesh = new_mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1)], [], [(0, 1, 2), (0, 1, 3), (1, 0, 4)])
    obj = new_object(mesh, "Fan")
    subdivided(obj)
    cache = new_cache(NATIVE)
    assert not is_refined(only_surface(cache))
    assert len(cache.remarks) == 1 and "Fan" in cache.remarks[0]
    surface = only_surface(cache)
    assert cache.remarks == [] and surface.polygon_count == 9 * 16 / 4


def test_marks_and_materials_of_the_cage():
    mesh = box_mesh()
    for name in ("Red", "Blue"):
        mesh.materials.append(bpy.data.materials.new(name))
    mesh.polygons[1].material_index = 1
    subdivided(new_object(mesh))
    snapshot = in_viewport(new_cache(NATIVE))
    assert [slot.name for slot in snapshot.slots[0]] == ["Red", "Blue"]


def test_edit_mode_and_curves():
    obj = new_object(box_mesh())
    subdivided(obj)
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    bpy.ops.object.mode_set(mode="EDIT")
    assert not is_refined(only_surface())
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.data.objects.remove(obj)
    text = new_object(bpy.data.curves.new("Text", "FONT"))
    text.data.body = "o"
    subdivided(text)
    assert not is_refined(only_surface())


def test_changes_of_the_user_are_no_echo():
    obj = new_object(box_mesh())
    modifier = subdivided(obj)
    seen = []
    bpy.context.view_layer.update()

    def handler(scene, depsgraph):
        seen.append(subdivision.is_echo(depsgraph.updates))

    bpy.app.handlers.depsgraph_update_post.append(handler)

    def change(what):
        what()
        bpy.context.view_layer.update()

    change(lambda: setattr(obj.fovea, "refine", True))
    change(lambda: setattr(modifier, "levels", 1))
    change(lambda: setattr(obj, "location", (1, 0, 0)))
    change(lambda: setattr(lines_of(bpy.context.scene).pen, "width", 3))
    bpy.app.handlers.depsgraph_update_post.remove(handler)
    assert len(seen) >= 3 and not any(seen)
