# SPDX-License-Identifier: GPL-3.0-or-later
"""Hair curves and particle hair: how they are read, and what they hide."""

import math

import bpy
import numpy as np
import pytest
from bare import STRANDS, emitter, hair_curves, node_modifier, read, shown, told
from snapshots import NATIVE, fresh_scene, new_cache, scene
from the_addon import add_camera, new_mesh, new_object, part

api = part("scene.api")
pytestmark = pytest.mark.usefixtures(fresh_scene.__name__)


def test_hair_curves_are_ribbons_or_lines_or_off():
    obj = new_object(hair_curves(STRANDS), "Hair")
    snapshot = read()
    assert snapshot.objects == ["Hair"] and shown(snapshot) == [{"contour", "silhouette"}]
    assert len(snapshot.surfaces[0].triangles) == 2 * (3 * 2 * 8 + 2)  # two segments rounded to eight
    obj.fovea.hair = "LINES"
    snapshot = read()
    assert "border" in shown(snapshot)[0] and not len(snapshot.surfaces[0].triangles)
    assert len(snapshot.surfaces[0].edges) == 2 * 8
    obj.fovea.hair = "OFF"
    assert read().objects == []


def test_strands_of_polylines_are_not_rounded_and_cyclic_ones_are_closed():
    data = hair_curves(STRANDS)
    data.attributes.new("cyclic", "BOOLEAN", "CURVE").data.foreach_set("value", [False, True])
    obj = new_object(data, "Hair")
    obj.fovea.hair = "LINES"
    # By a node, as Blender 4.3 has no set_types, and writes past its arrays if the attribute curve_type is set alone.
    (node,) = node_modifier(obj, "GeometryNodeCurveSplineType")
    node.spline_type = "POLY"
    (surface,) = read().surfaces
    assert surface.positions.tolist() == [list(map(float, p)) for p in (*STRANDS[0], *STRANDS[1], STRANDS[1][0])]


def test_strands_that_are_nothing_are_left_out():
    nowhere, still = [(0, 0, 0), (0, 0, math.nan)], [(1, 1, 1)] * 3
    new_object(hair_curves([nowhere, STRANDS[0], still, STRANDS[1], [(0, 0, 0)]]), "Hair")
    assert len(read().surfaces[0].positions) == 3 * 2 * (2 * 4 + 1)
    new_object(hair_curves([nowhere]), "Nothing")
    new_object(hair_curves(STRANDS, radius=0.0), "Thin")
    assert read().objects == ["Hair"]
    assert all("no strands of two points or more" in told()[name] for name in ("Nothing", "Thin"))


def test_instances_of_hair_share_its_surface_and_moving_hair_keeps_its_lines():
    obj = new_object(hair_curves(STRANDS), "Hair", collection=(collection := bpy.data.collections.new("Heads")))
    for x in range(3):
        instancer = new_object(None, f"Head {x}", (x, 0, 0))
        instancer.instance_type, instancer.instance_collection = "COLLECTION", collection
    cache = new_cache(NATIVE)
    before = read(cache)
    assert len(before.surfaces) == 1 and len(before.usage) == 3 and cache.rebuilt == before.surfaces
    obj.data.position_data[2].vector.y += 0.25
    obj.data.update_tag()
    after = read(cache)
    assert after.surfaces[0] is before.surfaces[0] and cache.moved == after.surfaces and not cache.rebuilt
    assert after.persistent_id.tolist() == before.persistent_id.tolist()
    assert read(cache) and not cache.moved


def test_particle_hair_is_where_blender_has_it_and_has_its_material():
    radii = {"root_radius": 0.4, "tip_radius": 0.2, "radius_scale": 0.5, "use_close_tip": False}
    obj = emitter(5, hair_length=2.0, display_step=2, material=2, **radii)
    obj.location, obj.rotation_euler = (3, 2, 1), (0.3, 0.2, 0.1)
    for name in ("Skin", "Fur"):
        obj.data.materials.append(bpy.data.materials.new(name))
    bpy.data.materials["Fur"].diffuse_color = (1, 0, 0, 1)
    snapshot = read()
    assert snapshot.objects == ["Skin", "Skin"] and len(set(snapshot.persistent_id.tolist())) == 2
    assert [slot.name for slot in snapshot.slots[snapshot.surface_of_placement[1]]] == ["Fur"]
    assert api.surface(obj) is not None and len(api.surface(obj).triangles) == 2  # that of the mesh
    rings = np.array(snapshot.surfaces[1].positions, np.float64).reshape(5, 5, 3, 3)
    to_world = np.array(obj.matrix_world)
    centers = rings.mean(axis=2) @ to_world[:3, :3].T + to_world[:3, 3]
    evaluated = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    system = evaluated.particle_systems[0]
    expected = [[system.co_hair(evaluated, particle_no=i, step=k) for k in range(5)] for i in range(5)]
    assert np.abs(centers - np.array(expected)).max() < 1e-5
    radius = np.linalg.norm(rings - rings.mean(axis=2, keepdims=True), axis=-1).mean(axis=(0, 2))
    assert np.allclose(radius / radius[0], np.linspace(1, 0.5, 5), atol=1e-4)
    assert radius[0] == pytest.approx(0.1 * 1.2092, rel=1e-3)  # half the diameter, as a prism of that mean width


def test_particle_hair_is_instanced_with_its_emitter():
    obj = emitter()
    collection = bpy.data.collections.new("Animals")
    bpy.context.scene.collection.objects.unlink(obj)
    collection.objects.link(obj)
    for x in (0.0, 5.0):
        instancer = new_object(None, f"Animal {x:.0f}", (x, 0, 0))
        instancer.instance_type, instancer.instance_collection = "COLLECTION", collection
    snapshot = read()
    assert snapshot.surface_of_placement.tolist() == [0, 1, 0, 1] and len(set(snapshot.persistent_id.tolist())) == 4
    assert snapshot.object_to_world[:, 0, 3].tolist() == [0, 0, 5, 5]
    root = np.array(snapshot.surfaces[1].positions)[:3].mean(axis=0)
    assert (root[:2] >= 0).all() and (root[:2] <= 1).all()  # on the square, wherever that stands


def test_hair_that_nodes_put_on_points_is_drawn_as_instances():
    hair = new_object(hair_curves(STRANDS), "Hair", (9, 9, 9))
    obj = new_object(new_mesh([(0, 0, 0), (4, 0, 0)], [], [], "Points"), "Points")
    points, instances = node_modifier(obj, "GeometryNodeMeshToPoints", "GeometryNodeInstanceOnPoints")
    info = points.id_data.nodes.new("GeometryNodeObjectInfo")
    info.inputs["Object"].default_value = hair
    points.id_data.links.new(info.outputs["Geometry"], instances.inputs["Instance"])
    info.inputs["As Instance"].default_value = True
    assert sorted(read().object_to_world[:, 0, 3].tolist()) == [0, 4, 9]
    info.inputs["As Instance"].default_value = False
    assert read().object_to_world[:, 0, 3].tolist() == [9] and "As Instance" in told()["Points"]


def test_children_are_drawn_and_their_parents_are_not():
    obj = emitter(3, child_type="SIMPLE", display_step=2)
    settings = obj.particle_systems[0].settings
    settings.child_percent = 4
    bpy.context.view_layer.update()
    assert len(read().surfaces[1].positions) == 3 * 4 * 3 * 5
    settings.use_parent_particles = True
    assert len(read().surfaces[1].positions) == (3 * 4 + 3) * 3 * 5


def test_a_hidden_emitter_has_hair_and_a_hidden_modifier_has_none():
    obj = emitter()
    obj.show_instancer_for_viewport = False
    assert read().objects == ["Skin"] and len(read().surfaces[0].triangles) > 10
    obj.modifiers[0].show_viewport = False
    assert read().objects == []
    obj.modifiers[0].show_viewport, obj.particle_systems[0].settings.render_type = True, "NONE"
    assert read().objects == []
    obj.show_instancer_for_viewport, obj.fovea.hair = True, "OFF"
    obj.particle_systems[0].settings.render_type = "PATH"
    assert len(read().surfaces) == 1


def test_final_renders_have_the_steps_for_renders():
    obj = emitter(2, display_step=2, render_step=3)
    add_camera()
    assert len(read().surfaces[1].positions) == 2 * 3 * 5
    bpy.context.scene.render.engine = "FOVEA"
    found = part("render.as_rendered").look(
        bpy.context, lambda _, depsgraph: scene.gather(depsgraph, new_cache(NATIVE))
    )
    assert len(found.surfaces[1].positions) == 2 * 3 * 9 and obj


def test_materials_decide_on_hair_as_on_faces():
    material = bpy.data.materials.new("Hair")
    data = hair_curves(STRANDS)
    data.materials.append(material)
    new_object(data, "Hair")
    material.fovea.occlusion = "NEVER"
    snapshot = read()
    assert not snapshot.slots[0][0].hides and snapshot.slots[0][0].name == "Hair"
    add_camera((0.5, -8, 1), (0.5, 0, 1))
    bpy.context.view_layer.update()
    assert len(api.lines("contour")["object"]) == 2
    material.fovea.lines = False
    assert part("scene.line_filters").of(NATIVE, (), read())["lined"] is not None


@pytest.mark.parametrize("how, hides", [("RIBBONS", True), ("LINES", False), ("OFF", False)])
def test_ribbons_hide_what_is_behind_them(how, hides):
    """A line, seen from the front, with a strand as wide as a third of it before its middle."""
    new_object(new_mesh([(-3, 0, 0), (3, 0, 0)], [(0, 1)], [], "Wire"), "Wire")
    obj = new_object(hair_curves([[(0, -1, -3), (0, -1, 3)]], radius=0.8), "Hair")
    obj.fovea.hair = how
    add_camera((0, -100, 0), (0, 0, 0))
    bpy.context.view_layer.update()
    found = api.lines("border", [bpy.data.objects["Wire"]], visible=True)
    x = found["points"][:, 0]
    length = sum(abs(x[end - 1] - x[begin]) for begin, end in zip(found["offsets"], found["offsets"][1:]))
    assert length == pytest.approx(6 - (1.6 if hides else 0), abs=0.15)
