# SPDX-License-Identifier: GPL-3.0-or-later
"""Native surfaces: materials and marks; and when they are reused, moved or rebuilt."""

import bpy
import numpy as np
import pytest
from snapshots import NATIVE, fresh_scene, in_viewport, new_cache, scene
from the_addon import box_mesh, mark_edges, new_object, shader_material

pytestmark = pytest.mark.usefixtures(fresh_scene.__name__)


def test_materials_by_polygon():
    red, blue = bpy.data.materials.new("Red"), bpy.data.materials.new("Blue")
    red.diffuse_color = (1, 0, 0, 1)
    mesh = box_mesh()
    for material in (red, blue, red):
        mesh.materials.append(material)
    for polygon, slot in zip(mesh.polygons, (0, 1, 2, 0, 1, 2)):
        polygon.material_index = slot
    new_object(mesh)
    snapshot = in_viewport()
    # The third slot holds the same material as the first: no boundary between them.
    assert snapshot.surfaces[0].material.tolist() == [0, 1, 0, 0, 1, 0]
    assert snapshot.surfaces[0].occluding is None
    assert [slot.name for slot in snapshot.slots[0]] == ["Red", "Blue", "Red"]
    assert snapshot.slots[0][0].color == (1, 0, 0, 1)


def principled(name, **inputs):
    material = shader_material(name, "ShaderNodeBsdfPrincipled")
    shader = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    for key, value in inputs.items():
        shader.inputs[key.replace("_", " ")].default_value = value
    return material


@pytest.mark.parametrize(
    "make, choice, hides",
    [
        (lambda: principled("Paint"), "AUTOMATIC", True),
        (lambda: principled("Paint"), "NEVER", False),
        (lambda: principled("Film", Alpha=0.4), "AUTOMATIC", False),
        (lambda: principled("Film", Alpha=0.4), "ALWAYS", True),
        (lambda: shader_material("Glass", "ShaderNodeBsdfGlass"), "AUTOMATIC", False),
    ],
)
def test_which_materials_hide(make, choice, hides):
    material = make()
    material.fovea.occlusion = choice
    mesh = box_mesh()
    mesh.materials.append(material)
    new_object(mesh)
    (surface,) = in_viewport().surfaces
    assert (surface.occluding is None) if hides else not surface.occluding.any()


def test_objects_may_bring_their_own_material():
    mesh = box_mesh()
    mesh.materials.append(principled("Paint"))
    new_object(mesh, "Painted")
    glazed = new_object(mesh, "Glazed")
    glazed.material_slots[0].link = "OBJECT"
    glazed.material_slots[0].material = shader_material("Glass", "ShaderNodeBsdfGlass")
    snapshot = in_viewport()
    of = dict(zip(snapshot.objects, snapshot.surface_of_placement))
    assert snapshot.surfaces[of["Painted"]].occluding is None
    assert not snapshot.surfaces[of["Glazed"]].occluding.any()


@pytest.mark.parametrize("modifier", [None, "WAVE"])
def test_marks(modifier):
    mesh = box_mesh()
    mark_edges(mesh, sharp=[1, 2], seam=[3], freestyle=[4, 5, 6])
    obj = new_object(mesh)
    if modifier:
        obj.modifiers.new("Modifier", modifier)
    (surface,) = in_viewport().surfaces
    assert np.flatnonzero(surface.sharp_edges).tolist() == [1, 2]
    assert np.flatnonzero(surface.seams).tolist() == [3]
    assert np.flatnonzero(surface.edge_marks).tolist() == [4, 5, 6]


def test_marks_are_read_only_when_wanted():
    mesh = box_mesh()
    mark_edges(mesh, freestyle=[4])
    new_object(mesh)
    bpy.context.view_layer.update()
    snapshot = scene.gather(bpy.context.evaluated_depsgraph_get(), new_cache(), with_marks=False)
    assert snapshot.surfaces[0].edge_marks is None


def test_a_deforming_mesh_keeps_its_topology():
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=8, y_subdivisions=8)
    bpy.context.object.modifiers.new("Wave", "WAVE")
    cache = new_cache(NATIVE)
    bpy.context.scene.frame_set(1)
    (before,) = in_viewport(cache).surfaces
    positions = before.positions.copy()
    bpy.context.scene.frame_set(10)
    (after,) = in_viewport(cache).surfaces
    assert after is before and cache.moved == [after] and cache.rebuilt == []
    assert not np.array_equal(positions, after.positions)


def test_surfaces_are_kept_while_their_content_is():
    obj = new_object(box_mesh(), "Box")
    cache = new_cache()
    (first,) = in_viewport(cache).surfaces
    assert cache.rebuilt == [first]
    obj.location.x = 3
    new_object(box_mesh(2.0), "Another")
    snapshot = in_viewport(cache)
    assert snapshot.surfaces[snapshot.surface_of_placement[snapshot.objects.index("Box")]] is first
    assert [surface.name for surface in cache.rebuilt] == ["Another"]
    mark_edges(obj.data, sharp=[0])
    obj.data.update_tag()
    in_viewport(cache)
    assert [surface.name for surface in cache.rebuilt] == ["Box"]


def test_surfaces_that_are_gone_are_let_go():
    obj = new_object(box_mesh())
    cache = new_cache()
    in_viewport(cache)
    bpy.data.objects.remove(obj)
    in_viewport(cache)
    assert not cache.entries


def test_objects_ask_for_curvature_of_their_own():
    mesh = box_mesh()
    plain, fitted = new_object(mesh, "Plain"), new_object(mesh, "Fitted")
    fitted.fovea.curvature_estimator, fitted.fovea.curvature_rings = "JETS", 4
    fitted.fovea.curvature_smoothing = 1.5
    plain.fovea.curvature_rings = 4  # of jets, which it does not ask for
    cache = new_cache()
    snapshot = in_viewport(cache)
    asked = [snapshot.surfaces[i].field_options for i in snapshot.surface_of_placement]
    of = dict(zip(snapshot.objects, asked))
    assert of == {"Plain": ("automatic", 0, 0, 0.0), "Fitted": ("jets", 0, 4, 1.5)}
    fitted.fovea.curvature_estimator = "ONE_RING"
    surfaces = in_viewport(cache).surfaces
    assert {surface.field_options[0] for surface in surfaces} == {"automatic", "one_ring"}
    assert cache.rebuilt == [], "other settings, the same surface"


def test_meshes_in_edit_mode():
    for x in range(2):
        obj = new_object(box_mesh(1.0 + x), f"Box {x}")
        obj.select_set(True)
        bpy.context.view_layer.objects.active = obj
    bpy.ops.object.mode_set(mode="EDIT")
    snapshot = in_viewport()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert sorted(surface.positions.max() for surface in snapshot.surfaces) == [1.0, 2.0]


def test_objects_that_share_a_mesh_in_edit_mode():
    """Also those that are not in edit mode themselves, with modifiers and without."""
    mesh = box_mesh()
    for name in ("Edited", "Plain", "Refined", "Smooth", "Waving"):
        new_object(mesh, name)
    bpy.data.objects["Refined"].fovea.refine = True
    bpy.data.objects["Smooth"].modifiers.new("Subdivision", "SUBSURF")
    bpy.data.objects["Waving"].modifiers.new("Wave", "WAVE")
    bpy.context.view_layer.objects.active = bpy.data.objects["Edited"]
    bpy.ops.object.mode_set(mode="EDIT")
    snapshot = in_viewport()
    bpy.ops.object.mode_set(mode="OBJECT")
    found = dict(zip(snapshot.objects, (len(snapshot.surfaces[i].positions) for i in snapshot.surface_of_placement)))
    assert found["Edited"] == found["Plain"] == found["Waving"] == 8
    assert found["Refined"] > 26 and found["Smooth"] == 26
