"""Styles as data: what is read is what was written, and what does not belong is refused by name."""

import json

import pytest
from addon import style

DEFINITIONS = [
    {"name": "contour", "parameters": []},
    {"name": "crease", "parameters": [{"name": "angle", "min": 0.0, "max": 180.0, "default": 30.0, "unit": "degrees"}]},
]


def minimal(**line_set):
    return {"schema": style.SCHEMA, "line_sets": [line_set]}


def refused(data, definitions=None):
    with pytest.raises(style.StyleError) as error:
        style.parse(json.dumps(data), definitions)
    return str(error.value)


@pytest.mark.parametrize("name", style.names())
def test_shipped_styles_load_and_come_back_the_same(name):
    loaded = style.load(name)
    assert style.parse(style.dump(loaded)) == loaded
    assert loaded.line_sets[-1].kinds


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
    read = style.parse(json.dumps(data), DEFINITIONS)
    line_set = read.line_sets[0]
    assert read.paper == style.Paper((0.0, 0.0, 1.0), True)
    assert (line_set.name, line_set.kinds, line_set.corner_angle) == ("thin", {"crease": {"angle": 45.0}}, 20.0)
    assert line_set.pen == style.Pen((0.1, 0.2, 0.3), 0.5, 3.0, "solid", 2.0, "butt", 4.0, 0.5)


@pytest.mark.parametrize(
    "data, named",
    [
        ({**minimal(), "papper": {}}, "papper"),
        (minimal(kindes={}), "kindes"),
        (minimal(pen={"colour": [0, 0, 0]}), "colour"),
        (minimal(kinds={"creese": {}}), "creese"),
        (minimal(kinds={"crease": {"angel": 3}}), "angel"),
        (minimal(kinds={"crease": {"angle": 200}}), "200"),
        (minimal(kinds={"crease": {"angle": float("nan")}}), "nan"),
        (minimal(pen={"width": -1}), "-1"),
        (minimal(pen={"width": True}), "True"),
        (minimal(pen={"cap": "square"}), "square"),
        (minimal(pen={"color": [0, 0]}), "3 numbers"),
        (minimal(pen={"texture": "no_such_texture"}), "no_such_texture"),
        (minimal(name=3), "name"),
        ({"schema": style.SCHEMA, "line_sets": []}, "line_sets"),
        ({"schema": 99, "line_sets": [{}]}, "99"),
        ([], "JSON object"),
    ],
)
def test_what_does_not_belong_is_named(data, named):
    assert named in refused(data, DEFINITIONS)


def test_text_that_is_not_json():
    with pytest.raises(style.StyleError, match="not JSON"):
        style.parse("{")


@pytest.mark.parametrize("path", ["../secret", "/etc/passwd", "a/b", "..", "a\\b", "ink.png"])
def test_no_name_leads_out_of_its_folder(path):
    assert path.replace("\\", "\\\\") in refused(minimal(pen={"texture": path}))
    with pytest.raises(style.StyleError):
        style.load(path)


def test_switches_may_be_written_as_true_and_false():
    switch = {"name": "sharp_marks", "min": 0.0, "max": 1.0, "default": 1.0, "unit": "bool"}
    definitions = [{"name": "crease", "parameters": [switch]}]
    read = style.parse(json.dumps(minimal(kinds={"crease": {"sharp_marks": False}})), definitions)
    assert read.line_sets[0].kinds == {"crease": {"sharp_marks": 0.0}}
