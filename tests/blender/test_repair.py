# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes that are repaired before drawing, according to their objects' settings."""

import os

import bpy
import numpy as np
import pytest
from snapshots import NATIVE, fresh_scene, in_viewport, new_cache
from the_addon import box_mesh, new_mesh, new_object, part

pytestmark = pytest.mark.usefixtures(fresh_scene.__name__)


def torn_box(flip=()):
    """Six quads with vertices of their own; those of `flip` face inwards."""
    box = box_mesh()
    vertices, quads = [], []
    for polygon in box.polygons:
        quads.append([len(vertices) + i for i in range(4)])
        vertices += [tuple(box.vertices[v].co) for v in polygon.vertices]
        if polygon.index in flip:
            quads[-1].reverse()
    return new_object(new_mesh(vertices, [], quads), "Torn")


def weld(obj):
    obj.modifiers.new("Weld", "WELD").merge_threshold = 1e-3


def only_surface(cache=None):
    (surface,) = in_viewport(cache or new_cache(NATIVE)).surfaces
    return surface


def test_nothing_is_repaired_unasked():
    torn_box(flip=[0])
    cache = new_cache(NATIVE)
    assert only_surface(cache).mesh_edges == 24 and cache.remarks == []


def test_faces_are_turned_to_the_side_of_their_neighbors():
    obj = new_object(box_mesh(), "Turned")
    obj.data.polygons[0].flip()
    obj.data.polygons[3].flip()
    assert only_surface().report.inconsistent_edges > 0
    obj.fovea.repair_orient = True
    cache = new_cache(NATIVE)
    surface = only_surface(cache)
    assert surface.mesh_edges == 12 and surface.report.inconsistent_edges == 0
    assert cache.remarks == ["'Turned': 2 faces were turned around"]
    assert only_surface(cache) is surface and cache.remarks == []


def test_resampled_with_its_materials():
    obj = torn_box()
    for name in ("Red", "Blue"):
        obj.data.materials.append(bpy.data.materials.new(name))
    obj.data.polygons[2].material_index = 1
    weld(obj)
    obj.fovea.repair_resample, obj.fovea.repair_edge_length = 4, 0.4
    surface = only_surface()
    assert len(surface.triangles) == surface.polygon_count > 100
    assert np.abs(surface.positions).max(axis=1) == pytest.approx(1, abs=1e-5)


def test_an_object_is_welded_by_its_modifier_and_then_refined():
    obj = torn_box()
    obj.fovea.refine, obj.fovea.refine_level = True, 2
    apart = only_surface()
    assert isinstance(apart, NATIVE.RefinedSurface) and np.abs(apart.positions).max() == pytest.approx(1, abs=0.2)
    weld(obj)
    surface = only_surface()
    assert np.linalg.norm(surface.positions, axis=1).max() == pytest.approx(np.sqrt(0.75), abs=1e-5)


def test_a_mesh_that_moves_is_repaired_anew():
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=8, y_subdivisions=8)
    obj = bpy.context.object
    obj.modifiers.new("Wave", "WAVE")
    obj.fovea.repair_resample = 3
    cache = new_cache(NATIVE)
    bpy.context.scene.frame_set(1)
    before = only_surface(cache).positions.copy()
    bpy.context.scene.frame_set(10)
    assert not np.array_equal(only_surface(cache).positions, before)


@pytest.mark.parametrize("setting, modifier", [("repair_weld", "Weld"), ("repair_smooth", "Smooth")])
def test_a_removed_setting_of_an_old_file_names_its_modifier_once_and_does_nothing(setting, modifier, tmp_path):
    torn_box().fovea[setting] = 1
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "old.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "old.blend"))
    cache = new_cache(NATIVE)
    surface = only_surface(cache)
    assert cache.remarks == [f"'Torn': {modifier} is not a setting of the object anymore: add the modifier {modifier}"]
    assert surface.mesh_edges == 24
    assert only_surface(cache) is surface and cache.remarks == []


@pytest.mark.parametrize("setting, modifier", [("repair_weld", "Weld"), ("repair_smooth", "Smooth")])
def test_a_script_that_uses_a_removed_setting_hears_which_modifier_to_add(setting, modifier):
    settings = torn_box().fovea
    with pytest.raises(AttributeError, match=f"{setting} is not .*: add the modifier {modifier}"):
        setattr(settings, setting, 1)
    with pytest.raises(AttributeError, match=f"add the modifier {modifier}"):
        getattr(settings, setting)


def test_resampling_to_too_many_triangles_leaves_the_mesh_as_it_is_and_says_what_to_do():
    obj = new_object(box_mesh(), "Cube")
    obj.fovea.repair_resample, obj.fovea.repair_edge_length = 100, 1e-4
    cache = new_cache(NATIVE)
    assert only_surface(cache).mesh_edges == 12
    (told,) = cache.remarks
    count = int(told.removeprefix("'Cube': ").split()[0])
    assert 5e9 < count < 6e9  # triangles of sides of 1e-4 on a cube of 24 square units
    assert told.endswith("more than 10,000,000, so it was not resampled: set a longer Edge Length")


@pytest.mark.parametrize("length, steps, resampled", [(2.2e-3, 50, False), (0.2, 4, True)])
def test_what_is_resampled_depends_neither_on_memory_nor_on_its_limit(monkeypatch, length, steps, resampled):
    obj = new_object(box_mesh(), "Cube")
    obj.fovea.repair_resample, obj.fovea.repair_edge_length = steps, length  # 11 million triangles, or 1,400
    for limit, memory in ((0, 1 << 20), (0, 1 << 50), (100_000, 1 << 40), (1 << 50, 1 << 30)):
        monkeypatch.setattr(part("scene.kept"), "limit", limit)
        monkeypatch.setattr(os, "sysconf", {"SC_PHYS_PAGES": memory, "SC_PAGE_SIZE": 1}.__getitem__)
        cache = new_cache(NATIVE)
        assert (only_surface(cache).mesh_edges > 500, cache.remarks == []) == (resampled, resampled)
