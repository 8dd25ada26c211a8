# SPDX-License-Identifier: GPL-3.0-or-later
"""Drafts resemble the final picture: stand-ins for slow line definitions are drawn where these are, with their pens."""

from dataclasses import replace

import numpy as np
import pytest
from native_core import box, core, scene, sphere, view

from addon import budget, pipeline, style

DRAFT = replace(budget.QUALITIES[4], scale=1.0)
THICK, THIN = style.Pen(width=8.0), style.Pen(width=2.0)
OUTLINE = style.LineSet(kinds={"silhouette": {}}, pen=THICK, least_length=0)
LINES = style.LineSet(kinds={"contour": {}, "crease": {}, "border": {}}, pen=THIN, least_length=0)


def bumps():
    """A ball before a box, and a torus-like pair of boxes, as one and as two objects: contours within and around."""
    ball, cube = sphere(24), box()
    both = np.concatenate([cube.positions, cube.positions * 0.6 + (0.2, -2.2, 0.2)])
    joined = type(cube)("joined", both, [*cube.polygons, *(tuple(v + 8 for v in p) for p in cube.polygons)])
    matrices = np.array([np.eye(4)] * 3)
    matrices[0][:3, 3], matrices[1][:3, 3], matrices[2][:3, 3] = (-3, 0, 0), (-2.2, 2.5, 0.5), (3, 0, 0)
    return scene([ball.surface(), cube.surface(), joined.surface()], matrices)


def drawn(line_sets, quality=None, placements=()):
    """(H, W) alpha of lines, final or as a quality draws them."""
    chosen = style.load("plain").replace(line_sets=line_sets)
    options, placed = pipeline.options(), bumps()
    if quality:
        options = budget.coarser(options, quality).replace(outlines=budget.outlines(chosen, quality))
        chosen = budget.simplified(chosen, quality)
    seen = view((0, -14, 4), (0, 0, 0), size=(480, 270))
    notes = core.Overrides(placements=placements)
    return pipeline.draw(placed, seen, chosen, core.CpuBackend(), options, notes=notes).lines[..., 3]


def apart(a, b):
    """Share of the ink that is elsewhere, or of another weight."""
    return np.abs(a - b).sum() / max(a.sum(), b.sum())


IN_FRONT = (np.array([0, 1, 1], np.uint8), None)
CASES = {
    "outline over lines": ((OUTLINE, LINES), ()),
    "outline alone": ((OUTLINE,), ()),
    "lines first": ((LINES, OUTLINE), ()),
    "one set for both": ((OUTLINE.replace(kinds={**OUTLINE.kinds, **LINES.kinds}),), ()),
    "outline with creases": ((OUTLINE.replace(kinds={"silhouette": {}, "crease": {}}), LINES), ()),
    "outline of some objects": ((OUTLINE, LINES), IN_FRONT),
    "lines of some objects": ((OUTLINE, LINES), IN_FRONT[::-1]),
}


@pytest.mark.parametrize("name", CASES)
def test_a_draft_has_the_weights_of_the_final_picture(name):
    line_sets, placements = CASES[name]
    final, draft = drawn(line_sets, None, placements), drawn(line_sets, DRAFT, placements)
    assert final.sum() > 1000
    assert abs(draft.sum() / final.sum() - 1) < 0.02 and apart(final, draft) < 0.05


@pytest.mark.parametrize("outline, lines", [("smooth_silhouette", "smooth_contour"), ("silhouette", "smooth_contour")])
def test_smooth_outlines_too(outline, lines):
    sets = (OUTLINE.replace(kinds={outline: {}}), LINES.replace(kinds={lines: {}, "crease": {}}))
    final, draft = drawn(sets), drawn(sets, DRAFT)
    assert abs(draft.sum() / final.sum() - 1) < 0.05 and apart(final, draft) < 0.05


def test_the_weights_differ_where_contours_are_no_outlines():
    """What the tests above would not see, were inner and outer parts drawn alike."""
    alike = (LINES.replace(pen=THICK, kinds={**LINES.kinds, "silhouette": {}}),)
    assert apart(drawn((OUTLINE, LINES)), drawn(alike)) > 0.2
    assert apart(drawn((OUTLINE, LINES)), drawn((LINES,))) > 0.2


def test_drafts_keep_what_is_found_quickly():
    kinds = {"ridge", "valley", "suggestive_contour", "intersection", "apparent_ridge"}
    chosen = style.load("plain").replace(line_sets=(style.LineSet(kinds={kind: {} for kind in kinds}),))
    assert set(budget.simplified(chosen, DRAFT).line_sets[0].kinds) == kinds
    assert budget.outlines(chosen, DRAFT) == ()


PLACES = {
    "image": {"points": (style.FocusPlace(at=(0.25, 0.5, 0.0), near=0.1, far=0.3),)},
    "scene": {"points": (style.FocusPlace(at=(-3.0, 0.0, 0.0), near=1.0, far=2.0),)},
    "object": {"points": (style.FocusPlace(near=0.1, far=0.5, object="Ball"),)},
    "painted": {"attribute": "seen"},
}
DIMMED = {name: style.Transfer(strength=0.7) for name in ("desaturation", "fade", "blur")}


def dimmed(model, quality=None, effects=style.Effects(**DIMMED)):
    """The Image of red things, of which the ball on the left is in focus; final or as a quality draws it."""
    chosen = style.load("plain").replace(
        line_sets=(style.LineSet(),),
        color=style.Color(shading="flat"),
        effects=effects,
        focus=style.Focus(model=model, **PLACES[model]),
    )
    options, seen, placed = pipeline.options(), view((0, -14, 4), (0, 0, 0), size=(480, 270)), bumps()
    if quality:
        options, chosen = budget.coarser(options, quality), budget.simplified(chosen, quality)
        seen = seen.smaller(quality.scale)
    ball, cube = (sum(map(len, mesh.polygons)) for mesh in (sphere(24), box()))
    painted = {
        ("attribute", "seen"): [np.ones(ball, np.float32), np.zeros(cube, np.float32), np.zeros(2 * cube, np.float32)]
    }
    sources = core.ColorSources([core.SurfaceColor([core.ColorSlot((0.8, 0.1, 0.1))])] * 3, [], (0, 0, 0))
    beside = {
        "colors": sources,
        "notes": core.Overrides(
            painted=painted,
            objects=(("Ball",), ("Cube",), ("Pair",)),
            objects_of_placement=np.arange(3, dtype=np.uint32),
        ),
    }
    return pipeline.draw(placed, seen, chosen, core.CpuBackend(), options.replace(with_focus=True), **beside)


def halves(image):
    """(2, 3) mean colors of what lies in focus and of what does not, at the left and at the right."""
    left, right = np.array_split(image.combined[..., :3], 2, axis=1)
    return np.array([left.mean((0, 1)), right.mean((0, 1))])


@pytest.mark.parametrize("model", PLACES)
@pytest.mark.parametrize("index", range(1, len(budget.QUALITIES)))
def test_a_draft_of_any_quality_fades_and_desaturates_as_the_final_picture_does(model, index):
    final, draft = dimmed(model), dimmed(model, budget.QUALITIES[index])
    plain = halves(dimmed(model, effects=style.Effects()))
    assert np.abs(plain - halves(final))[1].max() > 0.05, "what is out of focus is another color without the effects"
    assert np.abs(halves(draft) - halves(final)).max() < 0.005


@pytest.mark.parametrize("model", PLACES)
def test_focus_evaluated_at_fewer_pixels_is_that_of_the_final_picture_but_along_outlines(model):
    final, draft = dimmed(model).focus, dimmed(model, DRAFT).focus
    assert draft.shape == final.shape and DRAFT.focus_step > 1
    assert (np.abs(draft - final) > 0.1).mean() < 0.03


def test_blur_is_left_out_of_every_draft():
    blurred = style.load("plain").replace(effects=style.Effects(**DIMMED))
    for quality in budget.QUALITIES[1:]:
        effects = budget.simplified(blurred, quality).effects
        assert effects == blurred.effects.replace(blur=blurred.effects.blur.replace(strength=0.0))
