# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels show every property, describe each in Blender's way, and every one can be set."""

from types import SimpleNamespace

import bpy
import pytest
from panel_layouts import RecordingLayout, catalogue, context, drawn_panels, full_scene, leaves, owners, shown_by
from the_addon import lines_of, only_lines, own_style, part, use_style

properties, registration = part("render.properties"), part("scene.registration")


@pytest.fixture
def scene():
    return full_scene()


def test_panels_draw_with_the_engine_and_for_a_style(scene):
    assert "FOVEA" in bpy.types.DATA_PT_lens.COMPAT_ENGINES
    assert "FOVEA" not in bpy.types.RENDER_PT_freestyle.COMPAT_ENGINES
    assert len(drawn_panels()) >= 11
    scene.fovea.style = None
    labels = {cls.bl_label for cls in drawn_panels()}
    assert {"Style", "Focus", "Visibility", "Performance"} <= labels and "Lines" not in labels
    assert any("as it ships" in title for title in shown_by().titles)
    scene.render.engine = "BLENDER_WORKBENCH"
    assert [cls.bl_label for cls in drawn_panels()] == ["Fovea Lines"]


def test_performance_has_what_blender_keeps_between_frames(scene):
    shown = shown_by(part("ui.method").RENDER_PT_fovea_performance).props
    assert (scene.render, "use_persistent_data") in shown


def test_blender_has_every_panel_as_it_was_registered(scene):
    """A panel that is registered as a subclass of another one takes its place."""
    names = [name for name in dir(bpy.types) if "_PT_fovea" in name]
    assert not [name for name in names if not hasattr(getattr(bpy.types, name), "draw")]
    scene.render.engine = "FOVEA"
    for name in ("style", "lines", "focus", "effects", "elision", "animation", "vectors"):
        assert getattr(bpy.types, f"RENDER_PT_fovea_{name}").poll(bpy.context), name
        assert not getattr(bpy.types, f"RENDER_PT_fovea_over_{name}").poll(bpy.context), name


def test_a_style_is_edited_in_the_sidebar_whichever_engine_draws(scene):
    scene.render.engine = "BLENDER_WORKBENCH"
    scene.view_settings.view_transform = "AgX"
    assert [cls.bl_label for cls in drawn_panels()] == ["Style", "Focus", "Lines", "Fovea Lines"]
    assert not any("paper gray" in title for title in shown_by().titles)


def test_a_menu_has_every_operator_so_that_it_is_found():
    layout, operators = RecordingLayout(), []
    for name in ("style", "line_sets"):
        menu = getattr(part("ui.menu"), f"TOPBAR_MT_fovea_{name}")
        menu.show(menu, layout)
    for module in ("style_operators", "line_set_operators"):
        operators += [cls.bl_idname for cls in registration.classes_of(part(f"style.{module}"))]
    assert sorted(layout.operators) == sorted(operators)


def test_every_property_of_a_style_is_in_a_panel_and_tells_what_it_does(scene):
    shown = set()
    for index in range(len(scene.fovea.style.nodes)):
        scene.fovea.style.fovea.effect_index = index
        shown |= set(shown_by().shown)
    for path, prop in leaves(own_style(scene)):
        assert prop.identifier in shown or path.endswith(".name"), path
        assert len(prop.description.split()) > 2 or path.endswith(".name"), path


def test_each_definition_is_shown_once_and_the_parameters_of_those_that_are_on(scene):
    owners = {f"{d['name']}_{p['name']}": d["name"] for d in catalogue.definitions() for p in d["parameters"]}
    for on in (True, False):
        only_lines(scene, *(d["name"] for d in catalogue.definitions() if on))
        own_style(scene).line_set_index = len(own_style(scene).line_sets) - 1
        kinds = lines_of(scene).kinds
        layout = shown_by(part("ui.lines").RENDER_PT_fovea_lines)
        shown = [name for owner, name in layout.props if owner == kinds]
        switched = {d["name"] for d in catalogue.definitions() if getattr(kinds, d["name"])}
        assert len(shown) == len(set(shown)) and {d["name"] for d in catalogue.definitions()} <= set(shown)
        wanted = {name for name, owner in owners.items() if owner in switched}
        assert owners.keys() & set(shown) == wanted


def test_usual_definitions_come_first_each_group_by_what_its_lines_depend_on(scene):
    scopes = list(part("ui.lines").SCOPES)
    assert {definition["scope"] for definition in catalogue.definitions()} <= set(scopes)
    layout = shown_by(part("ui.lines").RENDER_PT_fovea_lines)
    place = {d["name"]: (not d["usual"], scopes.index(d["scope"])) for d in catalogue.definitions()}
    found = [place[name] for name in layout.shown if name in place]
    assert found == sorted(found) and 8 < sum(not research for research, _ in found) < 16


def taken(held, index):
    """What the panel of a line set says of types that sets above it take."""
    held.line_set_index = index
    layout = shown_by(part("ui.lines").RENDER_PT_fovea_lines)
    return {title for title in layout.titles if title.startswith("Taken by")}


def test_a_kind_that_a_set_above_takes_says_which(scene):
    held = use_style(scene, "plain")
    index = held.line_set_index
    assert held.line_sets[index].kinds.contour
    assert bpy.ops.fovea.line_set_duplicate() == {"FINISHED"}
    held.line_sets[index].name = "Outlines"
    by_both = {"Taken by 'forms' above", "Taken by 'Outlines' above"}
    assert taken(held, index) == {"Taken by 'forms' above"} and taken(held, index + 1) == by_both
    for definition in catalogue.definitions():
        setattr(held.line_sets[index + 1].kinds, definition["name"], False)
    assert taken(held, index + 1) == by_both


@pytest.mark.parametrize(
    "above, below, kind, none_left",
    [
        ("ALL", "HARD", "contour", True),
        ("HARD", "HARD", "contour", True),
        ("HARD", "ALL", "contour", False),
        ("SMOOTH", "HARD", "contour", False),
        ("SUITED", "SUITED", "contour", True),
        ("SUITED", "ALL", "ridge", False),
        ("SMOOTH", "SUITED", "ridge", True),
        ("SUITED", "ALL", "crease", True),
        ("SUITED", "ALL", "contour", False),
        ("HARD", "ALL", "image_edge", True),
    ],
)
def test_a_set_above_takes_a_kind_only_if_no_shape_of_surfaces_is_left(scene, above, below, kind, none_left):
    """The last set asks for smooth contours, which sets that suit surfaces have on smooth ones in place of contours."""
    held = use_style(scene, "plain")
    only_lines(scene, kind, "smooth_contour")
    held.line_set_index = len(held.line_sets) - 1
    assert bpy.ops.fovea.line_set_duplicate() == {"FINISHED"}
    first, second = held.line_sets[-2:]
    first.kinds.smooth_contour = False
    first.surfaces, second.surfaces = above, below
    assert bool(taken(held, len(held.line_sets) - 1)) == none_left


def test_a_kind_of_the_whole_picture_says_that_a_set_with_filters_has_none(scene):
    held = use_style(scene, "plain")
    for wanted in ("", "Scenery"):
        held.line_sets[held.line_set_index].collection = wanted
        titles = shown_by(part("ui.lines").RENDER_PT_fovea_lines).titles
        assert ("Needs a line set without filters" in titles) == bool(wanted)


def test_every_effect_is_in_the_list_and_shows_its_curve_and_numbers_when_it_is_chosen(scene):
    effects, tree = part("ui.effects"), scene.fovea.style
    assert sorted(effects.declared()) == sorted(node.name for node in tree.nodes) and len(tree.nodes) == 12
    shown = set()
    for index, node in enumerate(tree.nodes):
        tree.fovea.effect_index = index
        layout = shown_by(effects.RENDER_PT_fovea_effects)
        assert layout.curves == [node.name]
        shown |= {name for owner, name in layout.props}
    assert {"start", "end", "strength", "blur_radius", "near", "far"} <= shown


def test_the_list_of_effects_is_in_the_order_of_the_declarations_and_has_no_other_nodes(scene):
    effects, tree = part("ui.effects"), scene.fovea.style
    tree.nodes.new("ShaderNodeMath")
    fake = SimpleNamespace(bitflag_filter_item=1)
    flags, order = effects.FOVEA_UL_effects.filter_items(fake, None, tree, "nodes")
    listed = [tree.nodes[order.index(place)].name for place in range(len(order))]
    assert listed[:12] == list(effects.declared()) and flags.count(1) == 12


@pytest.mark.parametrize("visibility, told", [("AUTO", True), ("ATLAS", True), ("EXACT", False)])
def test_what_sampling_cannot_tell_of_hidden_lines_is_said(scene, visibility, told):
    scene.fovea.visibility = visibility
    assert any("Sampled" in title for title in shown_by().titles) == told


def test_a_view_transform_that_makes_paper_gray_is_told_and_put_right(scene):
    scene.view_settings.view_transform = "AgX"
    assert any("AgX makes paper gray" in title for title in shown_by().titles)
    assert bpy.ops.fovea.standard_view() == {"FINISHED"} and scene.view_settings.view_transform == "Standard"
    assert not any("paper gray" in title for title in shown_by().titles) and not bpy.ops.fovea.standard_view.poll()


def test_what_was_drawn_is_told(scene, monkeypatch):
    stages = {"bvh": 20.0, "lines": 1500.0, "elision": 1.0, "near_frames": 2.0}
    known = {"stages": stages, "backend": "cpu", "strokes": 3, "visibility": "exact"}
    monkeypatch.setattr(part("render.session"), "last_statistics", lambda: known)
    titles = shown_by().titles
    assert {"Last Drawn in 1.52 s", "Device", "CPU", "Strokes", "3", "20 ms", "1500 ms"} <= set(titles)
    assert {"Preparing Rays", "Finding Lines", "Line Thinning", "Frames Around It"} <= set(titles)


def test_every_setting_is_in_a_panel(scene):
    shown = set()
    viewport = part("ui.viewport_settings").RENDER_PT_fovea_viewport
    bpy.context.object.modifiers.new("Fur", "PARTICLE_SYSTEM").particle_system.settings.type = "HAIR"
    for model in ("SCENE", "IMAGE", "OBJECT", "PAINTED"):
        for estimator in ("AUTOMATIC", "JETS"):
            for resample in (0, 1):
                scene.fovea.focus_model = model
                fovea = bpy.context.object.fovea
                fovea.curvature_estimator, fovea.repair_resample, fovea.refine = estimator, resample, True
                shown |= {(type(owner), name) for owner, name in shown_by().props}
    with_lines_over(scene)
    over = part("ui.lines_over")
    layout = shown_by(over.RENDER_PT_fovea_lines_over)
    shown |= {(type(owner), name) for owner, name in layout.props}
    layout = RecordingLayout()
    viewport.show(None, layout, context())
    shown |= {(type(owner), name) for owner, name in layout.props}
    for owner in with_groups(owners(scene)[1:]):
        for prop in owner.bl_rna.properties:
            if (
                prop.identifier not in {"rna_type", "name", "focus_points"}
                and not prop.is_hidden
                and not is_group(prop)
            ):
                assert (type(owner), prop.identifier) in shown, prop.identifier


def with_lines_over(scene):
    scene.render.engine = "BLENDER_WORKBENCH"
    assert bpy.ops.fovea.lines_over() == {"FINISHED"}


def test_lines_over_renders_have_the_panels_of_style_and_lines_below_their_own(scene):
    over = part("ui.lines_over")
    scene.render.engine = "BLENDER_WORKBENCH"
    before = shown_by(over.RENDER_PT_fovea_lines_over)
    assert before.operators == ["fovea.lines_over"] and not any(cls.poll(context()) for cls in over._registered)
    with_lines_over(scene)
    after = shown_by(over.RENDER_PT_fovea_lines_over)
    assert after.operators == ["fovea.lines_over_remove", "fovea.lines_over_repair"]
    assert {"lines_blend", "default_value"} <= set(after.shown)
    below = [cls for cls in over._registered if cls.poll(context())]
    assert {"Style", "Lines", "Focus"} <= {cls.bl_label for cls in below}
    assert "width" in shown_by(*below).shown
    scene.render.engine = "FOVEA"
    assert not any(cls.poll(context()) for cls in (over.RENDER_PT_fovea_lines_over, *over._registered))


def is_group(prop):
    """Whether a property holds others."""
    return prop.type == "POINTER" and isinstance(prop.fixed_type, bpy.types.PropertyGroup)


def with_groups(owners_):
    """Owners of properties, with the groups in them."""
    for owner in owners_:
        yield owner
        yield from (getattr(owner, prop.identifier) for prop in owner.bl_rna.properties if is_group(prop))


def values_for(owner, prop):
    """Some values that a property can have; None for what holds other things."""
    if prop.type == "BOOLEAN":
        return [True, False]
    if prop.type == "ENUM":
        return [item.identifier for item in prop.enum_items]
    if prop.type == "STRING":
        return ["word", ""]
    if prop.type in ("INT", "FLOAT"):
        kind = int if prop.type == "INT" else float
        ends = [kind(prop.soft_min), kind(prop.soft_max), kind(prop.hard_max)]
        return [[v] * prop.array_length for v in ends] if prop.array_length else ends
    return []


def test_every_property_of_every_panel_can_be_set(scene):
    for owner, name in shown_by().props:
        prop = owner.bl_rna.properties[name]
        if prop.is_readonly or owner.id_data == scene and owner != scene.fovea and name != "film_transparent":
            continue
        before = getattr(owner, name)
        before = tuple(before) if getattr(prop, "array_length", 0) else before
        for value in values_for(owner, prop):
            setattr(owner, name, value)
            assert properties.style_of(scene).line_sets
            shown_by()
        if prop.type not in ("POINTER", "COLLECTION"):
            setattr(owner, name, before)
