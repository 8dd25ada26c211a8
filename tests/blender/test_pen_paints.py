# SPDX-License-Identifier: GPL-3.0-or-later
"""Width, opacity and color of pens from vertex groups, attributes, materials and objects: read, drawn, told, undone."""

import bpy
import numpy as np
import pytest
from pictures import drawn, scene_from_above
from the_addon import lines_of, new_mesh, new_object, part, use_style

SIZE, PIXELS = (320, 180), 40  # pixels per unit
WIDE = 24  # pixels, of the pen
reading, properties, style_read = part("render.reading"), part("render.properties"), part("style.style_read")
vertex_groups, report = part("scene.vertex_groups"), part("render.report")


@pytest.fixture
def scene():
    """Seen from above, with a thick black pen; no objects."""
    made = scene_from_above(SIZE, PIXELS)
    pen = use_style(made, "plain").line_sets[-1].pen
    pen.width, pen.width_unit, pen.cap = WIDE, "PIXELS", "BUTT"
    return made


def plane(name="Plane", half=(3.0, 1.5), at=(0.0, 0.0), faces=True):
    """A rectangle of one face, or its edges alone."""
    corners = [(x * half[0], y * half[1], 0) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    edges = [] if faces else [(i, (i + 1) % 4) for i in range(4)]
    mesh = new_mesh(corners, edges, [(0, 1, 2, 3)] if faces else [], name)
    return new_object(mesh, name, (*at, 0))


def ramp(obj):
    """(V,) values that grow with x, 1/4 to 3/4."""
    x = np.array([vertex.co.x for vertex in obj.data.vertices])
    return 0.5 + 0.25 * x / np.abs(x).max()


def paint(obj, values, kind="FLOAT", name="Paint"):
    data = obj.data.attributes.new(name, kind, "POINT").data
    if kind == "FLOAT":
        data.foreach_set("value", np.asarray(values, np.float32))
    else:
        data.foreach_set("color", np.repeat(np.asarray(values, np.float32), 4))


def group(obj, values, name="Paint"):
    made = obj.vertex_groups.new(name=name)
    for i, value in enumerate(values):
        made.add([i], float(value), "REPLACE")


def take(scene, member, source, name="Paint"):
    pen = lines_of(scene).pen
    setattr(pen, f"paint_{member}", source)
    setattr(pen, f"paint_{member}_name", name)
    return pen


def widths(picture):
    """Ink across the upper side of the plane, in pixels, and x of each column between its ends."""
    srgb = picture[..., 0]
    light = np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
    upper = (1 - light)[SIZE[1] // 2 + 30 : SIZE[1] // 2 + 90]
    x = (np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) / PIXELS
    inside = np.abs(x) < 2.5
    return x[inside], upper.sum(axis=0)[inside]


@pytest.mark.parametrize("source, kind", [("ATTRIBUTE", "FLOAT"), ("ATTRIBUTE", "BYTE_COLOR"), ("VERTEX_GROUP", None)])
def test_width_is_the_pens_times_what_is_painted(scene, tmp_path, source, kind):
    obj = plane()
    paint(obj, ramp(obj), kind) if kind else group(obj, ramp(obj))
    take(scene, "width", source)
    x, found = widths(drawn(scene, tmp_path / "ramp.png"))
    np.testing.assert_allclose(found, WIDE * (0.5 + 0.25 * x / 3), atol=0.25 if kind == "BYTE_COLOR" else 0.1)


def test_a_vertex_group_draws_what_an_attribute_of_its_values_does(scene, tmp_path):
    obj = plane()
    obj.modifiers.new("Simple", "SUBSURF").subdivision_type = "SIMPLE"
    obj.modifiers["Simple"].render_levels = 2
    paint(obj, ramp(obj)), group(obj, ramp(obj), "Weights")  # Blender gives no two of them one name
    pictures = []
    for source, name in (("ATTRIBUTE", "Paint"), ("VERTEX_GROUP", "Weights")):
        for member in ("width", "opacity", "color"):
            take(scene, member, source, name)
        pictures.append(drawn(scene, tmp_path / "same.png"))
    np.testing.assert_allclose(*pictures, atol=1 / 255)
    assert np.ptp(pictures[0]) > 0.1


@pytest.mark.parametrize("levels, kind", [(2, "CATMULL_CLARK"), (1, "SIMPLE")])
def test_weights_follow_a_mesh_that_is_refined_or_subdivided(scene, tmp_path, levels, kind):
    obj = plane()
    group(obj, ramp(obj))
    modifier = obj.modifiers.new("Subdivision", "SUBSURF")
    modifier.subdivision_type, modifier.render_levels, modifier.boundary_smooth = kind, levels, "PRESERVE_CORNERS"
    take(scene, "width", "VERTEX_GROUP")
    x, found = widths(drawn(scene, tmp_path / "refined.png"))
    np.testing.assert_allclose(found, WIDE * (0.5 + 0.25 * x / 3), atol=0.3)


def test_edges_without_faces_are_painted_too(scene, tmp_path):
    obj = plane(faces=False)
    group(obj, ramp(obj))
    take(scene, "width", "VERTEX_GROUP")
    x, found = widths(drawn(scene, tmp_path / "wire.png"))
    np.testing.assert_allclose(found, WIDE * (0.5 + 0.25 * x / 3), atol=0.1)


def lower_left(picture):
    """Color of the middle of the left side of a plane of half (1, 1) at (-2, 0)."""
    return picture[SIZE[1] // 2, SIZE[0] // 2 - 3 * PIXELS, :3]


def test_color_is_that_of_the_object_or_of_the_material_in_place_of_the_pens(scene, tmp_path):
    left, right = plane("Left", (1, 1), (-2, 0)), plane("Right", (1, 1), (2, 0))
    right.data = left.data  # one mesh: materials are shared, colors of objects are not
    material = bpy.data.materials.new("Red")
    material.use_nodes = True
    material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (1, 0, 0, 1)
    left.data.materials.append(material)
    left.color, right.color = (0, 1, 0, 1), (0, 0, 1, 1)
    take(scene, "color", "OBJECT")
    of_objects = drawn(scene, tmp_path / "objects.png")
    np.testing.assert_allclose(lower_left(of_objects), (0, 1, 0), atol=0.01)
    np.testing.assert_allclose(lower_left(of_objects[:, ::-1]), (0, 0, 1), atol=0.01)
    take(scene, "color", "MATERIAL")
    of_materials = drawn(scene, tmp_path / "materials.png")
    np.testing.assert_allclose(lower_left(of_materials), (1, 0, 0), atol=0.01)
    left.data.materials.clear()
    assert lower_left(drawn(scene, tmp_path / "none.png")).max() < 0.01, "without a material, the pen's own"


def test_width_of_an_object_is_the_mean_of_its_color(scene, tmp_path):
    plane().color = (0.25, 0.5, 0.75, 1)
    take(scene, "width", "OBJECT")
    np.testing.assert_allclose(widths(drawn(scene, tmp_path / "object.png"))[1], WIDE / 2, atol=0.1)


def read(scene, reader=None):
    depsgraph = bpy.context.evaluated_depsgraph_get()
    return (reader or reading.Reader()).read(depsgraph, properties.style_of(scene))


@pytest.mark.parametrize("source, what", [("VERTEX_GROUP", "vertex group"), ("ATTRIBUTE", "float or color attribute")])
def test_what_is_not_painted_is_told_and_drawn_as_the_pen_says(scene, tmp_path, source, what):
    obj = plane()
    bare = drawn(scene, tmp_path / "bare.png")
    take(scene, "width", source, "Thickness")
    np.testing.assert_array_equal(drawn(scene, tmp_path / "lacking.png"), bare)
    (sentence,) = read(scene).remarks
    assert sentence.startswith(f"'Plane': no {what}") and "'Thickness'" in sentence and "add it to the mesh" in sentence
    assert any(sentence in line for line in report.report(read(scene), bpy.context.evaluated_depsgraph_get()))
    lines_of(scene).object = "Another"
    assert read(scene).remarks == (), "the pen draws nothing of it"
    lines_of(scene).object = ""
    paint(obj, ramp(obj), name="Thickness") if source == "ATTRIBUTE" else group(obj, ramp(obj), "Thickness")
    assert read(scene).remarks == ()
    take(scene, "width", source, "")
    assert read(scene).remarks == (), "nothing is named"


def test_a_choice_is_undone(scene):
    bpy.ops.ed.undo_push(message="before")
    take(scene, "opacity", "VERTEX_GROUP")
    bpy.ops.ed.undo_push(message="after")
    assert style_read.read(scene.fovea.style).line_sets[-1].pen.paint_opacity == "vertex_group"
    bpy.ops.ed.undo()
    pen = style_read.read(bpy.context.scene.fovea.style).line_sets[-1].pen
    assert (pen.paint_opacity, pen.paint_opacity_name) == ("constant", "")


def test_weights_are_read_again_where_the_geometry_of_an_object_has_changed(scene):
    """As in viewports: what Blender tells of updates is enough to know it."""
    obj, other = plane(), plane("Other")
    group(obj, [0.5] * 4), group(other, [0.5] * 4)
    weights = vertex_groups.Weights()

    def of(each):
        evaluated = each.evaluated_get(bpy.context.evaluated_depsgraph_get())
        return weights.of(evaluated, evaluated.data, 0)

    def forget(_scene, depsgraph):
        weights.forget(depsgraph.updates)

    bpy.app.handlers.depsgraph_update_post.append(forget)
    try:
        before = of(obj), of(other)
        other.location.x = 1
        bpy.context.view_layer.update()
        assert of(obj) is before[0] and of(other) is before[1]
        obj.vertex_groups[0].add([2], 0.75, "REPLACE")
        bpy.context.view_layer.update()
        assert of(obj)[:, 0].tolist() == [0.5, 0.5, 0.75, 0.5] and of(other) is before[1]
    finally:
        bpy.app.handlers.depsgraph_update_post.remove(forget)
    weights.begin(bpy.context.evaluated_depsgraph_get())
    assert weights.size() == 0, "it was another depsgraph's"


def test_strokes_in_files_have_what_is_painted(scene, tmp_path):
    plane().color = (0, 0, 1, 1)
    take(scene, "color", "OBJECT")
    path = tmp_path / "blue.svg"
    assert bpy.ops.fovea.export_vectors(filepath=str(path), kind="svg") == {"FINISHED"}
    assert "#0000ff" in path.read_text() and "#000000" not in path.read_text()


def test_baked_strokes_have_what_is_painted(scene):
    obj = plane()
    group(obj, ramp(obj))
    for member in ("width", "opacity"):
        take(scene, member, "VERTEX_GROUP")
    assert bpy.ops.fovea.bake_strokes(kind="MESH") == {"FINISHED"}
    baked = next(each for each in scene.objects if "opacity" in getattr(each.data, "attributes", ()))
    mesh = baked.data
    opacity, radius, at = (np.empty(len(mesh.vertices) * n, np.float32) for n in (1, 1, 3))
    mesh.attributes["opacity"].data.foreach_get("value", opacity)
    mesh.vertices.foreach_get("co", at)
    np.testing.assert_allclose(opacity, 0.5 + 0.25 * at[::3] / 3, atol=0.01)
