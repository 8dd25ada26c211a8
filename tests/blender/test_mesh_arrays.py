# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of meshes, where Blender has them and as they are copied."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from measure_kept import ball
from pictures import box_scene, drawn
from the_addon import part, use_style

mesh_arrays, native, session = part("scene.mesh_arrays"), part("native"), part("render.session")
AROUND = 500  # vertices of a ball; each of its WHOLE has more than LEAST_IN_PLACE bytes
WHOLE = ("positions", "edge_verts", "corner_verts", "corner_edges")  # of MeshArrays: those that are read in place


@pytest.fixture
def obj():
    """A ball with marks, two materials and a flat face."""
    box_scene()
    made = ball("Ball", (0, 0, 0), AROUND)
    mesh = made.data
    mesh.shade_smooth()
    mesh.polygons[7].use_smooth, mesh.polygons[9].material_index, mesh.edges[5].use_edge_sharp = False, 1, True
    return made


def read(mesh):
    """(MeshArrays, the buffers they may be in)."""
    buffers = mesh_arrays.Buffers()
    return mesh_arrays.read(native.load(), mesh, buffers, with_marks=True), buffers


def evaluated(obj):
    """The mesh that an object's modifiers make, which is drawn."""
    return obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data


def test_large_arrays_of_evaluated_meshes_are_read_where_they_are(obj, monkeypatch):
    mesh = evaluated(obj)
    arrays, _ = read(mesh)
    monkeypatch.setattr(mesh_arrays, "LEAST_IN_PLACE", 1 << 40)
    copied, _ = read(mesh)
    for name, values in vars(arrays).items():
        assert np.array_equal(values, getattr(copied, name)), name
    for name, attribute in zip(WHOLE, ("position", ".edge_verts", ".corner_vert", ".corner_edge")):
        values = getattr(arrays, name)
        assert values.ctypes.data == mesh.attributes[attribute].data[0].as_pointer() and not values.flags.writeable
        assert getattr(copied, name).ctypes.data != values.ctypes.data


def test_small_arrays_and_those_of_meshes_that_are_edited_are_copied(obj):
    whole = evaluated(obj)
    of_file, small = read(obj.data), read(evaluated(bpy.data.objects["Box"]))
    for arrays, buffers in (of_file, small):
        assert all(getattr(arrays, name).flags.writeable for name in WHOLE)
        assert buffers.nbytes >= sum(getattr(arrays, name).nbytes for name in WHOLE)
    in_place, _ = read(whole)
    assert all(np.array_equal(getattr(of_file[0], name), getattr(in_place, name)) for name in WHOLE)


@pytest.mark.parametrize("apart", [11, 13, 0, -12])
def test_what_does_not_lie_as_an_array_is_copied(apart):
    values = [SimpleNamespace(as_pointer=lambda i=i: 4096 + apart * i) for i in range(1 << 17)]
    assert mesh_arrays._in_place(values, (1 << 17, 3), np.float32) is None
    assert mesh_arrays._in_place(values[:-1], (1 << 17, 3), np.float32) is None


def test_pictures_are_the_same_wherever_arrays_are_read(tmp_path, monkeypatch):
    scene = box_scene()
    ball("Ball", (0.5, 0, 0)).modifiers.new("Wave", "WAVE")
    use_style(scene, "study")
    found = []
    for least in (1 << 40, 0):
        monkeypatch.setattr(mesh_arrays, "LEAST_IN_PLACE", least)
        session.forget()
        for frame in (5, 9):
            scene.frame_set(frame)
            found.append(drawn(scene, tmp_path / f"{least} {frame}.png"))
    assert np.array_equal(found[0], found[2]) and np.array_equal(found[1], found[3])
    assert not np.array_equal(found[0], found[1])
