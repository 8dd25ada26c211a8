# SPDX-License-Identifier: GPL-3.0-or-later
"""Painted values, focus on objects and density maps: in style files, and as input of the native module."""

import json

import numpy as np
import pytest
from native_core import box, core, scene, view

from addon import pipeline, style


def parsed(**parts):
    return style.parse(json.dumps({"schema": style.SCHEMA, "line_sets": [{}]} | parts))


def test_names_in_scenes_survive():
    points = [{"object": "Chair, old (2)", "near": 0.5, "far": 2}, {"at": [1, 2, 3]}]
    thinned = {"enabled": True, "painted": 2, "priority_attribute": "wichtig?", "density_attribute": "Dichte 1"}
    read = parsed(focus={"model": "object", "points": points}, elision=thinned)
    assert read.focus.points[0] == style.FocusPlace(at=(0.5, 0.5, 0.0), near=0.5, far=2.0, object="Chair, old (2)")
    assert read.focus.active() and read.focus.points[1].object == ""
    assert read.elision.painted == 2.0
    assert style.parse(style.dump(read)) == read
    read = parsed(focus={"model": "painted", "attribute": "Focus", "points": []})
    assert read.focus.active() and style.parse(style.dump(read)) == read


def test_what_is_painted_counts_only_where_it_has_a_name():
    nothing_else = dict.fromkeys(OTHERS, 0.0) | {"painted": 1.0}
    assert not style.Elision(**nothing_else).ranks()
    assert style.Elision(**nothing_else, priority_attribute="a").ranks()
    assert not style.Focus(model="painted").active()


OTHERS = {f["name"]: 0 for f in style.Elision.fields if f["group"] == "weights" and f["name"] != "painted"}


@pytest.mark.parametrize(
    "parts, sentence",
    [
        ({"focus": {"model": "painted"}}, "focus.attribute must name what is painted"),
        ({"focus": {"model": "painted", "attribute": "x" * 64}}, "focus.attribute must be text of at most 63 letters"),
        ({"focus": {"attribute": 3}}, "focus.attribute must be text of at most 63 letters"),
        ({"focus": {"attribute": "a\nb"}}, "focus.attribute must be text of at most 63 letters"),
        ({"focus": {"points": [{"object": ["Box"]}]}}, "focus.points[0].object must be text of at most 255 letters"),
        ({"elision": {"priority_attribute": None}}, "elision.priority_attribute must be text of at most 63 letters"),
        ({"elision": {"density_attribute": "\0"}}, "elision.density_attribute must be text of at most 63 letters"),
        ({"line_sets": [{"pen": {"paint_width": "weight"}}]}, "line_sets[0].pen.paint_width is 'weight'; it can be:"),
        (
            {"line_sets": [{"pen": {"paint_color_name": "x" * 64}}]},
            "paint_color_name must be text of at most 63 letters",
        ),
        ({"elision": {"painted": 11}}, "elision.painted is 11, outside 0 to 10"),
        ({"elision": {"frames": 9}}, "elision.frames is 9, outside 0 to 8"),
        ({"elision": {"frames": 1.5}}, "elision.frames must be a whole number"),
        ({"elision": {"frames": True}}, "elision.frames must be a whole number"),
        ({"elision": OTHERS}, "elision: some of length, kind, strength, depth, object, painted must count"),
    ],
)
def test_what_does_not_belong_is_named(parts, sentence):
    with pytest.raises(style.StyleError) as error:
        parsed(**parts)
    assert sentence in str(error.value)


def test_paints_of_pens_survive():
    paints = {"paint_width": "vertex_group", "paint_width_name": "Dicke", "paint_opacity": "object"}
    pen = paints | {"paint_color": "attribute", "paint_color_name": "Farbe, alt"}
    read = parsed(line_sets=[{"pen": pen, "pen_away": {"paint_width": "constant", "paint_color": "material"}}])
    near, away = read.line_sets[0].pen, read.line_sets[0].pen_away
    assert (near.paint_width, near.paint_width_name, near.paint_opacity) == ("vertex_group", "Dicke", "object")
    assert (away.paint_width, away.paint_opacity, away.paint_color) == ("constant", "object", "material")
    assert style.parse(style.dump(read)) == read


SEEN = ("attribute", "seen")
PEN = {"pen": {"width": 3}, "pen_away": {"width": 3, "opacity": 0.1}}


def drawn(look, **notes):
    """A Frame of two boxes, side by side, the left one in focus; its lines are found and filtered."""
    matrices = np.array([np.eye(4), np.eye(4)])
    matrices[0][0, 3], matrices[1][0, 3] = -2, 2
    placed, seen = scene([box().surface()] * 2, matrices), view((0, -12, 3), (0, 0, 0))
    chosen = parsed(line_sets=[{"kinds": {"crease": {}}, **PEN}], focus=look)
    said = core.Overrides(objects=(("A",), ("B",)), objects_of_placement=np.arange(2, dtype=np.uint32), **notes)
    made = pipeline.frame(placed, seen, chosen, core.CpuBackend(), pipeline.options(), notes=said)
    made.filter()
    return made


def of_placements(made):
    """(samples,) of a Frame's, by placement."""
    of_point = np.repeat(made.paths.placement[made.clipped.path], np.diff(made.clipped.offsets))
    return np.repeat(of_point, made.clipped.sample_count)


def test_each_placement_has_its_own_paint():
    look, quarter = {"model": "painted", "attribute": "seen"}, np.full(24, 0.25, np.float32)
    made = drawn(look, painted={SEEN: [quarter, None]})
    np.testing.assert_array_equal(made.focus, np.where(of_placements(made) == 0, 0.75, 0.5).astype(np.float32))
    assert set(np.unique(made.focus_of_pixels())) >= {np.float32(0.5), np.float32(0.75), np.float32(1)}
    with pytest.raises(ValueError, match="one array per placement"):
        drawn(look, painted={SEEN: [quarter]})
    with pytest.raises(ValueError, match="box: one painted value per corner"):
        drawn(look, painted={SEEN: [np.zeros(3, np.float32), None]})
    with pytest.raises(ValueError, match="painted: source is 'weights'; it can be: constant, vertex_group, attribute"):
        drawn(look, painted={("weights", "seen"): [quarter, None]})


def test_focus_falls_off_from_the_surface_of_an_object():
    made = drawn({"model": "object", "points": [{"object": "A", "near": 0.5, "far": 4.5}]})
    placement = of_placements(made)
    assert set(placement) == {0, 1} and np.all(made.focus[placement == 0] == 0)
    # The boxes lie two units apart, and are two units wide.
    assert made.focus[placement == 1].min() == pytest.approx(1.5 / 4, abs=1e-4)
    assert made.focus[placement == 1].max() == pytest.approx(3.5 / 4, abs=1e-4)
    pixels = drawn({"model": "object", "points": [{"object": "A", "near": 0, "far": 9}]}).focus_of_pixels()
    assert pixels.min() < 1e-4 and pixels.max() == 1
