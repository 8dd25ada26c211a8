# SPDX-License-Identifier: GPL-3.0-or-later
"""A style in a datablock: writing and reading it back, undo, keyframes, drivers, saving, appending and linking."""

import json

import bpy
import numpy as np
import pytest
from pictures import box_scene, drawn, ink, pixels_of
from the_addon import empty_scene, lines_of, own_style, part, use_style

catalogue, properties, style = part("catalogue"), part("render.properties"), part("style")
style_curves, style_data = part("style.style_curves"), part("style.style_data")
style_read = part("style.style_read")


@pytest.fixture
def scene():
    return empty_scene()


def told(chosen):
    """A Style with every parameter of its lines, in the registry's order, as datablocks have it."""
    defaults = {d["name"]: {p["name"]: p["default"] for p in d["parameters"]} for d in catalogue.definitions()}
    sets = (s.replace(kinds={k: defaults[k] | s.kinds[k] for k in defaults if k in s.kinds}) for s in chosen.line_sets)
    return chosen.replace(line_sets=tuple(sets))


def through(chosen):
    """A Style that went into a datablock and came out."""
    return style_read.read(style_data.new("Style", chosen), chosen.focus)


@pytest.mark.parametrize("name", style.names())
def test_a_shipped_style_comes_out_as_it_went_in(scene, name):
    chosen = style.load(name)
    assert through(chosen) == told(chosen)


# Modifiers of a pen.
ALONG = {"second_color": (0.5, 0.1, 0.3), "nib_angle": 30.0, "nib_width": 0.6, "nib_opacity": 0.2, "noise_length": 4.0}
ALONG |= {"paint_width": "vertex_group", "paint_width_name": "Weight.001", "paint_color": "object"}
ALONG |= {"distance_near": 3.0, "distance_far": 2.0, "distance_color": 0.5, "noise_width": 0.7, "noise_opacity": 0.1}


def rich():
    """A Style with something in every field that may be missing."""
    crease = {"crease": {"angle": 33.0}}
    curve, pen = ((0.0, 0.125), (0.3, 0.9), (0.55, 0.2), (1.0, 1.0)), style.Pen(width=0.35, width_unit="millimetres")
    bent = style.Transfer(start=0.9, end=0.1, strength=0.7, curve=curve)
    pen = pen.replace(**ALONG, along_width=bent, along_color=bent.replace(curve=curve[1:]))
    filters = {"collection": "Some of it.001", "outside": True, "object": "Cup", "other_objects": True}
    filters |= {"material": "Glass.001", "other_materials": True}
    numbers = {"corner_angle": 12.5, "least_length": 7.0, "overshoot": 3.0, "halo": 4.0, "overshoot_away": 9.0}
    hidden = (
        style.Hidden(pen=pen, first=1, last=2, pen_away=pen.replace(color=(3.0, 0.2, 0.1))),
        style.Hidden(pen=style.Pen(cap="butt"), first=4),
    )
    pens = {"pen": pen, "pen_away": style.Pen(), "hidden": hidden}
    sets = (
        style.LineSet(name="first", kinds=crease, **filters, **numbers, **pens),
        style.LineSet(name="second", kinds={}, overshoot_away=2.0),
    )
    base = style.Style(paper=style.Paper(texture=style.papers()[-1], transparent=True, height_mm=148.0), line_sets=sets)
    colored = base.replace(color=base.color.replace(shading="toon", bands=5, background=(0.1, 0.2, 0.3)))
    effects = base.effects.replace(width=bent, blur=bent, colors="uniform", uniform=0.3)
    thinned = base.elision.replace(enabled=True, density_attribute="dense", painted=2.5)
    return colored.replace(effects=effects, distance=style.Distance(near=2.0, far=30.0, opacity=bent), elision=thinned)


def test_everything_that_a_style_may_have_comes_out_as_it_went_in(scene):
    chosen = rich()
    found = through(chosen)
    second = found.line_sets[1]
    # A number that differs out of focus brings a pen; that it is the same one is no difference.
    assert (second.overshoot_away, second.pen_away) == (2.0, None)
    assert found == told(chosen)


def test_what_is_not_known_is_kept_with_the_line_set_it_was_said_of(scene):
    words = {"schema": 1, "new": {"a": [1]}, "line_sets": [{"name": "a", "later": 1}, {"name": "b", "pen": {"x": "y"}}]}
    chosen = style.parse(json.dumps(words))
    tree = style_data.new("Style", chosen)
    assert sorted(style_read.read(tree).kept, key=str) == sorted(chosen.kept, key=str)
    tree.fovea.line_sets.move(0, 1)
    paths = {path for path, _ in style_read.read(tree).kept}
    assert paths == {("new",), ("line_sets", 0, "pen", "x"), ("line_sets", 1, "later")}


CURVES = [(), ((0.0, 1.0), (1.0, 0.0)), ((0.25, 0.5), (0.5, 0.75)), tuple((i / 31, (i % 5) / 4) for i in range(32))]


@pytest.mark.parametrize("points", CURVES)
def test_a_curves_points_are_those_of_its_file(scene, points):
    tree = bpy.data.node_groups.new("Curve", "ShaderNodeTree")
    for _ in range(2):  # a node that is there is written over
        style_curves.write(tree, "effects", "width", points)
        found = style_curves.read(tree, "effects", "width")
        assert len(found) == len(points) and np.allclose(found, points, atol=1e-6)
    assert len(tree.nodes) == 1


def test_a_single_point_holds_everywhere(scene):
    tree = bpy.data.node_groups.new("Curve", "ShaderNodeTree")
    style_curves.write(tree, "effects", "width", ((0.4, 0.3),))
    assert np.allclose(style_curves.read(tree, "effects", "width"), ((0.0, 0.3), (1.0, 0.3)))


CORNERS = ((0.0, 0.0), (0.3, 0.9), (0.5, 0.2), (1.0, 1.0))


BENT = ((0.0, 0.0), (0.2, 0.1), (0.7, 0.9), (1.0, 0.8))


@pytest.mark.parametrize("handle, points, most", [("VECTOR", CORNERS, 8), ("AUTO", BENT, 20)])
def test_what_blender_shows_of_other_handles_is_what_is_drawn(scene, handle, points, most):
    tree = bpy.data.node_groups.new("Curve", "ShaderNodeTree")
    style_curves.write(tree, "effects", "width", points)
    mapping = tree.nodes["effects.width"].mapping
    for point in mapping.curves[0].points:
        point.handle_type = handle
    mapping.update()
    found = style_curves.read(tree, "effects", "width")
    x = np.linspace(0, 1, 257)
    shown = np.clip([mapping.evaluate(mapping.curves[0], v) for v in x], 0, 1)
    if handle == "VECTOR":
        shown = np.interp(x, *zip(*CORNERS))  # Blender's table rounds corners off by a step of it
        for corner in CORNERS:
            assert np.abs(np.array(found) - corner).max(axis=1).min() < 1e-6, "its own points stay"
    off = np.abs(part("native").load().monotone_cubic(found, x) - shown).max()
    assert off < 1e-3, off
    assert len(found) <= most, len(found)
    # What is written to a file and comes back is the same curve.
    style_curves.write(tree, "effects", "width", found)
    again = style_curves.read(tree, "effects", "width")
    assert np.allclose(again, found, atol=1e-6)


def test_a_style_survives_without_its_curves_and_with_odd_numbers(scene):
    held = use_style(scene, rich())
    tree = scene.fovea.style
    tree.nodes.clear()
    held.distance.near, held.distance.far = 50.0, 10.0
    for field in style.Elision.fields:
        if field["group"] == "weights":
            setattr(held.elision, field["name"], 0.0)
    hidden = held.line_sets[0].hidden
    hidden[0].first, hidden[0].last, hidden[1].first, hidden[1].last = 2, 0, 3, 1
    found = properties.style_of(scene)
    assert style.parse(style.dump(found.replace(kept=())))
    assert found.effects.width.curve == () and found.distance.far > found.distance.near
    assert [(h.first, h.last) for h in found.line_sets[0].hidden] == [(2, 2), (3, 3)]


def test_a_style_brings_its_focus_and_one_without_leaves_the_scenes(scene):
    looked = style.Focus(model="image", points=(style.FocusPlace(at=(0.25, 0.75, 0.0), near=0.2, far=0.4),))
    use_style(scene, rich().replace(focus=looked))
    use_style(scene, "pencil")
    assert scene.fovea.focus_model == "IMAGE"
    assert properties.style_of(scene).focus.points[0].at == pytest.approx((0.25, 0.75, 0))


def test_only_what_nobody_misses_goes_when_another_style_comes(scene):
    use_style(scene, "pencil")
    use_style(scene, "charcoal")
    assert len(bpy.data.node_groups) == 1
    lines_of(scene).pen.width = 9.5
    edited = scene.fovea.style
    use_style(scene, "technical")
    assert set(bpy.data.node_groups) == {edited, scene.fovea.style}


def test_each_pen_has_curves_of_its_own_that_go_with_it(scene):
    held = use_style(scene, rich())
    tree = scene.fovea.style
    # The first set's pen, its two hidden pens out of focus included: each with a bent width and color.
    parts = {pen.curves for pen in style_curves.pens(held)} - {""}
    curves = {name for part in parts for name in (f"{part}.along_width", f"{part}.along_color")}
    assert len(parts) == 3 and {node.name for node in tree.nodes if node.name.startswith("pen")} == curves
    held.line_set_index = 0
    assert bpy.ops.fovea.line_set_duplicate() == {"FINISHED"}
    first, copy = held.line_sets[:2]
    assert copy.pen.curves not in {"", *parts} and style_read.pen(copy.pen) == style_read.pen(first.pen)
    tree.nodes[f"{copy.pen.curves}.along_width"].mapping.curves[0].points[0].location[1] = 0.75
    assert style_read.pen(first.pen) == rich().line_sets[0].pen != style_read.pen(copy.pen)
    assert bpy.ops.fovea.line_set_remove() == {"FINISHED"}
    assert {node.name for node in tree.nodes if node.name.startswith("pen")} == curves
    path = held.line_sets[1].pen.path_from_id()
    assert bpy.ops.fovea.pen_curve_add(pen=path, effect="along_opacity") == {"FINISHED"}
    added = held.line_sets[1].pen
    assert tree.nodes[f"{added.curves}.along_opacity"] and style_read.pen(added).along_opacity.curve == ()


def test_edits_are_undone_and_redone(scene):
    use_style(scene, "pencil")
    bpy.ops.ed.undo_push(message="style")
    widths = [lines_of(scene).pen.width]
    for step in range(3):
        lines_of(bpy.context.scene).pen.width = widths[0] + 1 + step
        bpy.ops.ed.undo_push(message="width")
        widths.append(lines_of(bpy.context.scene).pen.width)
    for width in widths[-2::-1]:
        bpy.ops.ed.undo()
        assert lines_of(bpy.context.scene).pen.width == width
    for width in widths[1:]:
        bpy.ops.ed.redo()
        assert lines_of(bpy.context.scene).pen.width == width


def test_a_scene_goes_over_into_another_style_as_keyed(tmp_path):
    scene = box_scene()
    use_style(scene, "plain").line_sets[-1].pen.opacity = 1.0
    other = style_data.new("Faint", style.load("plain"))
    other.fovea.line_sets[-1].pen.opacity, other.fovea.paper.color = 0.0, (0.5, 0.5, 0.5)
    assert properties.style_of(scene) == style_read.read(scene.fovea.style)
    scene.fovea.mixed_style = other
    assert properties.style_of(scene).paper.color == (1.0, 1.0, 1.0)
    for frame, mixed in ((1, 0.0), (3, 1.0)):
        scene.fovea.mix = mixed
        scene.fovea.keyframe_insert("mix", frame=frame)
    ink_left, papers = [], []
    for frame in (1, 2, 3):
        scene.frame_set(frame)
        picture = drawn(scene, tmp_path / f"{frame}.png")
        papers.append(picture[0, 0, 0])
        ink_left.append(papers[-1] - picture[..., :3].min())
    assert papers[0] == 1.0 > papers[1] > papers[2]
    assert ink_left[0] > 1.5 * ink_left[1] > 0.05 and ink_left[2] < 0.01
    assert properties.style_of(scene).paper.color == (0.5, 0.5, 0.5)


def test_keyed_and_driven_numbers_arrive_in_the_pictures_of_an_animation(tmp_path):
    scene = box_scene()
    pen, tree = lines_of(scene).pen, scene.fovea.style
    for frame, width in ((1, 10.0), (3, 50.0)):
        pen.width = width
        pen.keyframe_insert("width", frame=frame)
    for channel in range(3):
        driver = tree.driver_add("fovea.paper.color", channel).driver
        driver.expression = "frame / 4"
    scene.frame_set(1)
    scene.frame_start, scene.frame_end = 1, 3
    scene.render.image_settings.file_format, scene.render.image_settings.color_mode = "PNG", "RGBA"
    scene.render.filepath = str(tmp_path / "frame_")
    bpy.ops.render.render(animation=True)
    pictures = [pixels_of(tmp_path / f"frame_{frame:04}.png") for frame in (1, 2, 3)]
    gray = [picture[0, 0, 0] for picture in pictures]
    linear = [((v + 0.055) / 1.055) ** 2.4 for v in gray]
    assert linear == pytest.approx([0.25, 0.5, 0.75], abs=0.01)
    covered = [np.mean(ink(p) > 0.5 * (1 + ink(p)[0, 0])) for p in pictures]
    assert covered[0] < 0.75 * covered[1] < 0.7 * covered[2]
    scene.frame_set(2)
    np.testing.assert_array_equal(drawn(scene, tmp_path / "alone.png"), pictures[1])


@pytest.mark.parametrize("link", [False, True])
def test_a_style_of_another_file_draws_as_it_did_there(scene, tmp_path, link):
    use_style(scene, rich())
    scene.fovea.style.name = "Rich"
    expected = style_read.read(scene.fovea.style)
    path = str(tmp_path / "library.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    scene = empty_scene()
    with bpy.data.libraries.load(path, link=link) as (_, wanted):
        wanted.node_groups = ["Rich"]
    scene.fovea.style = bpy.data.node_groups["Rich"]
    assert style_read.read(scene.fovea.style) == expected
    assert bool(scene.fovea.style.library) == link
    assert bpy.ops.fovea.line_set_add.poll() == (not link)
    assert bpy.ops.fovea.style_duplicate() == {"FINISHED"}
    assert scene.fovea.style.library is None and style_read.read(scene.fovea.style) == expected


def test_other_node_trees_are_no_styles(scene):
    other = bpy.data.node_groups.new("Other", "GeometryNodeTree")
    assert not style_data.is_style(other)
    scene.fovea.style = other
    assert properties.style_of(scene) == style.load(style.DEFAULT)
    assert own_style(scene) and scene.fovea.style != other
