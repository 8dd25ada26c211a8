# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators for lines as an image and as objects, and the report, from scripts, on scenes whose lines are known."""

import bpy
import numpy as np
import pytest
from pictures import SIZE, box_scene, box_scene_of_one_set, drawn, ink, layered
from the_addon import box_mesh, empty_scene, lines_of, new_mesh, new_object, own_style, part

report, drawn_lines = part("render.report"), part("render.drawn_lines")


@pytest.fixture
def scene():
    return box_scene_of_one_set()


def test_the_image_is_the_lines_pass(scene, tmp_path):
    assert bpy.ops.fovea.render_lines(name="Inked") == {"FINISHED"}
    image = bpy.data.images["Inked"]
    assert tuple(image.size) == SIZE and image.packed_file
    pixels = np.empty(4 * SIZE[0] * SIZE[1], np.float32)
    image.pixels.foreach_get(pixels)
    channels = layered(scene, tmp_path / "layers.exr")
    alpha = next(values for name, values in channels.items() if "Lines" in name and name.endswith("A"))
    assert alpha.max() > 0.9
    np.testing.assert_allclose(pixels.reshape(*SIZE[::-1], 4)[..., 3], alpha, atol=2e-3)


def test_the_scene_may_use_another_engine(scene):
    scene.render.engine = "BLENDER_WORKBENCH"
    assert bpy.ops.fovea.render_lines() == {"FINISHED"}
    assert scene.render.engine == "BLENDER_WORKBENCH" and bpy.data.images["Lines"].has_data


def test_without_a_camera_or_lines_it_says_so(scene):
    scene.camera = None
    for operator in (bpy.ops.fovea.render_lines, bpy.ops.fovea.bake_strokes):
        assert not operator.poll()
        with pytest.raises(RuntimeError, match="no camera"):
            operator()
    scene = box_scene()
    bpy.data.objects.remove(bpy.data.objects["Box"])
    with pytest.raises(RuntimeError, match="nothing in the scene"):
        bpy.ops.fovea.bake_strokes()


def baked():
    return list(bpy.data.collections["Lines"].objects)


def test_too_little_memory_is_said(scene, monkeypatch):
    def full(*_):
        raise MemoryError

    monkeypatch.setattr(part("render.as_rendered"), "look", full)
    for operator in (bpy.ops.fovea.render_lines, bpy.ops.fovea.bake_strokes):
        with pytest.raises(RuntimeError, match="Memory is too small for this: hide or simplify"):
            operator()


def test_baked_as_a_mesh_it_is_the_box(scene):
    assert bpy.ops.fovea.bake_strokes(kind="MESH") == {"FINISHED"}
    (obj,) = baked()
    mesh = obj.data
    points = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", points)
    points = points.reshape(-1, 3)
    # On the edges of the box two coordinates are +-1; three of its nine visible edges meet at the nearest corner.
    assert (np.sort(np.abs(points), axis=1)[:, 1:] > 0.99).all() and np.abs(points).max() < 1.01
    ends = np.array([edge.vertices[:] for edge in mesh.edges])
    length = np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1).sum()
    assert length == pytest.approx(18, rel=0.02)
    assert mesh.attributes["strength"].domain == "POINT"
    kinds = np.empty(len(points), np.int32)
    mesh.attributes["kinds"].data.foreach_get("value", kinds)
    assert (kinds != 0).all()


def test_what_was_baked_is_not_drawn(scene, tmp_path):
    before = drawn(scene, tmp_path / "before.png")
    bpy.ops.fovea.bake_strokes(kind="MESH")
    assert len(baked()[0].data.edges) == 9
    scene.objects["Box"].fovea.usage = "OCCLUDE"
    assert ink(drawn(scene, tmp_path / "after.png")).max() == 0 < ink(before).max()


def test_baked_widths_are_those_of_the_pen(scene):
    scene.camera.data.type, scene.camera.data.ortho_scale = "ORTHO", 16.0  # a pixel is 1/10
    bpy.ops.fovea.bake_strokes(kind="MESH")
    (obj,) = baked()
    radius = np.empty(len(obj.data.vertices), np.float32)
    obj.data.attributes["radius"].data.foreach_get("value", radius)
    width = lines_of(scene).pen.width * SIZE[1] / 1080
    np.testing.assert_allclose(radius, 0.5 * width * 0.1, rtol=1e-4)


def test_baked_as_grease_pencil(scene):
    assert bpy.ops.fovea.bake_strokes(kind="GREASE_PENCIL") == {"FINISHED"}
    (obj,) = baked()
    assert obj.type == "GREASEPENCIL" and obj.show_in_front
    drawing = obj.data.layers[0].frames[0].drawing
    positions = drawing.attributes["position"].data
    points = np.empty(3 * len(positions), np.float32)
    positions.foreach_get("vector", points)
    assert np.abs(points).max() < 1.01 and len(drawing.strokes) >= 3
    assert sum(len(stroke.points) for stroke in drawing.strokes) == len(positions)
    radius = np.empty(len(positions), np.float32)
    drawing.attributes["radius"].data.foreach_get("value", radius)
    assert (radius > 0).all()
    np.testing.assert_allclose(obj.data.materials[0].grease_pencil.color[:3], lines_of(scene).pen.color, atol=1e-6)


def test_closed_lines_are_baked_closed(scene):
    bpy.data.objects.remove(bpy.data.objects["Box"])
    angles = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    ring = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)
    new_object(new_mesh(ring.tolist(), [], [range(24)]), "Disc")
    bpy.ops.fovea.bake_strokes(kind="MESH")
    (obj,) = baked()
    assert len(obj.data.edges) == len(obj.data.vertices) >= 24


def test_what_elision_takes_away_is_not_baked(scene, tmp_path):
    def baked_ink():
        bpy.ops.fovea.bake_strokes(kind="MESH")
        (obj,) = baked()
        ends, points = np.empty(2 * len(obj.data.edges), np.int32), np.empty(3 * len(obj.data.vertices), np.float32)
        opacity = np.empty(len(obj.data.vertices), np.float32)
        obj.data.edges.foreach_get("vertices", ends)
        obj.data.vertices.foreach_get("co", points)
        obj.data.attributes["opacity"].data.foreach_get("value", opacity)
        bpy.data.collections.remove(bpy.data.collections["Lines"])
        sides = np.diff(points.reshape(-1, 3)[ends].reshape(-1, 2, 3), axis=1)[:, 0]
        return (np.linalg.norm(sides, axis=1) * opacity[ends].reshape(-1, 2).mean(axis=1)).sum()

    pen = lines_of(scene).pen
    pen.width, pen.spacing = 2, 120
    for step in range(12):
        new_object(box_mesh(0.9), f"Sheet{step}", (0, 0, 1.5 + 0.02 * step))
    whole, drawn_whole = baked_ink(), ink(drawn(scene, tmp_path / "whole.png")).sum()
    own_style(scene).elision.enabled = True
    thinned, drawn_thinned = baked_ink(), ink(drawn(scene, tmp_path / "thinned.png")).sum()
    assert drawn_thinned < 0.3 * drawn_whole and thinned < 0.3 * whole


def values(obj, name, size=1):
    """(M,) or (M, size) values of a point attribute of a baked mesh."""
    attribute = obj.data.attributes[name]
    found = np.empty(len(attribute.data) * size, np.float32)
    attribute.data.foreach_get("value" if size == 1 else "color", found)
    return found.reshape(-1, size) if size > 1 else found


@pytest.fixture
def unfocused(scene):
    """The box with its focus at the left of the image: red, wide and opaque there, blue, thin and pale at the right."""
    line_set = lines_of(scene)
    scene.camera.data.type, scene.camera.data.ortho_scale = "ORTHO", 16.0  # a pixel is 1/10
    line_set.away = True
    line_set.pen.color, line_set.pen.opacity, line_set.pen.width = (1, 0, 0), 1.0, 30.0
    line_set.pen_away.color, line_set.pen_away.opacity, line_set.pen_away.width = (0, 0, 1), 0.25, 15.0
    fovea = scene.fovea
    fovea.focus_model, fovea.focus_place, fovea.focus_near, fovea.focus_far = "IMAGE", (0.3, 0.5), 0.0, 0.5
    return scene


def test_baked_strokes_are_as_wide_as_opaque_and_of_the_color_as_focus_has_them(unfocused):
    def baked_values():
        bpy.ops.fovea.bake_strokes(kind="MESH")
        (obj,) = baked()
        found = values(obj, "color", 4), values(obj, "opacity"), values(obj, "radius"), len(obj.data.vertices)
        bpy.data.collections.remove(bpy.data.collections["Lines"])
        return found

    color, opacity, radius, points = baked_values()
    away = color[:, 2]
    assert away.max() - away.min() > 0.5, "in focus at one side, out of it at the other"
    np.testing.assert_allclose(color, np.column_stack([1 - away, 0 * away, away, 1 + 0 * away]), atol=1e-5)
    np.testing.assert_allclose(opacity, 1 - 0.75 * away, atol=1e-5)
    unit = 0.5 * 0.1 * SIZE[1] / 1080
    np.testing.assert_allclose(radius, unit * (30 - 15 * away), rtol=1e-4)
    unfocused.fovea.focus_model = "NONE"
    assert baked_values()[3] < points, "where focus changes along an edge there are points"


def test_strokes_of_grease_pencil_have_the_color_of_focus_and_else_that_of_their_material(unfocused):
    def colors():
        bpy.ops.fovea.bake_strokes(kind="GREASE_PENCIL")
        attribute = baked()[0].data.layers[0].frames[0].drawing.attributes["vertex_color"]
        found = np.empty(4 * len(attribute.data), np.float32)
        attribute.data.foreach_get("color", found)
        bpy.data.collections.remove(bpy.data.collections["Lines"])
        return found.reshape(-1, 4)

    found = colors()
    assert (found[:, 3] == 1).any() and np.ptp(found[found[:, 3] == 1, 2]) > 0.5
    unfocused.fovea.focus_model = "NONE"
    assert (colors()[:, 3] == 0).all()


@pytest.mark.parametrize("kind, engine, hidden", [
    ("GREASE_PENCIL", "FOVEA", True), ("GREASE_PENCIL", "BLENDER_WORKBENCH", False), ("MESH", "FOVEA", False)
])  # fmt: skip
def test_baked_strokes_are_hidden_where_blender_would_draw_them_over_the_same_lines(scene, kind, engine, hidden):
    scene.render.engine = engine
    assert bpy.ops.fovea.bake_strokes(kind=kind) == {"FINISHED"}
    seen = bpy.context.view_layer.layer_collection.children["Lines"]
    assert (seen.hide_viewport, bpy.data.collections["Lines"].hide_render) == (hidden, hidden)


def test_the_report_names_what_was_left_out_and_why():
    scene = empty_scene()
    new_object(box_mesh(), "Box")
    ignored = new_object(box_mesh(), "Ignored")
    ignored.fovea.usage = "IGNORE"
    hidden = new_object(box_mesh(), "Hidden")
    hidden.hide_viewport = True
    unseen = new_object(box_mesh(), "Unseen")
    unseen.visible_camera = False
    new_object(bpy.data.meshes.new("Nothing"), "Nothing")
    flat = new_mesh([(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0)], [], [(0, 1, 2), (0, 1, 3)], "Flat")
    new_object(flat, "Flat")
    bpy.context.view_layer.update()
    assert bpy.ops.fovea.report() == {"FINISHED"}
    text = bpy.data.texts[report.TEXT].as_string()
    told = {line.split("'")[1]: line for line in text.splitlines() if line.startswith("  '")}
    assert "is excluded" in told["Ignored"] and "hidden in viewports" in told["Hidden"]
    assert "invisible to cameras" in told["Unseen"] and "no faces" in told["Nothing"]
    assert "1 faces have no area" in told["Flat"] and "Box" not in told
    assert "objects and instances: 2, meshes: 2," in text
    assert "MB" in text and text.startswith(report.NO_CAMERA) and scene.objects


def test_the_report_has_the_last_pictures_times(scene):
    bpy.ops.render.render()
    bpy.ops.fovea.report()
    bpy.ops.fovea.report()
    assert [text.name for text in bpy.data.texts].count(report.TEXT) == 1
    lines = bpy.data.texts[report.TEXT].as_string().splitlines()
    assert any("What Is Hidden" in line and line.endswith(" ms") for line in lines)
    assert "  Nothing was left out" in lines


def told():
    assert bpy.ops.fovea.report() == {"FINISHED"}
    return bpy.data.texts[report.TEXT].as_string()


def test_there_is_a_report_whatever_the_scene():
    empty_scene()
    text = told()
    assert text.startswith(report.NO_CAMERA) and "Nothing: there is nothing in the scene that has lines" in text
    scene = box_scene()
    text = told()
    assert report.NO_CAMERA not in text and "objects and instances: 1, meshes: 1, triangles: 12" in text
    scene.objects["Box"].hide_render = True
    text = told()
    assert "Nothing: there is nothing" in text and "'Box': is disabled in renders" in text
    nan = float("nan")
    vertices = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (nan, 0, 0), (3, 3, 3)]
    faces = [(0, 1, 2), (0, 1, 3), (0, 3, 1), (0, 1, 4)]
    new_object(new_mesh(vertices, [], faces, "Broken"), "Broken")
    text = told()
    for words in ("have no position", "have no area", "repeat others"):
        assert words in text, words


def test_reasons_are_told_once():
    reasons = {f"Ball{i}": "a sphere" for i in range(5)} | {"Cube": "a box"}
    assert list(report.grouped(reasons)) == ["'Ball0', 'Ball1', 'Ball2' and 2 more: a sphere", "'Cube': a box"]


def test_without_the_native_module_tools_say_why_not(scene, monkeypatch):
    monkeypatch.setattr(part("native"), "problem", lambda: "Fovea's native module is missing")
    for operator in (bpy.ops.fovea.report, bpy.ops.fovea.render_lines, bpy.ops.fovea.bake_strokes):
        assert not operator.poll()
        with pytest.raises(RuntimeError, match="native module is missing"):
            operator()
