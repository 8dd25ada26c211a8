# SPDX-License-Identifier: GPL-3.0-or-later
"""Unknown fields of a style file are preserved in place, and reported."""

import json

from addon import style


def minimal(**line_set):
    return {"schema": style.SCHEMA, "line_sets": [line_set]}


WITH_UNKNOWN = minimal(
    kindes={},
    kinds={"creese": {"angle": 3}, "crease": {"angel": 3}},
    pen={"colour": [0, 0, 0], "width": 3},
    pen_away={"widht": [1, {"a": None}]},
    hidden=[{"from": 4, "form": 4}, {"from": 1, "to": 2, "pen": {"capp": "x"}}],
) | {
    "papper": {"color": "../../etc"},
    "focus": {"points": [{"at": [0, 1]}, {"where": 1}]},
    "effects": {"fade": {"begin": 1}},
}
NAMES = {
    "papper": "paper",
    "line_sets[0].kindes": "kinds",
    "line_sets[0].kinds.creese": "crease",
    "line_sets[0].kinds.crease.angel": "angle",
    "line_sets[0].pen.colour": "color",
    "line_sets[0].pen_away.widht": "width",
    "line_sets[0].hidden[0].pen.capp": "cap",
    "line_sets[0].hidden[1].form": "from",
    "focus.points[1].where": None,
    "effects.fade.begin": None,
}


def test_what_is_not_known_is_kept_in_its_place():
    read = style.parse(json.dumps(WITH_UNKNOWN))
    assert set(style.unknown(read)) == set(NAMES) and len(style.unknown(read)) == len(NAMES)
    assert read.line_sets[0].pen == style.Pen(width=3.0) and read.line_sets[0].kinds == {"crease": {}}
    written = style.dump(read)
    line_set = json.loads(written)["line_sets"][0]
    assert line_set["kindes"] == {} and line_set["kinds"] == {"crease": {"angel": 3}, "creese": {"angle": 3}}
    assert (line_set["pen"]["colour"], line_set["pen"]["width"]) == ([0, 0, 0], 3.0)
    assert line_set["pen_away"]["widht"] == [1, {"a": None}]
    hidden = [(h["from"], h.get("form"), h["pen"].get("capp")) for h in line_set["hidden"]]
    assert hidden == [(1, None, "x"), (4, 4, None)]
    again = style.parse(written)
    assert again == read and style.dump(again) == written
    assert read.line_sets[0].kinds == {"crease": {}}, "writing changes nothing"


def test_a_misspelt_key_is_told_with_the_name_it_resembles():
    assert style.remark(style.parse(json.dumps(minimal()))) is None
    for name, near in NAMES.items():
        read = style.parse(json.dumps(WITH_UNKNOWN))
        (only,) = (entry for entry, dotted in zip(read.kept, style.unknown(read)) if dotted == name)
        told = style.remark(read.replace(kept=(only,)))
        assert told.endswith(f": {name} (is it {near}?)" if near else f": {name}"), told
    assert style.remark(read).endswith(" and 2 more")


def test_what_was_unknown_in_a_part_that_is_gone_is_dropped():
    read = style.parse(json.dumps(WITH_UNKNOWN))
    without = read.replace(line_sets=(read.line_sets[0].replace(pen_away=None, hidden=()),))
    again = style.parse(style.dump(without))
    gone = {name for name in NAMES if "hidden" in name or "pen_away" in name}
    assert set(style.unknown(again)) == set(NAMES) - gone
    assert style.remark(without)
