# SPDX-License-Identifier: GPL-3.0-or-later
"""Styles as data: reading returns what was written, and invalid content is rejected by name."""

import json

import pytest

from addon import style


def minimal(**line_set):
    return {"schema": style.SCHEMA, "line_sets": [line_set]}


def refused(data):
    with pytest.raises(style.StyleError) as error:
        style.parse(json.dumps(data))
    return str(error.value)


@pytest.mark.parametrize("name", style.names())
def test_shipped_styles_load_and_come_back_the_same(name):
    loaded = style.load(name)
    assert style.parse(style.dump(loaded)) == loaded
    assert loaded.line_sets[-1].kinds


@pytest.mark.parametrize("name", style.names())
def test_shipped_styles_draw_intersections_with_the_pen_of_creases(name):
    kinds = [set(line_set.kinds) & {"crease", "intersection"} for line_set in style.load(name).line_sets]
    assert {"crease", "intersection"} in kinds
    assert all(found in ({"crease", "intersection"}, set()) for found in kinds)


def test_the_default_style_comes_first():
    assert style.names()[0] == style.DEFAULT


def test_every_value_survives():
    data = minimal(
        name="thin",
        kinds={"crease": {"angle": 45}},
        corner_angle=20,
        pen={"color": [0.1, 0.2, 0.3], "opacity": 0.5, "width": 3, "cap": "butt", "taper": 4, "length_scale": 2}
        | {"strength_width": 0.5},
    )
    data["paper"] = {"color": [0, 0, 1], "transparent": True}
    read = style.parse(json.dumps(data))
    line_set = read.line_sets[0]
    assert read.paper == style.Paper(color=(0.0, 0.0, 1.0), transparent=True)
    assert (line_set.name, line_set.kinds, line_set.corner_angle) == ("thin", {"crease": {"angle": 45.0}}, 20.0)
    shape = {"length_scale": 2.0, "cap": "butt", "taper": 4.0, "strength_width": 0.5}
    assert line_set.pen == style.Pen(color=(0.1, 0.2, 0.3), opacity=0.5, width=3.0, **shape)


def test_filters_survive_and_files_without_them_draw_everything():
    filters = {"collection": "Left, or not.001", "outside": True, "object": "Tasse à café", "other_objects": True}
    filters |= {"material": "../Glass", "other_materials": True}
    read = style.parse(json.dumps(minimal(**filters)))
    assert {name: getattr(read.line_sets[0], name) for name in filters} == filters
    assert style.parse(style.dump(read)) == read
    plain = style.parse(json.dumps(minimal(kinds={"crease": {}}))).line_sets[0]
    assert not any(getattr(plain, name) for name in filters)


def test_pens_of_hidden_lines_survive_in_the_order_of_their_ranges():
    thin = {"width": 1.5, "texture": "dashes", "cap": "butt"}
    data = minimal(hidden=[{"from": 4, "pen": thin}, {"to": 2}, {"from": 3, "to": 3}], halo=3, overshoot=12.5)
    read = style.parse(json.dumps(data))
    line_set = read.line_sets[0]
    assert [(h.first, h.last) for h in line_set.hidden] == [(1, 2), (3, 3), (4, None)]
    assert line_set.hidden[2].pen == style.Pen(width=1.5, texture="dashes", cap="butt")
    assert (line_set.halo, line_set.overshoot) == (3.0, 12.5)
    assert style.parse(style.dump(read)) == read
    assert json.loads(style.dump(read))["line_sets"][0]["hidden"][2]["from"] == 4


def test_pens_out_of_focus_are_as_those_in_focus_but_for_what_is_given():
    pen = {"width": 3, "texture": "pencil", "taper": 4}
    data = minimal(pen=pen, pen_away={"width": 1.5, "opacity": 0.4}, overshoot=2, overshoot_away=9)
    data["line_sets"][0]["hidden"] = [{"pen": {"width": 1}, "pen_away": {"width": 0.5}}]
    read = style.parse(json.dumps(data))
    line_set = read.line_sets[0]
    assert line_set.pen_away == style.Pen(width=1.5, opacity=0.4, texture="pencil", taper=4.0)
    assert (line_set.overshoot_away, line_set.hidden[0].pen_away.width) == (9.0, 0.5)
    assert [pen.width for pen in read.pens()] == [3, 1, 1.5, 0.5]
    assert style.parse(style.dump(read)) == read


def test_what_has_no_pen_out_of_focus_has_none():
    plain = style.parse(json.dumps(minimal()))
    assert plain.line_sets[0].pen_away is None


def test_focus_and_its_effects_survive():
    fade = {"start": 0.8, "end": 0.2, "strength": 0.5, "curve": [[0, 0], [0.5, 0.9], [1, 1]]}
    data = minimal() | {
        "focus": {"model": "scene", "points": [{"at": [1, 2, -3], "near": 2, "far": 7}, {"at": [0.5, 0.5]}]},
        "effects": {"fade": fade, "lines": "uniform", "uniform": 0.25},
        "distance": {"near": 2, "far": 30, "width": {"strength": 1}},
    }
    read = style.parse(json.dumps(data))
    assert read.focus.points[0] == style.FocusPlace(at=(1.0, 2.0, -3.0), near=2.0, far=7.0)
    assert read.focus.points[1].at == (0.5, 0.5, 0.0)
    assert read.effects.fade == style.Transfer(
        start=0.8, end=0.2, strength=0.5, curve=((0.0, 0.0), (0.5, 0.9), (1.0, 1.0))
    )
    assert read.effects.blur == style.Transfer(strength=0.0) and read.effects.width == style.Transfer()
    assert read.distance.width.strength == 1.0
    assert style.parse(style.dump(read)) == read


def test_elision_over_frames_survives():
    read = style.parse(json.dumps(minimal() | {"elision": {"enabled": True, "frames": 2}}))
    assert read.elision.frames == 2 and isinstance(read.elision.frames, int)
    assert style.parse(style.dump(read)) == read
    assert style.parse(json.dumps(minimal())).elision.frames == 0


def test_what_says_nothing_of_hidden_lines_draws_none_of_them():
    plain = style.parse(json.dumps(minimal())).line_sets[0]
    assert (plain.hidden, plain.overshoot, plain.halo) == ((), 0.0, 0.0)


@pytest.mark.parametrize(
    "data, named",
    [
        (minimal(kinds={"crease": {"angle": 200}}), "200"),
        (minimal(kinds={"crease": {"angle": float("nan")}}), "not JSON"),
        (minimal(pen={"width": -1}), "-1"),
        (minimal(pen={"width": True}), "line_sets[0].pen.width must be a number"),
        (minimal(pen={"cap": "square"}), "square"),
        (minimal(pen={"color": [0, 0]}), "3 numbers"),
        (minimal(pen={"texture": "no_such_texture"}), "no_such_texture"),
        (minimal(halo=101), "line_sets[0].halo is 101"),
        (minimal(pen_away={"texture": "../secret"}), "pen_away.texture"),
        (minimal(overshoot_away=-1), "line_sets[0].overshoot_away is -1"),
        (minimal() | {"focus": {"model": "nowhere"}}, "focus.model is 'nowhere'"),
        (minimal() | {"focus": {"points": [{"at": [1]}]}}, "focus.points[0].at must be a list of 2 or 3 numbers"),
        (minimal() | {"focus": {"points": [{"at": [1, float("inf")]}]}}, "not JSON"),
        (minimal() | {"focus": {"points": [{"near": 3, "far": 2}]}}, "focus.points[0].far must not be less than near"),
        (minimal() | {"focus": {"points": [{}] * 17}}, "focus.points must be a list of at most 16 points"),
        (minimal() | {"effects": {"fade": {"strength": 2}}}, "effects.fade.strength is 2"),
        (minimal() | {"effects": {"fade": 3}}, "effects.fade must be a JSON object"),
        (minimal() | {"effects": {"fade": {"curve": [[0.5, 0], [0.5, 1]]}}}, "effects.fade.curve: points must ascend"),
        (
            minimal() | {"effects": {"fade": {"curve": [[0, 0, 0]]}}},
            "effects.fade.curve[0] must be a list of 2 numbers",
        ),
        (minimal() | {"effects": {"lines": ["uniform"]}}, "effects.lines must be text"),
        (minimal() | {"distance": {"near": 5, "far": 5}}, "distance.far must be more than near"),
        (minimal(overshoot=-1), "line_sets[0].overshoot is -1"),
        (minimal(hidden={}), "line_sets[0].hidden must be a list"),
        (minimal(hidden=[{"from": 0}]), "line_sets[0].hidden[0].from is 0"),
        (minimal(hidden=[{"from": 1.5}]), "hidden[0].from must be a whole number"),
        (minimal(hidden=[{"to": True}]), "hidden[0].to must be a whole number"),
        (
            minimal(hidden=[{"from": 3, "to": 2}]),
            "hidden[0].to is 2, less than line_sets[0].hidden[0].from, which is 3",
        ),
        (
            minimal(hidden=[{"from": 1, "to": 2}, {"from": 2}]),
            "line_sets[0].hidden: two ranges hold what 2 surfaces hide",
        ),
        (minimal(hidden=[{"from": 4}, {"from": 1}]), "two ranges hold what 4 surfaces hide"),
        (minimal(hidden=[{"pen": {"cap": "square"}}]), "line_sets[0].hidden[0].pen.cap is 'square'"),
        (minimal(hidden=[{"pen": {"width": 0}}]), "line_sets[0].hidden[0].pen.width"),
        (minimal(name=3), "name"),
        (minimal(object=["Cup"]), "line_sets[0].object must be text of at most 255 letters"),
        (minimal(object="x" * 256), "line_sets[0].object must be text of at most 255 letters"),
        (minimal(material=3), "line_sets[0].material must be text of at most 255 letters"),
        (minimal(other_objects="no"), "line_sets[0].other_objects must be true or false"),
        (minimal(other_materials=1), "line_sets[0].other_materials must be true or false"),
        ({"schema": style.SCHEMA, "line_sets": []}, "line_sets"),
        ({"schema": 99, "line_sets": [{}]}, "schema is 99: a newer version of Fovea wrote the style"),
        ({"schema": 99, "lines": {"a": [1e999]}}, "not JSON"),
        ({"line_sets": [{}]}, "schema is null, not the number of a schema"),
        ({"schema": True, "line_sets": [{}]}, "schema is true"),
        ({"schema": 1.0, "line_sets": [{}]}, "schema is 1.0"),
        (minimal(pen={"width_unit": "inches"}), "width_unit is 'inches'; it can be: reference, pixels, millimetres"),
        (minimal(pen={"width_unit": 2}), "pen.width_unit must be text"),
        (minimal(pen={"texture_anchor": "world"}), "pen.texture_anchor is 'world'; it can be: screen, path"),
        (minimal() | {"paper": {"height_mm": 0}}, "paper.height_mm is 0, outside 10 to 10000"),
        ([], "JSON object"),
    ],
)
def test_what_does_not_belong_is_named(data, named):
    assert named in refused(data)


@pytest.mark.parametrize("unit, widths", [("reference", (3, 6)), ("pixels", (3, 3)), ("millimetres", (10.8, 21.6))])
def test_widths_in_pixels_of_the_image(unit, widths):
    data = minimal(pen={"width": 3, "width_unit": unit, "taper": 8}) | {"paper": {"height_mm": 300}}
    read = style.parse(json.dumps(data))
    assert style.parse(style.dump(read)) == read
    pen = read.line_sets[0].pen
    assert [read.width_px(pen, scale) for scale in (1.0, 2.0)] == pytest.approx(widths)


def test_dashes_are_measured_as_the_pen_they_belong_to():
    thin = style.dashed(style.Pen(width=0.35, width_unit="millimetres"))
    assert (thin.width, thin.width_unit) == (pytest.approx(0.21), "millimetres")
    assert style.dashed(style.Pen(width=1.2)).width == 1.0


def test_text_that_is_not_json():
    with pytest.raises(style.StyleError, match="not JSON"):
        style.parse("{")


@pytest.mark.parametrize("path", ["../secret", "/etc/passwd", "a/b", "..", "a\\b", "ink.png"])
def test_no_name_leads_out_of_its_folder(path):
    assert path in refused(minimal(pen={"texture": path}))
    with pytest.raises(style.StyleError):
        style.load(path)


def test_switches_may_be_written_as_true_and_false():
    read = style.parse(json.dumps(minimal(kinds={"crease": {"sharp_marks": False}})))
    assert read.line_sets[0].kinds == {"crease": {"sharp_marks": 0.0}}


def test_a_number_that_a_record_does_not_take_is_refused_by_its_range():
    style.check(style.LineSet, "halo", 100.0, "--halo")
    for number in (-1, 100.5, float("nan")):
        with pytest.raises(style.StyleError, match=f"--halo is {number:g}, outside 0 to 100"):
            style.check(style.LineSet, "halo", number, "--halo")


def test_records_are_equal_by_value_and_keep_what_they_hold():
    one, same = style.load("pen_and_ink"), style.load("pen_and_ink")
    assert one == same and hash(one) == hash(same) and one is not same
    assert one.replace(kept=((("new", 0), [1.5]),)).kept == ((("new", 0), [1.5]),)
    one.line_sets[0].kinds["contour"] = {}
    assert one == same, "what is handed out is a copy"
    with pytest.raises(TypeError, match="there is no 'colour'"):
        style.Pen(colour=(0, 0, 0))
    with pytest.raises(TypeError, match="width cannot be 'wide'"):
        style.Pen(width="wide")
