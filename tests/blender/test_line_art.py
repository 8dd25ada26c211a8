# SPDX-License-Identifier: GPL-3.0-or-later
"""Match Line Art: settings of Line Art modifiers are converted to Fovea's."""

import math

import bpy
import pytest
from pictures import box_scene, drawn, ink
from the_addon import box_mesh, new_object, part

line_art, properties = part("style.line_art"), part("render.properties")
of_objects = part("style.line_art_usage").usages


@pytest.fixture
def scene():
    return box_scene()


def add_modifier(scene, source="SCENE", color=(0, 0, 0, 1), **settings):
    pencils = bpy.data.grease_pencils_v3 if hasattr(bpy.data, "grease_pencils_v3") else bpy.data.grease_pencils
    obj = bpy.data.objects.new("Lines", pencils.new("Lines"))
    scene.collection.objects.link(obj)
    obj.data.layers.new("Lines").frames.new(scene.frame_current)
    material = bpy.data.materials.new("Ink")
    bpy.data.materials.create_gpencil_data(material)
    material.grease_pencil.color = color
    obj.data.materials.append(material)
    modifier = obj.modifiers.new("Line Art", "LINEART")
    modifier.source_type, modifier.target_layer, modifier.target_material = source, "Lines", material
    for name, value in settings.items():
        setattr(modifier, name, value)
    return modifier


def set_width(modifier, width):
    """Sets the width of strokes in space."""
    if hasattr(modifier, "radius"):
        modifier.radius = width
    else:
        modifier.thickness = round(width * 1000)


def matched(scene):
    return line_art.style_of(scene, bpy.context.evaluated_depsgraph_get())


def test_edge_types_and_the_crease_angle(scene):
    add_modifier(scene, use_material=True, use_loose=False, crease_threshold=math.radians(150))
    chosen, told = matched(scene)
    kinds = chosen.line_sets[0].kinds
    assert set(kinds) == {"contour", "border", "crease", "intersection", "material_boundary", "edge_mark"}
    assert kinds["crease"]["angle"] == pytest.approx(30, abs=1e-4) and told == []
    assert kinds["border"] == {"loose": 0.0}
    add_modifier(scene, use_loose=True)
    assert matched(scene)[0].line_sets[1].kinds["border"] == {"loose": 1.0}


def test_lines_by_a_light_are_those_by_the_lights_of_the_scene(scene):
    for obj in [obj for obj in scene.objects if obj.type == "LIGHT"]:
        bpy.data.objects.remove(obj)
    add_modifier(scene, use_light_contour=True, use_shadow=True)
    assert not {"light_contour", "cast_shadow"} & set(matched(scene)[0].line_sets[0].kinds), "no light is named"
    lamp = new_object(bpy.data.lights.new("Lamp", "POINT"), "Lamp")
    modifier = add_modifier(scene, use_light_contour=True, use_shadow=True, light_contour_object=lamp)
    chosen, told = matched(scene)
    assert {"light_contour", "cast_shadow"} <= set(chosen.line_sets[1].kinds) and told == []
    modifier.light_contour_object = bpy.data.objects["Box"]
    assert any("lines by 'Box' alone: they are by the lights of the scene" in words for words in matched(scene)[1])


def test_the_silhouette_alone(scene):
    add_modifier(scene, silhouette_filtering="INDIVIDUAL")
    kinds = matched(scene)[0].line_sets[0].kinds
    assert "silhouette" in kinds and "contour" not in kinds


@pytest.mark.parametrize(
    "levels, visible, hidden",
    [
        ((False, 0, 0), True, None),
        ((False, 2, 5), False, (2, 2)),
        ((True, 0, 3), True, (1, 3)),
        ((True, 1, 2), False, (1, 2)),
    ],
)
def test_levels_are_numbers_of_surfaces_in_front(scene, levels, visible, hidden):
    modifier = add_modifier(scene)
    modifier.use_multiple_levels, modifier.level_start, modifier.level_end = levels
    found = matched(scene)[0].line_sets[0]
    assert (found.pen.opacity > 0) == visible
    assert [(h.first, h.last) for h in found.hidden] == ([hidden] if hidden else [])


def test_the_source_is_a_filter(scene):
    collection = bpy.data.collections.new("Trees")
    add_modifier(scene, "COLLECTION", source_collection=collection, use_invert_collection=True)
    add_modifier(scene, "OBJECT", source_object=bpy.data.objects["Box"])
    add_modifier(scene, "COLLECTION")
    chosen, told = matched(scene)
    first, second = chosen.line_sets
    assert (first.collection, first.outside, first.object) == ("Trees", True, "")
    assert (second.collection, second.object) == ("", "Box")
    assert len(told) == 1 and "has no source" in told[0]


def test_the_width_is_that_of_its_strokes_in_the_picture(scene):
    """At the distance of the box, whose middle is the origin."""
    modifier = add_modifier(scene)
    set_width(modifier, 0.02)
    camera = scene.camera
    bpy.context.view_layer.update()
    distance = (camera.matrix_world.inverted() @ bpy.data.objects["Box"].matrix_world.translation).z
    corners = camera.data.view_frame(scene=scene)
    height = abs((corners[0].y - corners[2].y) / corners[0].z) * -distance
    expected = 0.02 / height * 1080
    assert matched(scene)[0].line_sets[0].pen.width == pytest.approx(expected, rel=0.01)


def test_what_is_not_taken_over_is_told(scene):
    modifier = add_modifier(scene, use_face_mark=True)
    modifier.id_data.modifiers.new("Shaky", "GREASE_PENCIL_NOISE")
    told = matched(scene)[1]
    assert any("face marks" in words for words in told)
    assert any("the modifiers Shaky" in words for words in told)


def test_modifiers_that_renders_do_not_show_are_left_out(scene):
    add_modifier(scene).show_render = False
    add_modifier(scene).id_data.hide_render = True
    assert not bpy.ops.fovea.match_line_art.poll()
    with pytest.raises(RuntimeError, match="no Line Art modifier"):
        bpy.ops.fovea.match_line_art()


def test_the_scene_draws_with_it(scene, tmp_path):
    modifier = add_modifier(scene, color=(1, 0, 0, 1))
    set_width(modifier, 0.05)
    assert bpy.ops.fovea.match_line_art() == {"FINISHED"}
    (found,) = properties.style_of(scene).line_sets
    assert found.pen.color == pytest.approx((1, 0, 0)) and found.pen.width > 2
    assert part("ui.hints").RENDER_PT_fovea_hints.poll(bpy.context), "Blender draws its strokes over the picture"
    assert bpy.ops.fovea.line_art_off() == {"FINISHED"} and not bpy.ops.fovea.line_art_off.poll()
    assert not part("ui.hints").RENDER_PT_fovea_hints.poll(bpy.context)
    picture = drawn(scene, tmp_path / "matched.png")
    lined = ink(picture) > 0.5
    assert lined.any() and (picture[lined][:, 0] > 0.9).all() and (picture[lined][:, 1] < 0.4).all()


def test_width_and_opacity_along_strokes_are_taken_over(scene):
    obj = add_modifier(scene).id_data
    width = matched(scene)[0].line_sets[0].pen.width
    thick = obj.modifiers.new("Thick", "GREASE_PENCIL_THICKNESS")
    thick.use_custom_curve, thick.thickness_factor = True, 2.0
    fade = obj.modifiers.new("Fade", "GREASE_PENCIL_OPACITY")
    fade.color_factor = 0.5
    chosen, told = matched(scene)
    pen = chosen.line_sets[0].pen
    assert told == [] and pen.width == pytest.approx(2 * width) and pen.opacity == pytest.approx(0.5)
    assert pen.along_width.curve == ((0.0, 1.0), (1.0, 0.0)) and pen.along_opacity.strength == 0.0
    obj.modifiers.new("Again", "GREASE_PENCIL_THICKNESS")
    thick.use_uniform_thickness = True  # a width in space
    assert matched(scene)[1] == ["'Lines: Line Art': the modifiers Thick"]


@pytest.fixture
def excluded(scene):
    """A collection of the scene that Line Art excludes."""
    made = bpy.data.collections.new("Excluded")
    scene.collection.children.link(made)
    made.lineart_usage = "EXCLUDE"
    return made


@pytest.mark.parametrize("usage, fovea", [("EXCLUDE", "IGNORE"), ("OCCLUSION_ONLY", "OCCLUDE"), ("INCLUDE", "BOTH")])
def test_usages_of_objects_and_of_their_collections_are_taken_over(scene, excluded, usage, fovea):
    own, inherits = new_object(box_mesh(), "Own"), new_object(box_mesh(), "Inherits", collection=excluded)
    own.lineart.usage = excluded.lineart_usage = usage
    inherits.fovea.usage = "BOTH"
    add_modifier(scene)
    assert bpy.ops.fovea.match_line_art() == {"FINISHED"}
    assert (own.fovea.usage, inherits.fovea.usage) == (fovea, fovea)


def test_the_usage_of_an_object_goes_before_that_of_its_collection(scene, excluded):
    obj = new_object(box_mesh(), "Own", collection=excluded)
    obj.lineart.usage = "INCLUDE"
    assert of_objects(scene) == ({obj: "BOTH"}, [])


def test_collections_in_a_collection_have_usages_of_their_own(scene, excluded):
    inner = bpy.data.collections.new("Inner")
    excluded.children.link(inner)
    obj = new_object(box_mesh(), "Deep", collection=inner)
    assert of_objects(scene) == ({}, [])
    inner.lineart_usage = "OCCLUSION_ONLY"
    assert of_objects(scene) == ({obj: "OCCLUDE"}, [])


def test_an_object_that_line_art_says_nothing_of_keeps_its_usage(scene):
    bpy.data.objects["Box"].fovea.usage = "DRAW"
    add_modifier(scene)
    assert bpy.ops.fovea.match_line_art() == {"FINISHED"}
    assert bpy.data.objects["Box"].fovea.usage == "DRAW"


@pytest.mark.parametrize(
    "usage, what",
    [
        ("INTERSECTION_ONLY", "intersection lines alone"),
        ("NO_INTERSECTION", "no intersection lines"),
        ("FORCE_INTERSECTION", "intersection lines with objects that have none"),
    ],
)
def test_usages_that_are_not_taken_over_are_told_with_the_objects_that_have_them(scene, excluded, usage, what):
    excluded.lineart_usage = usage
    for name in "ABCDE":
        new_object(box_mesh(), name, collection=excluded)
    found, told = of_objects(scene)
    assert found == {} and len(told) == 1
    assert told[0].endswith(f" and 2 more: {what}") and told[0].count("'") == 6


def test_the_usage_of_a_linked_object_which_would_be_lost_is_told(scene, tmp_path):
    obj, path = new_object(box_mesh(), "Rock"), str(tmp_path / "rock.blend")
    obj.lineart.usage = "EXCLUDE"
    bpy.data.libraries.write(path, {obj})
    bpy.data.objects.remove(obj)
    with bpy.data.libraries.load(path, link=True) as (_, wanted):
        wanted.objects = ["Rock"]
    scene.collection.objects.link(wanted.objects[0])
    found, told = of_objects(scene)
    assert found == {} and told == ["'Rock': its usage: it is linked from another file, where it can be set"]


def test_a_crease_angle_of_an_object_is_told(scene):
    bpy.data.objects["Box"].lineart.use_crease_override = True
    assert of_objects(scene) == ({}, ["'Box': a crease angle of its own"])


def test_what_usages_leave_is_in_the_report_of_the_operator(scene, capfd):
    bpy.data.objects["Box"].lineart.usage = "NO_INTERSECTION"
    add_modifier(scene)
    assert bpy.ops.fovea.match_line_art() == {"FINISHED"}
    assert "Not taken over: 'Box': no intersection lines" in "".join(capfd.readouterr())
