# SPDX-License-Identifier: GPL-3.0-or-later
"""Painted attributes, and focus on objects: in renders, and in the Focus pass."""

import bpy
import numpy as np
import pytest
from pictures import drawn, ink, layered, scene_from_above
from the_addon import box_mesh, lines_of, new_mesh, new_object, own_style, use_style

SIZE = (320, 180)
PIXELS = 40  # per unit


@pytest.fixture
def scene():
    """Seen from above, with lines that are thick in focus and gone out of it; no objects."""
    made = scene_from_above(SIZE, PIXELS)
    lines = use_style(made, "plain").line_sets[-1]
    lines.pen.width, lines.away, lines.pen_away.width, lines.pen_away.opacity = 12, True, 12, 0
    return made


def tiles(columns=6, rows=4, size=0.6):
    """Squares side by side that do not touch, around the origin."""
    vertices, polygons = [], []
    for i in range(columns * rows):
        x, y = i % columns - columns / 2 + 0.5, i // columns - rows / 2 + 0.5
        polygons.append(tuple(range(len(vertices), len(vertices) + 4)))
        vertices += [(x + size * (a - 0.5), y + size * (b - 0.5), 0) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return new_mesh(vertices, [], polygons, "Tiles")


def paint(mesh, value, kind="FLOAT", domain="POINT", name="focus"):
    """An attribute from a function of places."""
    places = np.empty((len(mesh.vertices), 3), np.float32)
    mesh.vertices.foreach_get("co", places.ravel())
    values = np.array([value(x, y) for x, y, _ in places], np.float32)
    if domain == "CORNER":
        corners = np.empty(len(mesh.loops), np.int32)
        mesh.loops.foreach_get("vertex_index", corners)
        values = values[corners]
    data = mesh.attributes.new(name, kind, domain).data
    if kind == "FLOAT":
        data.foreach_set("value", values)
    else:
        data.foreach_set("color", np.repeat(values, 4))


def columns(values):
    """Mean of (H, W) within two pixels of a place along x."""
    return lambda x: float(values[:, round(SIZE[0] / 2 + x * PIXELS) + np.arange(-2, 3)].mean())


def left_and_right(values):
    half = SIZE[0] // 2
    return values[:, :half].mean(), values[:, half:].mean()


def focus_pass(scene, tmp_path):
    """(H, W) of the Focus pass, rows from the bottom."""
    (values,) = [v for name, v in layered(scene, tmp_path / "focus.exr").items() if "Focus." in name]
    return values


@pytest.mark.parametrize("kind, domain", [("FLOAT", "POINT"), ("FLOAT", "CORNER"), ("BYTE_COLOR", "CORNER")])
def test_half_of_a_mesh_is_painted_in_focus(scene, tmp_path, kind, domain):
    mesh = tiles()
    paint(mesh, lambda x, y: float(x < 0), kind, domain)
    new_object(mesh, "Tiles")
    scene.fovea.focus_model = "PAINTED"
    left, right = left_and_right(ink(drawn(scene, tmp_path / "half.png")))
    assert left > 0.05 and right < 1e-3
    scene.fovea.focus_attribute = "another"
    left, right = left_and_right(ink(drawn(scene, tmp_path / "none.png")))
    assert left == pytest.approx(right, rel=0.05) and left > 0.02


def test_what_is_not_painted_is_half_in_focus(scene, tmp_path):
    new_object(tiles(), "Tiles")
    scene.fovea.focus_model = "PAINTED"
    bare = drawn(scene, tmp_path / "bare.png")
    effects = own_style(scene).effects
    scene.fovea.focus_model, effects.lines, effects.uniform = "NONE", "UNIFORM", 0.5
    np.testing.assert_array_equal(bare, drawn(scene, tmp_path / "uniform.png"))


def test_the_focus_pass_has_what_is_painted(scene, tmp_path):
    mesh = new_mesh([(x, y, 0) for x, y in ((-3, -1), (3, -1), (3, 1), (-3, 1))], [], [(0, 1, 2, 3)])
    paint(mesh, lambda x, y: 0.5 + x / 6)
    new_object(mesh, "Ramp")
    scene.fovea.focus_model = "PAINTED"
    found = focus_pass(scene, tmp_path)
    x = (np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) / PIXELS
    inside = np.abs(x) < 2.9
    np.testing.assert_allclose(found[SIZE[1] // 2, inside], 0.5 - x[inside] / 6, atol=2e-3)
    assert np.all(found[:20] == 1)  # nothing is there
    scene.fovea.focus_model = "NONE"
    assert not any("Focus." in name for name in layered(scene, tmp_path / "without.exr"))


def test_paint_follows_a_mesh_that_is_subdivided_or_refined(scene, tmp_path):
    mesh = new_mesh(
        [(x, y, 0) for y in (-2, 2) for x in (-3, -0.5, 0.5, 3)], [], [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6)]
    )
    paint(mesh, lambda x, y: float(x < 0), "FLOAT_COLOR")
    square = new_object(mesh, "Square")
    square.modifiers.new("Subdivision", "SUBSURF").render_levels = 3
    scene.fovea.focus_model = "PAINTED"
    for refine in (False, True):
        square.fovea.refine = refine
        middle = focus_pass(scene, tmp_path)[SIZE[1] // 2]
        at = [middle[SIZE[0] // 2 + round(x * PIXELS)] for x in (-1.5, 0, 1.5)]
        assert at[0] < 0.05 and 0.3 < at[1] < 0.7 and at[2] > 0.95, refine


def two_boxes(scene):
    """A box at the left that is an instance of one at the right, which lies in a collection of its own."""
    collection = bpy.data.collections.new("Boxes")
    scene.collection.children.link(collection)
    box = new_object(box_mesh(0.5), "Box", (2.5, 0, 0), collection)
    instancer = new_object(None, "Instancer", (-5, 0, 0))
    instancer.instance_type, instancer.instance_collection = "COLLECTION", collection
    new_object(box_mesh(0.5), "Middle")
    scene.fovea.focus_model = "OBJECT"
    scene.fovea.focus_near_distance, scene.fovea.focus_far_distance = 0.1, 1.4
    return box, instancer


def test_an_object_and_its_instances_are_in_focus(scene, tmp_path):
    box, instancer = two_boxes(scene)

    def seen(obj):
        scene.fovea.focus_object = obj
        at = columns(ink(drawn(scene, tmp_path / "boxes.png")))
        return [at(x) > 0.05 for x in (-3, 0.5, 3)]

    assert seen(box) == [True, False, True]
    assert seen(instancer) == [True, False, False]
    assert seen(bpy.data.objects["Middle"]) == [False, True, False]


def test_focus_falls_off_from_the_surface(scene, tmp_path):
    box, _ = two_boxes(scene)
    new_object(new_mesh([(x, y, 0.5) for x, y in ((-4, -2), (4, -2), (4, 2), (-4, 2))], [], [(0, 1, 2, 3)]), "Floor")
    scene.fovea.focus_object = bpy.data.objects["Middle"]
    middle = focus_pass(scene, tmp_path)[SIZE[1] // 2]
    x = np.abs((np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) / PIXELS)
    expected = np.clip((x - 0.5 - 0.1) / 1.3, 0, 1)
    np.testing.assert_allclose(middle[x > 0.5], expected[x > 0.5], atol=2e-3)


def test_without_a_surface_an_objects_origin_is_the_place(scene, tmp_path):
    two_boxes(scene)
    scene.fovea.focus_object = new_object(None, "Empty", (0, 0, 0.5))
    top = focus_pass(scene, tmp_path)[SIZE[1] // 2, SIZE[0] // 2]
    assert top == pytest.approx(0, abs=0.01)


@pytest.fixture
def crowded(scene):
    """Two squares whose sides, six pixels apart, want to be twenty: left and right."""
    lines, elision = lines_of(scene), own_style(scene).elision
    lines.away, lines.pen.width, lines.pen.spacing, elision.enabled = False, 12, 120, True
    gap = 3 / PIXELS
    left = new_mesh([(x, y, 0) for x, y in ((-3, -1.5), (-gap, -1.5), (-gap, 1.5), (-3, 1.5))], [], [(0, 1, 2, 3)])
    right = new_mesh([(x, y, 0) for x, y in ((gap, -1.5), (3, -1.5), (3, 1.5), (gap, 1.5))], [], [(0, 1, 2, 3)])
    new_object(left, "Left"), new_object(right, "Right")
    return scene, left, right


def sides(scene, tmp_path):
    """Ink of the two sides that are near each other."""
    at = ink(drawn(scene, tmp_path / "crowded.png"))[SIZE[1] // 2 - 30 : SIZE[1] // 2 + 30]
    half = SIZE[0] // 2
    return at[:, half - 5 : half - 1].mean(), at[:, half + 1 : half + 5].mean()


@pytest.mark.parametrize("favoured", [0, 1])
def test_of_lines_that_crowd_those_painted_white_stay(crowded, tmp_path, favoured):
    scene, *meshes = crowded
    for side, mesh in enumerate(meshes):
        paint(mesh, lambda x, y: float(side == favoured), name="wanted")
    own_style(scene).elision.priority_attribute = "wanted"
    own_style(scene).elision.painted = 5
    found = sides(scene, tmp_path)
    assert found[favoured] > 0.3 and found[1 - favoured] < 0.1


def test_lines_are_as_dense_as_is_painted(crowded, tmp_path):
    scene, *meshes = crowded
    for mesh in meshes:
        paint(mesh, lambda x, y: 0.0, name="black")
        paint(mesh, lambda x, y: 1.0, name="white")
        paint(mesh, lambda x, y: 0.5, name="gray")
    bare = sides(scene, tmp_path)
    inks = {}
    for name in ("black", "gray", "white"):
        own_style(scene).elision.density_attribute = name
        inks[name] = sides(scene, tmp_path)
    assert min(inks["white"]) > 0.3 and min(inks["black"]) < 0.1
    assert inks["gray"] == bare


def test_lines_are_as_dense_as_an_image_says(crowded, tmp_path):
    scene, *_ = crowded
    bare = sides(scene, tmp_path)
    image = bpy.data.images.new("Map", 4, 4, float_buffer=True)
    own_style(scene).elision.density_image = image
    inks = {}
    for value in (0.0, 1.0):
        image.pixels.foreach_set(np.array([value, value, value, 1] * 16, np.float32))
        image.update()
        inks[value] = sides(scene, tmp_path)
    assert min(inks[1.0]) > 0.3 and min(inks[0.0]) < 0.1
    own_style(scene).elision.density_image = None
    assert sides(scene, tmp_path) == bare
