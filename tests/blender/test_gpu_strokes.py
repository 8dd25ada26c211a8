# SPDX-License-Identifier: GPL-3.0-or-later
"""The gpu backend's strokes equal those of the cpu backend."""

import numpy as np
import pytest
from native_frames import ball, box, core, frame_of, hills, moved, pipeline, room, scene_of, style, view_of
from the_addon import part

pytestmark = pytest.mark.gpu


@pytest.mark.parametrize("name", style.names())
def test_every_style(name):
    chosen, view = style.load(name), view_of(480, 300)
    for thinned in (False, True):
        chosen = chosen.replace(elision=chosen.elision.replace(enabled=thinned))
        drawn, reference = (
            pipeline.draw(room(), view, chosen, backend, pipeline.options()).lines
            for backend in (part("gpu.backend").Backend(), core.CpuBackend())
        )
        assert drawn.shape == reference.shape == (300, 480, 4) and drawn.dtype == np.float32
        assert reference[..., 3].mean() > 0.01
        differs = np.abs(drawn - reference)
        # A sample at the border of a band may count on one side alone: a line is a little paler there.
        assert (differs.max(axis=-1) >= 0.02).mean() <= (1e-4 if thinned else 0) and differs.max() < 0.1
        assert differs.mean() < 5e-4


def on_both(scene, chosen, visibility="exact", **more):
    """(200, 320, 4) of a Frame's strokes in a Style by the gpu, how far they are from the cpu's at each pixel, and the
    strokes."""
    frame = frame_of(scene, view_of(320, 200), chosen, visibility=visibility, **more)
    frame.ink()
    drawn = part("gpu.backend").Backend().draw(frame)
    return drawn, np.abs(drawn - core.CpuBackend().draw(frame)).max(axis=2), frame.strokes


def lines_by(*pens):
    """A Style that draws contours with the first of some pens, creases with the last."""
    kinds = ({"contour": {}}, {"crease": {}}) if len(pens) > 1 else ({"contour": {}, "crease": {}},)
    sets = (style.LineSet(kinds=k, least_length=0, pen=pen) for k, pen in zip(kinds, pens, strict=True))
    return style.Style(line_sets=tuple(sets))


def test_caps_and_textures():
    pictures = {}
    for cap in ("round", "butt"):
        for texture in ("solid", "pencil"):
            pen = style.Pen(color=(0.2, 0.4, 0.9), width=6, opacity=0.8, cap=cap, texture=texture)
            drawn, off, _ = on_both(room(), lines_by(pen))
            assert off.mean() < 1e-3 and (off > 0.02).mean() < 1e-3
            assert 0.5 < np.quantile(drawn[..., 3], 0.99) <= 1
            pictures[cap, texture] = drawn
    assert np.abs(pictures["round", "solid"] - pictures["butt", "solid"]).max() > 0.3
    assert np.abs(pictures["round", "solid"] - pictures["round", "pencil"]).max() > 0.3


@pytest.mark.parametrize("length_scale", [0.03, 0.1, 0.37, 1.0, 5.0])
def test_textures_anchored_to_the_path(length_scale):
    """Within an octave and at its ends, for paths shorter than the texture and much longer."""
    drawn = {}
    for anchor in ("screen", "path"):
        pen = style.Pen(width=6, texture="pencil", length_scale=length_scale, texture_anchor=anchor)
        drawn[anchor], off, _ = on_both(room(), lines_by(pen))
        assert off.mean() < 1e-3 and (off > 0.02).mean() < 1e-3
    assert np.abs(drawn["path"] - drawn["screen"]).max() > 0.1


def test_later_strokes_lie_over_earlier_ones():
    red, blue = (style.Pen(color=color, width=6, opacity=0.5) for color in ((1, 0, 0), (0, 0, 1)))
    drawn, off, _ = on_both(room(), lines_by(red, blue))
    assert off.mean() < 1e-3 and (off > 0.02).mean() < 1e-3
    assert ((drawn[..., 0] > 0.2) & (drawn[..., 2] > 0.2)).sum() > 4


def test_strokes_that_thin_and_fade_with_strength():
    """Lines of a hilly surface whose strength varies, by pens that use it in every way."""
    kinds = {"suggestive_contour": {}, "suggestive_highlight": {}, "ridge": {}}
    pictures = []
    for share in (0.0, 0.5, 1.0):
        pen = style.Pen(width=7.0, strength_width=share)
        chosen = style.Style(line_sets=(style.LineSet(kinds=kinds, least_length=0, pen=pen),))
        drawn, off, strokes = on_both(scene_of([(hills(), np.eye(4))]), chosen)
        # Where a wide stroke folds, either may give single pixels to the neighboring triangle.
        assert off.mean() < 1e-4 and (off > 0.02).sum() <= 4 and off.max() < 0.1
        assert np.ptp(strokes.half_width) > 1 if share else np.ptp(strokes.half_width) == 0
        pictures.append(drawn)
    assert all(picture[..., 3].max() > 0.5 for picture in pictures)
    assert np.abs(pictures[0] - pictures[2]).max() > 0.3


def test_strokes_on_their_way_out_of_focus():
    """Color, ink, width and opacity between two pens, by a focus that falls off over the image."""
    pen = style.Pen(color=(1, 0, 0), width=5)
    away = style.Pen(color=(0, 0, 1), width=2, opacity=0.5, texture="pencil")
    lines = style.LineSet(kinds={"crease": {}, "contour": {}}, least_length=0, pen=pen, pen_away=away)
    look = style.Focus(model="image", points=(style.FocusPlace(at=(100 / 320, 0.5, 0.0), near=0.1, far=0.75),))
    drawn, off, strokes = on_both(room(), style.Style(line_sets=(lines,), focus=look))
    assert np.ptp(strokes.mix) > 0.9 and np.ptp(strokes.half_width) > 1
    assert off.mean() < 1e-3 and (off > 0.02).mean() < 1e-3
    assert drawn[..., 0].max() > 0.9 and drawn[..., 2].max() > 0.3


ALONG = {
    "along": {"along_width": style.Transfer(curve=((0, 0.2), (0.5, 0.9), (1, 0))), "along_color": style.Transfer()},
    "nib": {"nib_width": 0.9, "nib_color": 1.0},
    "distance": {"distance_near": 4.0, "distance_far": 12.0, "distance_opacity": 0.9, "distance_color": 1.0},
    "noise": {"noise_length": 8.0, "noise_width": 0.9, "noise_color": 1.0},
}


@pytest.mark.parametrize("cause", ALONG)
@pytest.mark.parametrize("away", [None, style.Pen(color=(0, 0.5, 0), second_color=(0.5, 0.5, 0), width=5)])
def test_strokes_that_change_along_their_way(cause, away):
    pen = style.Pen(color=(1, 0, 0), second_color=(0, 0, 1), width=9, **ALONG[cause])
    lines = style.LineSet(kinds={"crease": {}, "contour": {}}, least_length=0, pen=pen, pen_away=away)
    look = style.Focus(model="image", points=(style.FocusPlace(at=(100 / 320, 0.5, 0.0), near=0.1, far=0.75),))
    drawn, off, strokes = on_both(room(), style.Style(line_sets=(lines,), focus=look))
    assert np.ptp(strokes.mix[:, 2]) > 0.2 and max(np.ptp(strokes.half_width), 3 * np.ptp(strokes.opacity)) > 1
    assert off.mean() < 1e-3 and (off > 0.02).mean() < 1e-3
    assert drawn[..., 0].max() > 0.3 and drawn[..., 2].max() > 0.1


@pytest.mark.parametrize("visibility", ["exact", "spine"])
@pytest.mark.parametrize("away", [None, style.Pen(color=(0, 0.5, 0), width=5)])
def test_strokes_with_what_is_painted(visibility, away):
    """Numbers that vary over each thing, and a color of each of them."""
    placed = room()
    rng = np.random.default_rng(2)
    corners = {"Box": 6 * 4, "Ball": 2 * 48 * 3 + 22 * 48 * 4}
    names = [placed.surface(i).name for i in range(len(placed))]
    numbers = [rng.uniform(size=corners[name]).astype(np.float32) for name in names]
    colors = [rng.uniform(size=(1, 3)).astype(np.float32) for _ in range(len(placed))]
    notes = core.Overrides(painted={("attribute", "a"): numbers}, painted_colors={("object", ""): colors})
    paints = {"paint_width": "attribute", "paint_width_name": "a", "paint_color": "object"}
    pen = style.Pen(color=(1, 0, 0), second_color=(0, 0, 1), width=9, **ALONG["nib"], **paints)
    lines = style.LineSet(kinds={"crease": {}, "contour": {}}, least_length=0, pen=pen, pen_away=away)
    look = style.Focus(model="image", points=(style.FocusPlace(at=(100 / 320, 0.5, 0.0), near=0.1, far=0.75),))
    drawn, off, strokes = on_both(placed, style.Style(line_sets=(lines,), focus=look), visibility, notes=notes)
    assert len(strokes.color) == len(strokes.px) and np.ptp(strokes.color, axis=0).min() > 0.3
    assert np.ptp(strokes.half_width) > 1
    assert off.mean() < 1e-3 and (off > 0.02).mean() < 2e-3
    assert drawn[..., 1].max() > 0.3


def test_strokes_that_boil_and_are_written_by_half():
    pen = style.Pen(width=6, wobble=8, wobble_length=60)
    boiling, pictures = style.Animation(boil=0.7, written=0.5), []
    for drawing in range(2):
        chosen = lines_by(pen).replace(animation=boiling)
        drawn, off, _ = on_both(room(), chosen, boil_drawing=drawing)
        assert off.mean() < 1e-3 and (off > 0.02).mean() < 1e-3 and drawn[..., 3].max() > 0.9
        pictures.append(drawn)
    assert np.abs(pictures[0] - pictures[1]).max() > 0.3


def test_strokes_that_break_up_through_their_texture():
    """Behind a bar that passes, lines are seen for a part of the time."""
    chosen = lines_by(style.Pen(width=8, texture="pencil")).replace(
        animation=style.Animation(visibility_frames=2, vanish="break_up")
    )
    options, view = pipeline.options(visibility="exact"), view_of(320, 200)

    def at(frame, near=None):
        bar = (box((0.2, 0.2, 3)), moved((0.4 * frame + 2, -2.4, 0)))
        scene = scene_of([(box((1.5, 1.5, 0.5)), moved((0, 0, 0), 0.3)), (ball(), moved((0, 0, 1.2))), bar])
        return pipeline.frame(scene, view, chosen, core.CpuBackend(), options, near=near)

    near = {away: at(away).found_lines().near_lines for away in (-2, -1, 1, 2)}
    frame = at(0, pipeline.Near(near))
    frame.ink()
    drawn, reference = part("gpu.backend").Backend().draw(frame), core.CpuBackend().draw(frame)
    off = np.abs(drawn - reference).max(axis=2)
    assert (frame.strokes.mix[:, 3] > 0.1).sum() > 50
    # At the edge of what is left ink changes ten times as fast as the texture does.
    assert off.mean() < 1e-3 and (off > 0.02).mean() < 3e-3
    whole = at(0)
    whole.ink()
    assert (core.CpuBackend().draw(whole)[..., 3] - reference[..., 3]).max() > 0.3


def test_no_strokes():
    drawn, off, strokes = on_both(scene_of([]), lines_by(style.Pen()))
    assert len(strokes) == 0 and not drawn.any() and not off.any()
