# SPDX-License-Identifier: GPL-3.0-or-later
"""Match Freestyle: settings of Freestyle's line sets and line styles are converted to Fovea's."""

import math
import sys
from pathlib import Path
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from pictures import box_scene, drawn, ink
from the_addon import part

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import draw
import ending

freestyle, properties, style = part("style.freestyle"), part("render.properties"), part("style")


@pytest.fixture
def scene():
    scene = box_scene()
    scene.render.use_freestyle = True
    settings = scene.view_layers[0].freestyle_settings
    while settings.linesets:
        settings.linesets.remove(settings.linesets[0])
    return scene


def add_set(scene, name="Set", edges=("silhouette", "crease", "border"), **line_style):
    found = scene.view_layers[0].freestyle_settings.linesets.new(name)
    if found.linestyle is None:
        found.linestyle = bpy.data.linestyles.new(name)
    for word in freestyle.KINDS:
        setattr(found, f"select_{word}", word in edges)
    for key, value in line_style.items():
        setattr(found.linestyle, key, value)
    return found


def matched(scene):
    return freestyle.style_of(scene, scene.view_layers[0])


def test_edge_types(scene):
    add_set(scene, edges=("silhouette", "crease", "edge_mark", "ridge_valley"))
    scene.view_layers[0].freestyle_settings.crease_angle = math.radians(150)
    chosen, told = matched(scene)
    kinds = chosen.line_sets[0].kinds
    assert set(kinds) == {"contour", "border", "crease", "edge_mark", "ridge", "valley"} and told == []
    assert kinds["crease"]["angle"] == pytest.approx(30, abs=1e-4) and kinds["border"] == {"loose": 0.0}


def test_pens(scene):
    add_set(scene, color=(0.8, 0.1, 0.2), alpha=0.5, thickness=4.0, caps="BUTT")
    scene.render.line_thickness_mode = "RELATIVE"
    pen = matched(scene)[0].line_sets[0].pen
    assert pen.color == pytest.approx((0.8, 0.1, 0.2)) and pen.opacity == 0.5 and pen.cap == "round"
    assert (pen.width, pen.width_unit) == (9.0, "reference")  # 4 pixels of an image 480 high
    scene.render.line_thickness_mode, scene.render.line_thickness = "ABSOLUTE", 1.5
    pen = matched(scene)[0].line_sets[0].pen
    assert (pen.width, pen.width_unit) == (6.0, "pixels")


@pytest.mark.parametrize(
    "visibility, visible, hidden",
    [("VISIBLE", True, None), ("HIDDEN", False, (1, None)), ("RANGE", True, (1, 3))],
)
def test_visibility(scene, visibility, visible, hidden):
    line_set = add_set(scene, alpha=0.5)
    line_set.select_by_visibility, line_set.visibility = True, visibility
    line_set.qi_start, line_set.qi_end = 0, 3
    found = matched(scene)[0].line_sets[0]
    assert (found.pen.opacity > 0) == visible
    assert [(h.first, h.last) for h in found.hidden] == ([hidden] if hidden else [])


def test_what_is_not_taken_over_is_told(scene):
    line_set = add_set(scene)
    line_set.edge_type_negation = "EXCLUSIVE"
    line_set.linestyle.thickness_modifiers.new("Tangent", "TANGENT")
    line_set.linestyle.thickness_modifiers.new("Off", "CREASE_ANGLE").use = False
    line_set.linestyle.alpha_modifiers.new("Along", "ALONG_STROKE").blend = "DIVIDE"
    line_set.linestyle.geometry_modifiers.new("Bezier", "BEZIER_CURVE")
    told = matched(scene)[1]
    assert "'Set': the thickness modifier 'Tangent'" in told and "'Set': the alpha modifier 'Along'" in told
    assert "'Set': geometry modifiers" in told and not any("Off" in what for what in told)
    assert "'Set': lines that are not of its edge types" in told


def test_a_line_set_whose_line_style_is_gone_is_told_and_the_others_are_taken_over(scene):
    add_set(scene)
    bpy.data.linestyles.remove(add_set(scene, "Bare").linestyle)
    chosen, told = matched(scene)
    assert [line_set.name for line_set in chosen.line_sets] == ["Set"]
    assert told == ["'Bare': it has no line style"]


def with_modifier(scene, words, kind, **settings):
    """The modifier of a line style that is 4 pixels thick."""
    scene.render.line_thickness_mode = "ABSOLUTE"
    line_style = (scene.view_layers[0].freestyle_settings.linesets or [add_set(scene, thickness=4.0)])[0].linestyle
    modifier = getattr(line_style, f"{words}_modifiers").new(kind.title(), kind)
    for name, value in settings.items():
        setattr(modifier, name, value)
    return modifier


def pen_of(scene):
    chosen, told = matched(scene)
    assert told == []
    return chosen.line_sets[0].pen


def test_thickness_along_the_stroke_is_taken_over(scene):
    along = with_modifier(scene, "thickness", "ALONG_STROKE", mapping="CURVE", value_min=1.0, value_max=5.0)
    along.curve.curves[0].points.new(0.5, 1.0)
    along.curve.curves[0].points[2].location[1] = 0.5
    for point in along.curve.curves[0].points:
        point.handle_type = "AUTO_CLAMPED"
    pen = pen_of(scene)
    assert pen.width == 5.0 and pen.along_width.strength == 1.0  # widest in the middle, 1 at the start, 3 at the end
    assert np.allclose(pen.along_width.curve, ((0.0, 0.8), (0.5, 0.0), (1.0, 0.4)))
    along.influence, along.mapping, along.invert = 0.5, "LINEAR", True
    pen = pen_of(scene)
    assert pen.width == 4.5 and np.allclose(pen.along_width.curve, ((0.0, 0.0), (1.0, 2 / 4.5)))


def test_calligraphy_is_a_nib(scene):
    nib = with_modifier(
        scene, "thickness", "CALLIGRAPHY", orientation=math.radians(60), thickness_min=1.0, thickness_max=8.0
    )
    pen = pen_of(scene)
    assert (pen.width, pen.nib_width) == (8.0, 0.875) and pen.nib_angle == pytest.approx(60)
    nib.thickness_min, nib.thickness_max = 8.0, 2.0  # thin across
    pen = pen_of(scene)
    assert (pen.width, pen.nib_width) == (8.0, 0.75) and pen.nib_angle == pytest.approx(150)


def test_distance_from_the_camera_is_taken_over(scene):
    far = {"range_min": 2.0, "range_max": 9.0}
    with_modifier(scene, "thickness", "DISTANCE_FROM_CAMERA", **far, invert=True, value_min=1.0, value_max=4.0)
    with_modifier(scene, "alpha", "DISTANCE_FROM_CAMERA", **far, invert=True)
    pen = pen_of(scene)
    assert (pen.distance_near, pen.distance_far, pen.distance_width, pen.distance_opacity) == (2.0, 9.0, 0.75, 1.0)


def test_lines_that_widen_with_distance_do_so_here(scene):
    thick = with_modifier(scene, "thickness", "DISTANCE_FROM_CAMERA", range_min=2.0, range_max=9.0, value_max=4.0)
    pen = pen_of(scene)
    assert (pen.distance_near, pen.distance_far, pen.width, pen.distance_width) == (9.0, 2.0, 4.0, 1.0)
    with_modifier(scene, "alpha", "DISTANCE_FROM_CAMERA", range_min=3.0, range_max=9.0)
    assert matched(scene)[1] == ["'Set': the alpha modifier 'Distance_From_Camera'"], "there is one range"
    thick.use = False
    assert matched(scene)[1] == []


def test_noise_is_taken_over(scene):
    with_modifier(scene, "thickness", "NOISE", amplitude=1.0, period=20.0, seed=7)
    scene.render.resolution_y = 540
    pen = pen_of(scene)
    assert (pen.width, pen.noise_width, pen.seed) == (5.0, pytest.approx(0.4), 7.0)
    assert pen.noise_length == pytest.approx(20 / 540 * style.Paper().height_mm)


def test_colors_along_the_stroke_are_taken_over(scene):
    ramp = with_modifier(scene, "color", "ALONG_STROKE").color_ramp
    ramp.elements[0].position, ramp.elements[0].color = 0.25, (1, 0, 0, 1)
    ramp.elements[1].color = (0, 0, 1, 1)
    pen = pen_of(scene)
    assert (pen.color, pen.second_color) == ((1, 0, 0), (0, 0, 1))
    assert (pen.along_color.start, pen.along_color.end, pen.along_color.strength) == (0.25, 1.0, 1.0)
    with_modifier(scene, "color", "NOISE")
    ramp.elements.new(0.5)
    assert matched(scene)[1] == [
        "'Set': the colors between the first and the last of the color modifier 'Along_Stroke'",
        "'Set': the color modifier 'Noise'",
    ]


def test_style_modules_and_textures_are_told(scene):
    line_set = add_set(scene)
    line_set.linestyle.texture_slots.add().texture = bpy.data.textures.new("Grain", "NOISE")
    scene.view_layers[0].freestyle_settings.mode = "SCRIPT"
    told = matched(scene)[1]
    assert "the Python style modules, which draw in place of the line sets" in told and "'Set': textures" in told


@pytest.mark.parametrize("negation, outside", [("INCLUSIVE", False), ("EXCLUSIVE", True)])
def test_collections_are_taken_over(scene, negation, outside):
    line_set = add_set(scene)
    line_set.select_by_collection, line_set.collection_negation = True, negation
    assert matched(scene)[0].line_sets[0].collection == "", "none is chosen"
    line_set.collection = bpy.data.collections.new("Trees")
    chosen, told = matched(scene)
    assert (chosen.line_sets[0].collection, chosen.line_sets[0].outside, told) == ("Trees", outside, [])


def test_while_it_is_on_the_panel_and_the_report_say_so_and_a_button_turns_it_off(scene):
    hints, report = part("ui.hints"), part("render.report")

    def told():
        assert bpy.ops.fovea.report() == {"FINISHED"}
        return bpy.data.texts[report.TEXT].as_string()

    scene.view_settings.view_transform = "Standard"
    scene.view_layers[0].use_freestyle = True
    assert hints.RENDER_PT_fovea_hints.poll(bpy.context) and freestyle.OVER in told()
    assert bpy.ops.fovea.freestyle_off() == {"FINISHED"}
    assert not hints.RENDER_PT_fovea_hints.poll(bpy.context) and freestyle.OVER not in told()
    assert not scene.render.use_freestyle and not bpy.ops.fovea.freestyle_off.poll()


@pytest.mark.parametrize("on", [True, False])
def test_while_it_is_on_fovea_draw_notes_how_to_turn_it_off(scene, tmp_path, capfd, on):
    scene.view_layers[0].use_freestyle, file = on, tmp_path / "scene.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(file))
    draw.main([str(file), "--size", "96x54", "-o", str(tmp_path / "picture.png")])
    lines = capfd.readouterr().out.splitlines()
    assert [line for line in lines if line.startswith(ending.NOTE)] == [ending.NOTE + freestyle.OVER] * on
    assert bpy.ops.fovea.freestyle_off.get_rna_type().name in freestyle.OVER


def test_while_it_is_on_renders_report_so_once(scene, monkeypatch):
    session, said = part("render.session"), []
    monkeypatch.setattr(session, "final", lambda *_words, **_more: None)
    engine = SimpleNamespace(
        report=lambda kinds, sentence: said.append((kinds, sentence)), resolution_x=4, resolution_y=4
    )
    session.forget()
    for on in (False, True, True):
        scene.view_layers[0].use_freestyle = on
        session.render(engine, bpy.context.evaluated_depsgraph_get())
    assert said == [({"INFO"}, freestyle.OVER)]


def test_the_scene_draws_with_it(scene, tmp_path):
    add_set(scene, edges=("crease",), color=(1, 0, 0), thickness=6.0)
    scene.render.line_thickness_mode = "RELATIVE"
    assert bpy.ops.fovea.match_freestyle() == {"FINISHED"}
    chosen = properties.style_of(scene)
    (last,) = chosen.line_sets
    assert set(last.kinds) == {"crease"} and last.pen.width == pytest.approx(13.5)
    assert last.kinds["crease"]["angle"] == pytest.approx(
        180 - math.degrees(scene.view_layers[0].freestyle_settings.crease_angle), abs=1e-3
    )
    scene.render.use_freestyle = False
    picture = drawn(scene, tmp_path / "matched.png")
    lined = ink(picture) > 0.5
    assert lined.any() and (picture[lined][:, 0] > 0.9).all() and (picture[lined][:, 1] < 0.4).all()


def test_without_line_sets_it_says_so(scene):
    assert not bpy.ops.fovea.match_freestyle.poll()
    with pytest.raises(RuntimeError, match="no Freestyle line set"):
        bpy.ops.fovea.match_freestyle()
