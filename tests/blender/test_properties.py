# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of scenes and objects, and the kinds of lines of line sets, which are generated from the registry."""

import math
from types import SimpleNamespace

import bpy
import pytest
from the_addon import empty_scene, fovea, lines_of, new_object, own_style, part, use_style

catalogue, properties, style = part("catalogue"), part("render.properties"), part("style")


@pytest.fixture
def scene():
    return empty_scene()


def parameters():
    return [(d["name"], p) for d in catalogue.definitions() for p in d["parameters"]]


def test_every_definition_has_a_switch_that_says_what_the_lines_are_and_whose(scene):
    known = lines_of(scene).kinds.bl_rna.properties
    for definition in catalogue.definitions():
        prop = known[definition["name"]]
        assert (prop.name, prop.type) == (definition["label"], "BOOLEAN")
        assert prop.description == definition["description"]


@pytest.mark.parametrize("definition, parameter", parameters())
def test_every_parameter_is_a_property_with_the_registrys_limits(scene, definition, parameter):
    prop = lines_of(scene).kinds.bl_rna.properties[f"{definition}_{parameter['name']}"]
    assert (prop.name, prop.description) == (parameter["label"], parameter["meaning"])
    if parameter["unit"] == "bool":
        assert (prop.type, prop.default) == ("BOOLEAN", bool(parameter["default"]))
        return
    turn = math.radians if parameter["unit"] == "degrees" else float
    found = (prop.hard_min, prop.default, prop.hard_max)
    assert found == pytest.approx([turn(parameter[key]) for key in ("min", "default", "max")])
    assert (prop.subtype == "ANGLE") == (parameter["unit"] == "degrees")


@pytest.mark.parametrize("definition", [d for d in catalogue.definitions() if d["file"]], ids=lambda d: d["name"])
def test_every_file_is_a_property_of_a_path(scene, definition):
    file = definition["file"]
    prop = lines_of(scene).kinds.bl_rna.properties[f"{definition['name']}_{file['name']}"]
    assert (prop.name, prop.description, prop.subtype) == (file["label"], file["meaning"], "FILE_PATH")
    assert prop.default == ""


def test_an_object_may_do_without_every_definition_that_is_of_objects(scene):
    obj = new_object(bpy.data.meshes.new("Mesh"))
    own_lines, kinds = part("scene.own_lines"), obj.fovea.kinds
    known = kinds.bl_rna.properties
    assert own_lines.of(obj.fovea)[0] == own_lines.ALL_KINDS and math.isnan(own_lines.of(obj.fovea)[1])
    obj.fovea.own_kinds = obj.fovea.own_crease_angle = True
    obj.fovea.crease_angle = math.radians(45)
    assert own_lines.of(obj.fovea) == (own_lines.ALL_KINDS, 45.0)
    for bit, definition in enumerate(catalogue.definitions()):
        name = definition["name"]
        assert (name in known) != definition["in_image"], name
        if name in known:
            assert known[name].name == definition["label"] and definition["description"] in known[name].description
            setattr(kinds, name, False)
            assert own_lines.of(obj.fovea)[0] == own_lines.ALL_KINDS & ~(1 << bit), name
            setattr(kinds, name, True)


def test_a_new_scene_draws_the_default_style_and_no_datablock_is_made(scene):
    assert properties.style_of(scene) == style.load(style.DEFAULT)
    assert not bpy.data.node_groups


def test_fields_that_nothing_reads_are_told_once(scene):
    session, said = part("render.session"), []
    engine = SimpleNamespace(report=lambda kinds, sentence: said.append((kinds, sentence)))
    words = '{"schema": 1, "line_sets": [{"kinds": {"contuor": {}, "crease": {"angel": 3}}, "pen": {"widht": 2}}]}'
    chosen = style.parse(words)
    session.forget()
    for _ in range(3):
        session.report_once(engine, style.remark(chosen))
    session.report_once(engine, style.remark(style.load(style.DEFAULT)))
    ((kinds, sentence),) = said
    assert kinds == {"INFO"}
    for name, near in (("kinds.contuor", "contour"), ("kinds.crease.angel", "angle"), ("pen.widht", "width")):
        assert f"line_sets[0].{name} (is it {near}?)" in sentence


def test_transparent_film_is_transparent_paper(scene):
    assert not properties.style_of(scene).paper.transparent
    scene.render.film_transparent = True
    assert properties.style_of(scene).paper.transparent


def test_settings_are_saved_with_the_file(scene, tmp_path):
    use_style(scene, "charcoal").line_sets[-1].kinds.crease_angle = 1.0
    before = properties.style_of(scene)
    new_object(bpy.data.meshes.new("Mesh")).fovea.usage = "OCCLUDE"
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    empty_scene()
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "scene.blend"))
    assert properties.style_of(bpy.context.scene) == before
    assert bpy.data.objects["Object"].fovea.usage == "OCCLUDE"


def test_choosing_lines_keeps_those_a_line_set_has_and_the_last_one_draws_the_rest(scene):
    held = use_style(scene, "technical")
    part("style.style_data").choose_lines(held, ("silhouette", "crease", "valley"))
    found = {line_set.name: set(line_set.kinds) for line_set in properties.style_of(scene).line_sets}
    assert found == {"outline": {"silhouette"}, "marks": set(), "lines": {"crease", "valley"}}


def blenders_names():
    """What of the add-on Blender knows: classes, handlers and places for settings."""
    types = sorted(name for name in dir(bpy.types) if "fovea" in name.lower())
    places = ("Scene", "Object", "Material", "NodeTree")
    owners = [name for name in places if hasattr(getattr(bpy.types, name), "fovea")]
    drawn = len(bpy.types.TOPBAR_MT_render._dyn_ui_initialize())
    lists = {name: getattr(bpy.app.handlers, name) for name in dir(bpy.app.handlers)}
    handlers = {name: len(found) for name, found in lists.items() if isinstance(found, list)}
    return types, owners, (handlers, drawn), "FOVEA" in bpy.types.DATA_PT_lens.COMPAT_ENGINES


def test_registering_again_and_again_leaves_nothing_behind(scene):
    before = blenders_names()
    for _ in range(20):
        fovea.unregister()
        types, owners, _, shown = blenders_names()
        assert (types, owners, shown) == ([], [], False)
        fovea.register()
    assert blenders_names() == before
    assert own_style(bpy.context.scene).line_sets
