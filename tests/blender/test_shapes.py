# SPDX-License-Identifier: GPL-3.0-or-later
"""What the faces of objects stand for: as shading, the rest shape and settings say."""

import bpy
import numpy as np
import pytest
from mathutils import Matrix
from panel_layouts import shown_by
from pictures import drawn
from snapshots import NATIVE, fresh_scene, in_viewport, new_cache
from the_addon import add_camera, box_mesh, mark_edges, new_object, part

pytestmark = pytest.mark.usefixtures(fresh_scene.__name__)


def decided():
    """{object: its shape}, as drawn."""
    snapshot = in_viewport(new_cache(NATIVE))
    shapes = [snapshot.surfaces[i].shape for i in snapshot.surface_of_placement]
    return dict(zip(snapshot.objects, shapes))


def ball(**words):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, **words)
    return bpy.context.object


def smooth_edges():
    (surface,) = in_viewport().surfaces
    return surface.smooth_edges


def test_faces_decide_what_they_stand_for():
    new_object(box_mesh(), "Box")
    ball().name = "Ball"
    assert decided() == {"Box": "hard", "Ball": "smooth"}


@pytest.mark.parametrize("shape", ["HARD", "ROUNDED", "SMOOTH"])
def test_an_object_may_say_what_they_stand_for(shape):
    obj = ball()
    obj.fovea.shape = shape
    assert decided() == {obj.name: shape.lower()}
    obj.fovea.shape = "AUTOMATIC"
    assert decided() == {obj.name: "smooth"}


def test_objects_that_share_a_mesh_have_shapes_of_their_own():
    one = ball()
    other = new_object(one.data, "Other")
    other.fovea.shape = "HARD"
    assert decided() == {one.name: "smooth", "Other": "hard"}


def test_shading_is_smooth_but_at_flat_faces_and_sharp_edges():
    mesh = box_mesh()
    new_object(mesh)
    mesh.shade_flat()
    assert smooth_edges() is None
    mesh.shade_smooth()
    assert smooth_edges().all()
    mark_edges(mesh, sharp=[1, 2])
    assert np.flatnonzero(~smooth_edges()).tolist() == [1, 2]
    mesh.polygons[0].use_smooth = False
    edges = {mesh.loops[corner].edge_index for corner in mesh.polygons[0].loop_indices}
    assert set(np.flatnonzero(~smooth_edges()).tolist()) == edges | {1, 2}


def test_splits_of_custom_normals_are_no_marks():
    mesh = box_mesh()
    new_object(mesh)
    mesh.shade_smooth()
    mesh.normals_split_custom_set([polygon.normal for polygon in mesh.polygons for _ in polygon.loop_indices])
    (surface,) = in_viewport().surfaces
    assert surface.sharp_edges is None
    assert not surface.smooth_edges.any()


def test_a_deforming_object_has_the_shape_that_it_has_at_rest():
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=24, y_subdivisions=24)
    cloth = bpy.context.object
    cloth.modifiers.new("Wave", "WAVE").height = 0.3
    for frame in (1, 20, 40):
        bpy.context.scene.frame_set(frame)
        assert decided() == {cloth.name: "hard"}
    cloth.modifiers.clear()
    cloth.shape_key_add(name="Basis")
    bent = cloth.shape_key_add(name="Bent")
    for point in bent.data:
        point.co.z = np.sin(3 * point.co.x) * np.cos(3 * point.co.y)
    bent.value = 1.0
    assert decided() == {cloth.name: "hard"}


def test_what_modifiers_make_anew_decides_by_itself():
    obj = new_object(box_mesh())
    remesh = obj.modifiers.new("Remesh", "REMESH")
    remesh.mode, remesh.octree_depth = "SMOOTH", 5
    cast = obj.modifiers.new("Cast", "CAST")
    cast.factor, cast.cast_type = 1.0, "SPHERE"
    assert decided() == {obj.name: "smooth"}


def test_the_limit_of_a_subdivision_is_smooth():
    obj = new_object(box_mesh())
    obj.modifiers.new("Subdivision", "SUBSURF").levels = 2
    assert decided() == {obj.name: "smooth"}


class CountingCore:
    """The native module; counts the surfaces that are made."""

    def __init__(self):
        self.made = []

    def __getattr__(self, name):
        return getattr(NATIVE, name)

    def Surface(self, name, mesh):
        self.made.append(name)
        return NATIVE.Surface(name, mesh)


def waving(count=3):
    """Objects that share a grid, each with a wave of its own."""
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=24, y_subdivisions=24)
    first = bpy.context.object
    found = [first, *(new_object(first.data, f"Cloth {i}", location=(3 * i, 0, 0)) for i in range(1, count))]
    for obj in found:
        obj.modifiers.new("Wave", "WAVE").height = 0.3
    return found


def test_the_shape_of_a_mesh_at_rest_is_decided_once_for_all_objects_and_frames():
    objects, core = waving(), CountingCore()
    cache = new_cache(core)
    for frame in (1, 20, 40):
        bpy.context.scene.frame_set(frame)
        snapshot = in_viewport(cache)
        assert len(core.made) == len(objects) + 1
        assert {shape for shape, _ in snapshot.at_rest} == {"hard"}
    for obj in objects:
        obj.modifiers.new("Subdivision", "SUBSURF").subdivision_type = "SIMPLE"  # surfaces are made anew
    in_viewport(cache)
    assert len(core.made) == 2 * len(objects) + 1


def test_a_mesh_at_rest_that_is_edited_is_decided_again():
    obj, cache = ball(), new_cache(NATIVE)
    obj.modifiers.new("Wave", "WAVE").height = 0.01

    def found():
        return [surface.shape for surface in in_viewport(cache).surfaces]

    assert found() == ["smooth"]
    round_ = [tuple(vertex.co) for vertex in obj.data.vertices]
    obj.data.transform(Matrix.Scale(0.0, 4, (0, 0, 1)))
    obj.data.update()
    assert found() == ["hard"]
    for vertex, place in zip(obj.data.vertices, round_):
        vertex.co = place
    obj.data.update()
    assert found() == ["smooth"]


def test_what_is_asked_for_goes_before_what_is_decided_at_rest_and_back():
    (obj,), cache = waving(1), new_cache(NATIVE)
    for asked, shape in (("AUTOMATIC", "hard"), ("SMOOTH", "smooth"), ("AUTOMATIC", "hard")):
        obj.fovea.shape = asked
        snapshot = in_viewport(cache)
        assert snapshot.surfaces[0].shape == shape
        assert bool(snapshot.at_rest[0]) == (asked == "AUTOMATIC")


def test_a_deforming_object_that_nobody_asked_anything_of_tells_why_it_is_drawn_so(tmp_path):
    (obj,) = waving(1)
    add_camera()
    bpy.context.scene.render.engine = "FOVEA"
    drawn(bpy.context.scene, tmp_path / "cloth.png")
    shape, reason = part("render.session").last_statistics()["shape"][obj.name]
    assert shape == "hard" and reason.startswith("at rest, ") and "% of its area is rounded" in reason
    titles = shown_by(part("ui.things").OBJECT_PT_fovea).titles
    assert f"Drawn as hard: {reason}" in titles
    obj.fovea.shape = "HARD"
    drawn(bpy.context.scene, tmp_path / "cloth.png")
    assert part("render.session").last_statistics()["shape"][obj.name] == ("hard", "as asked for")


def test_a_drawing_tells_what_was_decided(tmp_path):
    obj = ball()
    add_camera()
    bpy.context.scene.render.engine = "FOVEA"
    drawn(bpy.context.scene, tmp_path / "ball.png")
    shape, reason = part("render.session").last_statistics()["shape"][obj.name]
    assert shape == "smooth" and "% of its area is rounded" in reason
