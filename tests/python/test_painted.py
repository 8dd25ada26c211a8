# SPDX-License-Identifier: GPL-3.0-or-later
"""Painted values, focus by objects and maps of density: as styles say them, and as the native module takes them."""

import json

import numpy as np
import pytest
from native_core import box, core, scene, view

from addon import style


def parsed(**parts):
    return style.parse(json.dumps({"schema": style.SCHEMA, "line_sets": [{}], **parts}))


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


@pytest.fixture
def drawn():
    """Two boxes, side by side: scene, view, tracer, paths and clipped paths."""
    matrices = np.array([np.eye(4), np.eye(4)])
    matrices[0][0, 3], matrices[1][0, 3] = -2, 2
    placed, seen = scene([box().surface()] * 2, matrices), view((0, -12, 3), (0, 0, 0))
    tracer = core.Tracer(placed, seen)
    paths = core.extract_paths(tracer, [({"crease": {}}, 60.0)])
    return placed, seen, tracer, paths, core.project(paths, tracer, 2.0)


def test_each_placement_has_its_own_paint(drawn):
    placed, _, tracer, paths, clipped = drawn
    painted = [np.full(24, 0.25, np.float32), None]
    found = core.values_on_paths(paths, placed, painted)
    of_point = np.repeat(paths.placement, np.diff(paths.offsets))
    assert set(of_point) == {0, 1}
    np.testing.assert_allclose(found, np.where(of_point == 0, 0.25, 0.5))
    samples = core.values_of_samples(clipped, found)
    assert len(samples) == clipped.samples and set(np.unique(samples)) == {np.float32(0.25), np.float32(0.5)}
    image = core.painted_image(tracer, painted)
    assert set(np.unique(image)) >= {np.float32(0), np.float32(0.25), np.float32(0.5)}
    with pytest.raises(ValueError, match="one array per placement"):
        core.values_on_paths(paths, placed, painted[:1])
    with pytest.raises(ValueError, match="box: one painted value per corner"):
        core.values_on_paths(paths, placed, [np.zeros(3, np.float32), None])
    with pytest.raises(ValueError, match="one per point of the paths"):
        core.values_of_samples(clipped, found[:3])


def test_focus_falls_off_from_the_surface_of_an_object(drawn):
    placed, seen, tracer, paths, clipped = drawn
    surface = core.SurfaceDistance(placed, seen, np.array([0], np.uint32))
    found = core.focus_of_samples(clipped, core.Focus(True, [(0, 0, 0, 0.5, 4.5)], False, [surface]))
    place = np.zeros(clipped.samples, np.int64)
    for piece, (first, last) in enumerate(zip(clipped.offsets, clipped.offsets[1:])):
        for i in range(first, last - 1):
            start = clipped.sample_start[i]
            place[start : start + clipped.sample_count[i]] = paths.placement[clipped.path[piece]]
    assert np.all(found[place == 0] == 0)
    # The boxes lie two units apart, and are two units wide.
    assert found[place == 1].min() == pytest.approx(1.5 / 4, abs=1e-4)
    assert found[place == 1].max() == pytest.approx(3.5 / 4, abs=1e-4)
    pixels = core.focus_of_pixels(seen, core.depth_image(tracer), core.Focus(True, [(0, 0, 0, 0, 9)], False, [surface]))
    assert pixels.min() < 1e-4 and pixels.max() == 1
    with pytest.raises(ValueError, match="one or None per point"):
        core.Focus(True, [(0, 0, 0, 0, 1)] * 2, False, [surface])


def test_a_map_lies_over_the_frame_and_goes_on_beyond_it(drawn):
    _, seen, _, _, clipped = drawn
    width = seen.width
    halves = np.array([[[0.0], [1.0]]], np.float32)  # black on the left, white on the right
    found = core.map_of_samples(clipped, seen, core.ColorTexture(halves, False))
    x = np.concatenate(
        [
            a[0] + (b[0] - a[0]) * (np.arange(count) + 0.5) / count
            for a, b, count in zip(clipped.px, clipped.px[1:], clipped.sample_count)
        ]
    )
    np.testing.assert_allclose(found, np.clip(2 * x / width - 0.5, 0, 1), atol=5e-3)
