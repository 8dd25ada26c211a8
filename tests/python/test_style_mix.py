# SPDX-License-Identifier: GPL-3.0-or-later
"""Mixing two styles: common parts are interpolated steadily, others fade, and the end points are the styles
themselves."""

import pytest

from addon import style
from addon.style import Hidden, LineSet, Paper, Pen, Style

NAMES = style.names()


def opacity_of(mixed, kind):
    """How opaque lines of a kind are."""
    return next((s.pen.opacity for s in mixed.line_sets if kind in s.kinds), 0.0)


def kinds(wanted):
    return [kind for line_set in wanted.line_sets for kind in line_set.kinds]


@pytest.mark.parametrize("other", NAMES)
def test_the_ends_are_the_styles(other):
    one, two = style.load("pen_and_ink"), style.load(other)
    assert one.mixed(two, 0.0) == one and one.mixed(two, -1.0) == one
    assert one.mixed(two, 1.0) == two.replace(focus=one.focus)


@pytest.mark.parametrize("share", [0.01, 0.3, 0.5, 0.8, 0.99])
@pytest.mark.parametrize("name", NAMES)
def test_between_a_style_and_itself_is_that_style(name, share):
    one = style.load(name)
    assert flat(one.mixed(one, share)) == pytest.approx(flat(one))


def members(record, *but):
    return {f["name"]: getattr(record, f["name"]) for f in record.fields if f["name"] not in but}


def flat(data, where=""):
    """{dotted name: number or word} of nested records; what a style draws of each kind of lines."""
    if isinstance(data, Style):
        parts = members(data, "line_sets", "kept")
        sets = {k: members(s) | {"kinds": s.kinds[k]} for s in reversed(data.line_sets) for k in s.kinds}
        data = parts | sets
    if hasattr(data, "fields"):
        data = members(data)
    if isinstance(data, tuple):
        data = dict(enumerate(data))
    if isinstance(data, dict):
        return {key: value for name, part in data.items() for key, value in flat(part, f"{where}.{name}").items()}
    return {where: data}


@pytest.mark.parametrize("one", NAMES)
@pytest.mark.parametrize("two", NAMES)
def test_every_line_of_both_is_drawn_once(one, two):
    a, b = style.load(one), style.load(two)
    for share in (0.2, 0.7):
        mixed = a.mixed(b, share)
        assert sorted(set(kinds(mixed))) == sorted(set(kinds(a)) | set(kinds(b)))
        for kind in set(kinds(a)) - set(kinds(b)):
            assert opacity_of(mixed, kind) == pytest.approx((1 - share) * opacity_of(a, kind))
        for kind in set(kinds(b)) - set(kinds(a)):
            assert opacity_of(mixed, kind) == pytest.approx(share * opacity_of(b, kind))
        for kind in set(kinds(a)) & set(kinds(b)):
            wanted = (1 - share) * opacity_of(a, kind) + share * opacity_of(b, kind)
            assert opacity_of(mixed, kind) == pytest.approx(wanted)
        # What is made is a style: its file can be read again.
        assert style.parse(style.dump(mixed)).line_sets == mixed.line_sets


def test_numbers_and_colors_go_over_steadily():
    one = Style(paper=Paper(color=(1.0, 1.0, 1.0), scale=1.0), line_sets=(LineSet(kinds={"crease": {"angle": 20.0}}),))
    two = Style(paper=Paper(color=(0.0, 0.5, 1.0), scale=3.0), line_sets=(LineSet(kinds={"crease": {"angle": 60.0}}),))
    mixed = one.mixed(two, 0.25)
    assert mixed.paper.color == (0.75, 0.875, 1.0) and mixed.paper.scale == 1.5
    assert mixed.line_sets[0].kinds["crease"]["angle"] == 30.0


def test_what_only_one_has_out_of_focus_comes_from_its_pen_in_focus():
    pen, away = Pen(width=2.0), Pen(width=10.0)
    one, two = (Style(line_sets=(LineSet(kinds={"crease": {}}, pen=pen, pen_away=a),)) for a in (None, away))
    assert one.mixed(two, 0.25).line_sets[0].pen_away.width == 4.0


def test_hidden_pens_of_different_ranges_fade_one_after_the_other():
    one, two = (
        Style(
            line_sets=(LineSet(kinds={"crease": {}}, hidden=(Hidden(pen=Pen(opacity=0.8), first=first, last=last),)),)
        )
        for first, last in ((1, 1), (1, None))
    )
    at = {share: one.mixed(two, share).line_sets[0].hidden[0] for share in (0.25, 0.5, 0.75)}
    assert (at[0.25].last, at[0.75].last) == (1, None)
    assert [at[share].pen.opacity for share in at] == pytest.approx([0.4, 0.0, 0.4])


def test_line_sets_meet_those_of_the_same_things():
    mine, yours = Pen(width=2.0), Pen(width=4.0)
    cup = {"object": "Cup", "other_objects": True}
    one = Style(
        line_sets=(
            LineSet(name="a", kinds={"crease": {}}, **cup, pen=mine),
            LineSet(name="b", kinds={"crease": {}}, pen=mine),
        )
    )
    other = Style(
        line_sets=(
            LineSet(name="c", kinds={"crease": {}}, pen=yours),
            LineSet(name="d", kinds={"crease": {}}, material="Glass", pen=yours),
            LineSet(name="e", kinds={"crease": {}}, **cup, pen=yours),
        )
    )
    assert one.mixed(one, 0.5) == one, "what stands twice for the same kind stays apart"
    found = {(s.object, s.other_objects, s.material): s.pen for s in one.mixed(other, 0.25).line_sets}
    assert len(found) == 3
    assert found["Cup", True, ""] == found["", False, ""] == Pen(width=2.5)
    assert found["", False, "Glass"] == yours.replace(opacity=0.25)
    twice = Style(
        line_sets=(
            LineSet(name="f", kinds={"crease": {"angle": 90.0}}),
            LineSet(name="g", kinds={"crease": {"angle": 20.0}}),
        )
    )
    assert twice.mixed(twice, 0.5) == twice


def test_modifiers_along_strokes_are_mixed():
    mine = Pen(nib_width=0.8, nib_angle=20.0, noise_length=4.0, second_color=(1.0, 0.0, 0.0))
    yours = Pen(nib_angle=60.0, distance_color=0.5, along_width=style.Transfer(strength=0.6, curve=((0.0, 1.0),)))
    one, two = (Style(line_sets=(LineSet(kinds={"crease": {}}, pen=pen),)) for pen in (mine, yours))
    pen = one.mixed(two, 0.25).line_sets[0].pen
    assert (pen.nib_width, pen.nib_angle, pen.noise_length) == pytest.approx((0.6, 30.0, 5.5))
    assert pen.second_color == pytest.approx((0.875, 0.125, 0.125))
    assert (pen.distance_color, pen.along_width.strength) == pytest.approx((0.125, 0.15))
