"""Settings: made from the registry, filled in by styles, turned into the style that is drawn."""

import math
from types import SimpleNamespace

import bpy
import pytest
from the_addon import empty_scene, part

catalogue = part("catalogue")
properties = part("blender.properties")
style = part("style")


@pytest.fixture
def settings():
    return empty_scene().fovea


def parameters():
    return [(d["name"], p) for d in catalogue.definitions() for p in d["parameters"]]


def test_every_definition_has_a_switch(settings):
    for definition in catalogue.definitions():
        prop = settings.bl_rna.properties[definition["name"]]
        assert (prop.name, prop.type) == (definition["label"], "BOOLEAN")


@pytest.mark.parametrize("definition, parameter", parameters())
def test_every_parameter_is_a_property_with_the_registrys_limits(settings, definition, parameter):
    prop = settings.bl_rna.properties[f"{definition}_{parameter['name']}"]
    assert (prop.name, prop.description) == (parameter["label"], parameter["meaning"])
    if parameter["unit"] == "bool":
        assert (prop.type, prop.default) == ("BOOLEAN", bool(parameter["default"]))
        return
    turn = math.radians if parameter["unit"] == "degrees" else float
    found = (prop.hard_min, prop.default, prop.hard_max)
    assert found == pytest.approx([turn(parameter[key]) for key in ("min", "default", "max")])
    assert (prop.subtype == "ANGLE") == (parameter["unit"] == "degrees")


def test_a_new_scene_draws_the_default_style(settings):
    drawn = properties.style_of(bpy.context.scene)
    expected = style.load(style.DEFAULT)
    assert [s.name for s in drawn.line_sets] == [s.name for s in expected.line_sets]
    assert drawn.paper.color == pytest.approx(expected.paper.color)
    for line_set, shipped in zip(drawn.line_sets, expected.line_sets):
        assert set(shipped.kinds) <= set(line_set.kinds)
        assert line_set.pen.width == pytest.approx(shipped.pen.width)
        assert (line_set.pen.texture, line_set.pen.cap) == (shipped.pen.texture, shipped.pen.cap)


@pytest.mark.parametrize("name", style.names())
def test_choosing_a_style_fills_everything_in(settings, name):
    settings.pen_width = 77
    settings.style = name
    chosen, last = style.load(name), style.load(name).line_sets[-1]
    on = {kind for line_set in chosen.line_sets for kind in line_set.kinds}
    assert {d["name"] for d in catalogue.definitions() if getattr(settings, d["name"])} == on
    assert settings.pen_width == pytest.approx(last.pen.width)
    assert tuple(settings.paper_color) == pytest.approx(chosen.paper.color)
    assert properties.style_of(bpy.context.scene).line_sets[-1].pen.color == pytest.approx(last.pen.color)


def test_switches_and_values_reach_every_line_set(settings):
    settings.style = "technical"
    settings.edge_mark = settings.contour = False
    settings.crease_angle = math.radians(45)
    drawn = properties.style_of(bpy.context.scene)
    assert all("edge_mark" not in s.kinds and "contour" not in s.kinds for s in drawn.line_sets)
    assert drawn.line_sets[-1].kinds["crease"]["angle"] == pytest.approx(45)
    assert [s.name for s in drawn.line_sets] == ["outline", "lines"]


def test_choosing_a_style_says_what_becomes_of_hidden_lines(settings):
    settings.hidden, settings.halo, settings.hidden_from, settings.hidden_to = True, 9, 3, 4
    settings.style = "plain"
    assert (settings.hidden, settings.halo, settings.overshoot) == (False, 0, 0)
    # What it offers when they are switched on: dashes for whatever is hidden, in the colour of the visible lines.
    settings.hidden = True
    (hidden,) = properties.style_of(bpy.context.scene).line_sets[-1].hidden
    assert (hidden.first, hidden.last, hidden.pen.texture) == (1, None, "dashes")
    assert hidden.pen.color == settings.pen_color[:] and hidden.pen.width < settings.pen_width


def test_a_hidden_pen_reaches_every_line_set_that_has_no_other(settings):
    settings.style = "pen_and_ink"
    settings.hidden, settings.hidden_from, settings.hidden_to, settings.hidden_pen_width = True, 2, 5, 7
    settings.halo, settings.overshoot = 3, 4
    drawn = properties.style_of(bpy.context.scene)
    assert len(drawn.line_sets) == 2
    for line_set in drawn.line_sets:
        assert [(h.first, h.last, h.pen.width) for h in line_set.hidden] == [(2, 5, 7)]
        assert (line_set.halo, line_set.overshoot) == (3, 4)
    settings.hidden = False
    assert not any(s.hidden for s in properties.style_of(bpy.context.scene).line_sets)


def test_line_sets_with_hidden_pens_of_their_own_keep_them(settings, monkeypatch):
    own = style.Hidden(style.Pen(width=1.25), 2, 3)
    last = style.LineSet(name="last", halo=2, hidden=(style.Hidden(last=1), style.Hidden(first=4)))
    first = style.LineSet(name="first", kinds={"contour": {}}, halo=1, hidden=(own,))
    monkeypatch.setattr(style, "load", lambda *_: style.Style(line_sets=(first, last)))
    properties.apply_style(settings, "any")
    settings.contour, settings.halo, settings.hidden_pen_width = True, 5, 9
    before, edited = properties.style_of(bpy.context.scene).line_sets
    assert before.hidden == (own,) and before.halo == 1
    assert [(h.first, h.last, h.pen.width) for h in edited.hidden] == [(1, 1, 9), (4, None, 2)] and edited.halo == 5


def test_what_hidden_lines_do_is_told(settings):
    for name in ("hidden", "hidden_from", "hidden_to", "halo", "overshoot"):
        assert len(settings.bl_rna.properties[name].description.split()) > 6
    for name in ("halo", "overshoot", "hidden_pen_width", "pen_width"):
        assert "1080 pixels high" in settings.bl_rna.properties[name].description


def test_fields_that_nothing_reads_are_told_once(settings):
    session, said = part("blender.session"), []
    engine = SimpleNamespace(report=lambda kinds, sentence: said.append((kinds, sentence)))
    words = '{"schema": 1, "line_sets": [{"kinds": {"contuor": {}, "crease": {"angel": 3}}, "pen": {"widht": 2}}]}'
    chosen = style.parse(words, catalogue.definitions())
    session._forget()
    for _ in range(3):
        session._report_unknown(engine, chosen)
    session._report_unknown(engine, style.load(style.DEFAULT))
    ((kinds, sentence),) = said
    assert kinds == {"INFO"}
    for name, near in (("kinds.contuor", "contour"), ("kinds.crease.angel", "angle"), ("pen.widht", "width")):
        assert f"line_sets[0].{name} (is it {near}?)" in sentence


def test_choices_of_pens_and_the_pages_height_go_both_ways(settings, monkeypatch):
    pen = style.Pen(width=0.35, width_unit="millimetres", texture_anchor="path", cap="butt")
    chosen = style.Style(paper=style.Paper(height_mm=148), line_sets=(style.LineSet(kinds={"contour": {}}, pen=pen),))
    monkeypatch.setattr(style, "load", lambda *_: chosen)
    properties.apply_style(settings, "any")
    assert (settings.pen_width_unit, settings.pen_texture_anchor, settings.pen_cap) == ("MILLIMETRES", "PATH", "BUTT")
    drawn = properties.style_of(bpy.context.scene)
    read = drawn.line_sets[-1].pen
    assert (read.width_unit, read.texture_anchor, read.cap) == ("millimetres", "path", "butt")
    assert drawn.paper.height_mm == 148
    assert drawn.width_px(read, 2.0) == pytest.approx(0.35 * 2160 / 148)
    settings.pen_width_unit = "PIXELS"
    drawn = properties.style_of(bpy.context.scene)
    assert drawn.width_px(drawn.line_sets[-1].pen, 2.0) == pytest.approx(0.35)


@pytest.mark.parametrize("visibility, told", [("AUTO", True), ("ATLAS", True), ("EXACT", False)])
def test_the_panel_shows_the_hidden_pen_and_what_sampling_cannot_tell(settings, visibility, told):
    of_hidden = {name for name in settings.bl_rna.properties.keys() if name.startswith("hidden_")}
    assert len(of_hidden) == 17
    settings.hidden, settings.visibility = False, visibility
    assert {"hidden", "halo", "overshoot"} <= set(shown_by_the_panel().shown)
    assert not of_hidden & set(shown_by_the_panel().shown)
    settings.hidden = True
    layout = shown_by_the_panel()
    assert of_hidden <= set(layout.shown)
    assert any("Sampled" in title for title in layout.titles) == told


def test_transparent_film_is_transparent_paper(settings):
    assert not properties.style_of(bpy.context.scene).paper.transparent
    bpy.context.scene.render.film_transparent = True
    assert properties.style_of(bpy.context.scene).paper.transparent


def test_settings_are_saved_with_the_file(settings, tmp_path):
    settings.style = "charcoal"
    settings.crease_angle = 1.0
    mesh = bpy.data.meshes.new("Mesh")
    obj = bpy.data.objects.new("Object", mesh)
    bpy.context.scene.collection.objects.link(obj)
    obj.fovea.usage = "OCCLUDE"
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "scene.blend"))
    empty_scene()
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "scene.blend"))
    saved = bpy.context.scene.fovea
    assert (saved.style, saved.crease_angle, bpy.data.objects["Object"].fovea.usage) == ("charcoal", 1.0, "OCCLUDE")


def test_settings_can_be_keyframed(settings):
    settings.keyframe_insert("pen_width", frame=1)
    settings.pen_width = 9
    settings.keyframe_insert("pen_width", frame=11)
    bpy.context.scene.frame_set(11)
    assert settings.pen_width == pytest.approx(9)
    bpy.context.scene.frame_set(1)
    assert settings.pen_width < 9


class RecordingLayout:
    """Stands in for a panel's layout; every sub-panel is open."""

    def __init__(self):
        self.shown, self.titles = [], []

    def prop(self, owner, name, **_options):
        assert name in owner.bl_rna.properties, name
        self.shown.append(name)

    def label(self, text="", **_options):
        self.titles.append(text)

    def row(self, **_options):
        return self

    column = row

    def panel(self, name, default_closed=False):
        return self, self


def shown_by_the_panel():
    layout = RecordingLayout()
    panel = SimpleNamespace(columns=lambda: layout)
    part("blender.panels").RENDER_PT_fovea.draw(panel, bpy.context)
    return layout


@pytest.mark.parametrize("visibility, heeded", [("EXACT", False), ("AUTO", True), ("ATLAS", True), ("ITEM_BUFFER", True)])
def test_the_panel_offers_the_quality_that_the_method_heeds(settings, visibility, heeded):
    settings.visibility = visibility
    layout = shown_by_the_panel()
    assert layout.enabled == heeded and "depth_scale" in layout.shown
    assert ("layers" in layout.shown) == (visibility == "ITEM_BUFFER") != ("probes" in layout.shown)


@pytest.mark.parametrize("on", [True, False])
def test_the_panel_shows_each_definition_once_and_the_parameters_of_those_that_are_on(settings, on):
    for definition in catalogue.definitions():
        setattr(settings, definition["name"], on)
    shown = shown_by_the_panel().shown
    assert len(shown) == len(set(shown))
    assert {d["name"] for d in catalogue.definitions()} <= set(shown)
    of_parameters = {f"{name}_{parameter['name']}" for name, parameter in parameters()}
    assert of_parameters & set(shown) == (of_parameters if on else set())
    pen = {name for name in settings.bl_rna.properties.keys() if name.startswith("pen_")}
    assert pen | {"corner_angle", "style", "paper_color"} <= set(shown)


def test_the_panel_groups_definitions_by_what_they_depend_on(settings):
    scopes = part("blender.panels").SCOPES
    assert {definition["scope"] for definition in catalogue.definitions()} <= set(scopes)
    layout, scope_of = shown_by_the_panel(), {d["name"]: d["scope"] for d in catalogue.definitions()}
    found = [scope_of[name] for name in layout.shown if name in scope_of]
    assert found == sorted(found, key=list(scopes).index)
    assert [title for title in layout.titles if title in scopes.values()] == [scopes[s] for s in dict.fromkeys(found)]


def test_a_switch_says_what_the_lines_are_and_whose(settings):
    for definition in catalogue.definitions():
        told = settings.bl_rna.properties[definition["name"]].description
        assert definition["description"] in told and definition["source"] in told


def test_panels_draw_with_the_engine(settings):
    for name in ("RENDER_PT_fovea", "OBJECT_PT_fovea", "MATERIAL_PT_fovea", "VIEWLAYER_PT_fovea"):
        assert hasattr(bpy.types, name)
    assert "FOVEA" in bpy.types.DATA_PT_lens.COMPAT_ENGINES
    assert "FOVEA" not in bpy.types.RENDER_PT_freestyle.COMPAT_ENGINES
