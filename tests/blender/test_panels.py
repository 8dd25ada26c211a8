"""Panels: they show every property, tell what each does in Blender's own way, and every one can be set."""

import re
from types import SimpleNamespace

import bpy
import pytest
from the_addon import add_hidden, empty_scene, lines_of, only_lines, own_style, part, use_style

catalogue, panels, properties = part("catalogue"), part("blender.panels"), part("blender.properties")


class RecordingLayout:
    """Stands in for a panel's layout; every sub-panel is open."""

    def __init__(self):
        self.props, self.titles, self.operators, self.curves = [], [], [], []

    def prop(self, owner, name, **_options):
        assert name in owner.bl_rna.properties, name
        self.props.append((owner, name))

    def label(self, text="", **_options):
        self.titles.append(text)

    def operator(self, name, **_options):
        module, _, word = name.partition(".")
        assert hasattr(bpy.types, f"{module.upper()}_OT_{word}"), name
        self.operators.append(name)
        return self

    def operator_menu_enum(self, name, _prop, **_options):
        self.operator(name)

    def template_ID(self, owner, name, new=""):
        self.prop(owner, name)
        self.operator(new)

    def template_list(self, kind, _id, owner, items, active_owner, active, **_options):
        assert hasattr(bpy.types, kind)
        self.prop(owner, items), self.prop(active_owner, active)

    def separator(self, **_options):
        pass

    def prop_search(self, owner, name, *_where, **_options):
        self.prop(owner, name)

    def template_icon(self, **_options):
        pass

    def template_curve_mapping(self, node, name):
        assert getattr(node, name).curves
        self.curves.append(node.name)

    def row(self, **_options):
        return self

    column = grid_flow = box = split = row

    def panel(self, _name, default_closed=False):
        return self, self

    @property
    def shown(self):
        return [name for _, name in self.props]


@pytest.fixture
def scene():
    """With everything on that shows more."""
    made = empty_scene()
    made.render.engine = "FOVEA"
    use_style(made, "xray_focus")
    made.fovea.focus_model = "SCENE"
    made.fovea.focus_points.add()
    only_lines(made, *(definition["name"] for definition in catalogue.definitions()))
    lines_of(made).hidden.clear()
    add_hidden(lines_of(made)).away = True
    mesh = bpy.data.meshes.new("Mesh")
    obj = bpy.data.objects.new("Object", mesh)
    made.collection.objects.link(obj)
    mesh.materials.append(bpy.data.materials.new("Material"))
    bpy.context.view_layer.objects.active = obj
    return made


def context():
    """What Blender hands to panels, wherever they are."""
    obj, scene = bpy.context.object, bpy.context.scene
    return SimpleNamespace(
        scene=scene,
        engine=scene.render.engine,
        object=obj,
        material=obj.active_material,
        view_layer=bpy.context.view_layer,
        window_manager=bpy.context.window_manager,
    )


def shown_by(*classes):
    layout = RecordingLayout()
    for cls in classes or drawn_panels():
        if hasattr(cls, "draw_header"):
            cls.draw_header(SimpleNamespace(layout=layout), context())
        cls.show(cls, layout, context())
    return layout


def drawn_panels():
    shown = [cls for cls in panels.CLASSES if issubclass(cls, bpy.types.Panel)]
    return [cls for cls in shown if cls.poll(context())]


def test_panels_draw_with_the_engine_and_for_a_style(scene):
    assert "FOVEA" in bpy.types.DATA_PT_lens.COMPAT_ENGINES
    assert "FOVEA" not in bpy.types.RENDER_PT_freestyle.COMPAT_ENGINES
    assert len(drawn_panels()) >= 11
    scene.fovea.style = None
    labels = {cls.bl_label for cls in drawn_panels()}
    assert {"Style", "Focus", "Visibility", "Performance"} <= labels and "Lines" not in labels
    assert any("as it ships" in title for title in shown_by().titles)
    scene.render.engine = "BLENDER_WORKBENCH"
    assert drawn_panels() == []


def test_a_style_is_edited_in_the_sidebar_whichever_engine_draws(scene):
    scene.render.engine = "BLENDER_WORKBENCH"
    scene.view_settings.view_transform = "AgX"
    assert [cls.bl_label for cls in drawn_panels()] == ["Style", "Focus", "Lines"]
    assert not any("paper gray" in title for title in shown_by().titles)


def test_a_menu_has_every_operator_so_that_it_is_found():
    layout, operators = RecordingLayout(), []
    for name in ("style", "line_sets"):
        menu = getattr(part("blender.panels.menu"), f"TOPBAR_MT_fovea_{name}")
        menu.show(menu, layout)
    for module in ("style_operators", "line_set_operators"):
        operators += [cls.bl_idname for cls in part(f"blender.{module}").CLASSES]
    assert sorted(layout.operators) == sorted(operators)


def leaves(group, path=""):
    """(path, property) of all that a style holds, those of one element of each collection."""
    for prop in group.bl_rna.properties:
        here = f"{path}.{prop.identifier}"
        if prop.identifier == "rna_type" or prop.is_hidden:
            continue
        if prop.type == "POINTER" and issubclass(type(getattr(group, prop.identifier)), bpy.types.PropertyGroup):
            yield from leaves(getattr(group, prop.identifier), here)
        elif prop.type == "COLLECTION":
            for element in getattr(group, prop.identifier):
                yield from leaves(element, here)
        else:
            yield here, prop


def test_every_property_of_a_style_is_in_a_panel_and_tells_what_it_does(scene):
    shown = set(shown_by().shown)
    for path, prop in leaves(own_style(scene)):
        assert prop.identifier in shown or path.endswith(".name"), path
        assert len(prop.description.split()) > 2 or path.endswith(".name"), path


def test_each_definition_is_shown_once_and_the_parameters_of_those_that_are_on(scene):
    owners = {f"{d['name']}_{p['name']}": d["name"] for d in catalogue.definitions() for p in d["parameters"]}
    for on in (True, False):
        only_lines(scene, *(d["name"] for d in catalogue.definitions() if on))
        own_style(scene).line_set_index = len(own_style(scene).line_sets) - 1
        kinds = lines_of(scene).kinds
        layout = shown_by(part("blender.panels.lines").RENDER_PT_fovea_lines)
        shown = [name for owner, name in layout.props if owner == kinds]
        switched = {d["name"] for d in catalogue.definitions() if getattr(kinds, d["name"])}
        assert len(shown) == len(set(shown)) and {d["name"] for d in catalogue.definitions()} <= set(shown)
        wanted = {name for name, owner in owners.items() if owner in switched}
        assert owners.keys() & set(shown) == wanted


def test_definitions_are_grouped_by_what_they_depend_on(scene):
    scopes = part("blender.panels.lines").SCOPES
    assert {definition["scope"] for definition in catalogue.definitions()} <= set(scopes)
    layout = shown_by(part("blender.panels.lines").RENDER_PT_fovea_lines)
    scope_of = {d["name"]: d["scope"] for d in catalogue.definitions()}
    found = [scope_of[name] for name in layout.shown if name in scope_of]
    assert found == sorted(found, key=list(scopes).index)
    assert [title for title in layout.titles if title in scopes.values()] == [scopes[s] for s in dict.fromkeys(found)]


def test_every_effect_shows_its_curve(scene):
    found = shown_by(part("blender.panels.effects").RENDER_PT_fovea_effects).curves
    assert sorted(found) == sorted(node.name for node in scene.fovea.style.nodes) and len(found) == 12


@pytest.mark.parametrize("visibility, told", [("AUTO", True), ("ATLAS", True), ("EXACT", False)])
def test_what_sampling_cannot_tell_of_hidden_lines_is_said(scene, visibility, told):
    scene.fovea.visibility = visibility
    assert any("Sampled" in title for title in shown_by().titles) == told


SMALL = {"a", "and", "as", "at", "by", "for", "from", "if", "in", "of", "on", "or", "out", "per", "the", "to", "with"}


def complaints(prop, title=None):
    """What is unlike Blender in the words of a property, or of an operator."""
    title, told = title or prop.name, prop.description
    words = re.findall(r"[A-Za-z][\w'-]*", re.sub(r"\(.*?\)", "", title))
    if any(word[0].islower() for word in words[1:] if word not in SMALL) or title[:1].islower():
        yield f"{title}: not in title case"
    if len(told.split()) < 3:
        yield f"{title}: no description"
    if told.endswith("."):
        yield f"{title}: the description ends with a full stop"
    items = [f"{item.name} {item.description}" for item in getattr(prop, "enum_items", ())]
    if re.search(r"olour|\bgrey|\w+metres\b|\bcentre", " ".join([title, told, *items]), re.I):
        yield f"{title}: Blender spells like Americans"


def owners(scene):
    """All that has settings of Fovea."""
    obj = bpy.context.object
    return [own_style(scene), scene.fovea, scene.fovea_viewport, obj.fovea, obj.active_material.fovea]


def test_words_are_as_blenders_own(scene):
    props = [prop for owner in owners(scene) for path, prop in leaves(owner) if not path.endswith(".name")]
    props.append(bpy.context.window_manager.bl_rna.properties["fovea_show_focus"])
    preferences = part("blender.preferences").FoveaPreferences.__annotations__
    entry = bpy.context.preferences.addons.get(part("blender.preferences").ADDON)
    props += [entry.preferences.bl_rna.properties[name] for name in preferences] if entry else []
    found = [word for prop in props for word in complaints(prop)]
    for name in dir(bpy.ops.fovea):
        kind = getattr(bpy.ops.fovea, name).get_rna_type()
        found += complaints(kind)
        shown = (prop for prop in kind.properties if not prop.is_hidden and prop.identifier != "rna_type")
        helpers = ("filepath", "check_existing", "filter_glob")
        found += [f"{name}: {word}" for prop in shown if prop.identifier not in helpers for word in complaints(prop)]
    assert not found, "\n".join(found)
    assert len(props) > 100 and len(dir(bpy.ops.fovea)) > 20


def test_numbers_are_dragged_over_what_makes_sense(scene):
    for owner in owners(scene):
        for path, prop in leaves(owner):
            if prop.type != "FLOAT" or prop.subtype in ("COLOR", "XYZ", "XYZ_LENGTH") or path.endswith("_index"):
                continue
            assert prop.hard_min > -1e9 and prop.soft_max <= 1000, path
            assert prop.default == 0 or prop.soft_max <= 1000 * prop.default, path


def test_titles_of_panels_are_as_blenders_own(scene):
    layout = shown_by()
    titles = {cls.bl_label for cls in drawn_panels()} | {text for text in layout.titles if len(text.split()) < 4}
    for title in titles:
        assert title[0].isupper() or title[0].isdigit(), title


def test_a_view_transform_that_makes_paper_gray_is_told_and_put_right(scene):
    scene.view_settings.view_transform = "AgX"
    assert any("AgX makes paper gray" in title for title in shown_by().titles)
    assert bpy.ops.fovea.standard_view() == {"FINISHED"} and scene.view_settings.view_transform == "Standard"
    assert not any("paper gray" in title for title in shown_by().titles) and not bpy.ops.fovea.standard_view.poll()


def test_what_was_drawn_is_told(scene, monkeypatch):
    known = {"stages": {"bvh": 20.0, "lines": 1500.0}, "backend": "cpu", "strokes": 3, "visibility": "exact"}
    monkeypatch.setattr(part("blender.session"), "last_statistics", lambda: known)
    titles = shown_by().titles
    assert {"Last Drawn in 1.52 s", "Device", "CPU", "Strokes", "3", "BVH", "20 ms", "Lines", "1500 ms"} <= set(titles)


def test_every_setting_is_in_a_panel(scene):
    shown = set()
    viewport = part("blender.viewport_settings").RENDER_PT_fovea_viewport
    for model in ("SCENE", "IMAGE", "OBJECT", "PAINTED"):
        for estimator in ("AUTOMATIC", "JETS"):
            for resample in (0, 1):
                scene.fovea.focus_model = model
                fovea = bpy.context.object.fovea
                fovea.curvature_estimator, fovea.repair_resample, fovea.refine = estimator, resample, True
                shown |= {(type(owner), name) for owner, name in shown_by().props}
    layout = RecordingLayout()
    viewport.draw(SimpleNamespace(layout=layout), context())
    shown |= {(type(owner), name) for owner, name in layout.props}
    for owner in owners(scene)[1:]:
        for prop in owner.bl_rna.properties:
            if prop.identifier not in {"rna_type", "name", "focus_points"} and not prop.is_hidden:
                assert (type(owner), prop.identifier) in shown, prop.identifier


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
