# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks that are fixed to paths stay at their points of a surface while it deforms."""

import sys
from pathlib import Path

import bpy
import numpy as np
import pytest
from mathutils import Matrix
from pictures import drawn_at, drawn_at_once
from the_addon import add_camera, empty_scene, lines_of, new_mesh, new_object, only_lines, part, use_style

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

from bench.focus.world import kept_results

pipeline = part("pipeline")
FRAMES = (1, 6, 11)
WIDTH, ACROSS = 640, 5.0  # pixels of the picture, and units
COLUMNS = np.linspace(-1, 1, 25)
SAME = 1e-6  # of a path's length


@pytest.fixture
def bar():
    """A flat bar of 24 squares from x = -1 to 1, seen from above."""
    scene = empty_scene()
    scene.render.engine, scene.render.resolution_x, scene.render.resolution_y = "FOVEA", WIDTH, 120
    scene.view_settings.view_transform, scene.render.dither_intensity = "Standard", 0.0
    scene.fovea.backend = "CPU"
    use_style(scene, "plain")
    only_lines(scene, "border")
    pen = lines_of(scene).pen
    pen.width, pen.texture, pen.texture_anchor = 30.0, "dashes", "PATH"
    camera = add_camera((0, 0, 9), (0, 0, 0))
    camera.data.type, camera.data.ortho_scale = "ORTHO", ACROSS
    camera.matrix_world = Matrix.Translation((0, 0, 9))
    points = [(x, y, 0) for y in (-0.2, 0.2) for x in COLUMNS]
    count = len(COLUMNS)
    squares = [(i, i + 1, i + 1 + count, i + count) for i in range(count - 1)]
    return new_object(new_mesh(points, [], squares), "Bar")


def stretch(bar):
    """A shape key pulls the right half; returns the columns' places at each of FRAMES."""
    bar.shape_key_add(name="Basis")
    pulled = bar.shape_key_add(name="Pulled")
    for point in pulled.data:
        point.co.x += max(point.co.x, 0) ** 2
    for frame, value in ((FRAMES[0], 0.0), (FRAMES[-1], 1.0)):
        pulled.value = value
        pulled.keyframe_insert("value", frame=frame)
    return columns_at(bar)


def lead(bar):
    """A bone moves the right half away."""
    bones = bpy.data.objects.new("Rig", bpy.data.armatures.new("Rig"))
    bpy.context.scene.collection.objects.link(bones)
    bpy.context.view_layer.objects.active = bones
    bpy.ops.object.mode_set(mode="EDIT")
    bone = bones.data.edit_bones.new("Bone")
    bone.head, bone.tail = (0.5, 0, 0), (1.5, 0, 0)
    bpy.ops.object.mode_set(mode="OBJECT")
    group = bar.vertex_groups.new(name="Bone")
    group.add([i for i, v in enumerate(bar.data.vertices) if v.co.x > 0.01], 1.0, "REPLACE")
    bar.modifiers.new("Armature", "ARMATURE").object = bones
    for frame, way in ((FRAMES[0], 0.0), (FRAMES[-1], 0.7)):
        bones.pose.bones["Bone"].location.y = way
        bones.pose.bones["Bone"].keyframe_insert("location", frame=frame)
    return columns_at(bar)


def wave(bar):
    """Waves run through the bar, up and down; its columns stay where they are, seen from above."""
    waves = bar.modifiers.new("Wave", "WAVE")
    waves.height, waves.width, waves.narrowness, waves.time_offset = 0.4, 0.7, 3.0, -50
    return columns_at(bar)


def columns_at(bar):
    """{frame: (24 + 1,) x of the columns, as Blender deforms them}."""
    found = {}
    for frame in FRAMES:
        bpy.context.scene.frame_set(frame)
        mesh = bar.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
        points = np.empty((len(mesh.vertices), 3), np.float32)
        mesh.vertices.foreach_get("co", points.ravel())
        found[frame] = points[: len(COLUMNS), 0].astype(float)
    return found


def strokes_at(frame):
    bpy.context.scene.frame_set(frame)
    frames = []
    with kept_results(pipeline, "frame", frames):
        bpy.ops.render.render()
    return frames[-1].strokes


def moves(columns):
    """How far marks move along the upper side of the bar over all of FRAMES, in shares of it: what their places differ
    from a linear function of x at rest."""
    found = []
    for frame in FRAMES:
        strokes = strokes_at(frame)
        px, place = np.asarray(strokes.px, float), np.asarray(strokes.anchor[:, 0], float)
        above = px[:, 1] > 60
        x = np.interp((px[above, 0] / WIDTH - 0.5) * ACROSS, columns[frame], COLUMNS)
        inside = np.abs(x) < 0.8  # a subdivision moves the ends, and strokes begin beside their points
        assert inside.sum() > 40
        found.append((x[inside], place[above][inside]))
    x, place = np.concatenate(found, axis=1)
    return np.abs(place - np.polyval(np.polyfit(x, place, 1), x)).max()


@pytest.mark.parametrize("deform", [stretch, lead, wave])
def test_marks_stay_at_their_points_while_the_surface_deforms(bar, deform):
    assert moves(deform(bar)) < SAME


def test_marks_stay_on_the_limit_of_a_subdivision(bar):
    columns = wave(bar)
    bar.modifiers.new("Subdivision", "SUBSURF").levels = 2
    assert moves(columns) < SAME


def test_the_attribute_says_where_the_original_mesh_does(bar):
    stretch(bar)
    of_mesh = [np.asarray(strokes_at(frame).anchor).copy() for frame in FRAMES]
    bar.add_rest_position_attribute = True
    of_attribute = [np.asarray(strokes_at(frame).anchor) for frame in FRAMES]
    for one, other in zip(of_mesh, of_attribute):
        assert np.array_equal(one, other)


def test_the_attribute_counts_where_modifiers_add_vertices(bar):
    columns = wave(bar)
    bar.modifiers.new("Subdivision", "SUBSURF").subdivision_type = "SIMPLE"
    assert moves(columns) > 100 * SAME
    bar.add_rest_position_attribute = True
    assert moves(columns) < SAME


def key(owner, name, values):
    for frame, value in zip(FRAMES, values):
        setattr(owner, name, value)
        owner.keyframe_insert(name, frame=frame)


def test_where_the_topology_changes_lines_are_drawn_as_they_are(bar):
    wave(bar)
    copies = bar.modifiers.new("Array", "ARRAY")
    key(copies, "count", (1, 2, 3))
    hole = new_object(new_mesh([(-0.1, -0.1, -1), (0.1, -0.1, -1), (0, 0.1, -1), (0, 0, 1)], [],
                               [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]), "Hole")  # fmt: skip
    hole.hide_render = True
    cut = bar.modifiers.new("Boolean", "BOOLEAN")
    cut.object, cut.show_render = hole, False
    cut.keyframe_insert("show_render", frame=FRAMES[0])
    cut.show_render = True
    cut.keyframe_insert("show_render", frame=FRAMES[-1])
    counts = [strokes_at(frame).count for frame in FRAMES]
    assert min(counts) > 0 and len(set(counts)) > 1


def test_frames_are_the_same_alone_and_in_any_order(bar, tmp_path):
    stretch(bar)
    key(bar.modifiers.new("Array", "ARRAY"), "count", (1, 2, 1))
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end, scene.frame_step = FRAMES[0], FRAMES[-1], FRAMES[1] - FRAMES[0]
    together = drawn_at_once(scene, FRAMES, tmp_path)
    for frame in reversed(FRAMES):
        alone = drawn_at(scene, frame, tmp_path)
        assert (alone == together[frame]).all() and alone[..., :3].min() < 0.5
