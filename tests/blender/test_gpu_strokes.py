# SPDX-License-Identifier: GPL-3.0-or-later
"""The gpu backend's strokes are those of the cpu backend."""

import numpy as np
import pytest
from native_frames import core, frame_of, hills, pipeline, room, scene_of, style, view_of
from the_addon import part

pytestmark = pytest.mark.gpu
PLAIN = core.Pen(look=style.Pen())


def on_gpu(strokes, pens, textures, view):
    return part("gpu.backend").Backend().draw_strokes(strokes, pens, textures, view)


def straight(pen, start=(10.3, 20.2), end=(150.6, 75.9), half_width=3.0, path_px=0.0):
    """A stroke of one segment, as `tessellate` would make it."""
    a, b = np.array(start), np.array(end)
    length = np.linalg.norm(b - a)
    along = (b - a) / length
    left = np.array((-along[1], along[0]))
    room_px = half_width + 0.5
    corners = [(-room_px, room_px), (-room_px, -room_px), (length + room_px, room_px), (length + room_px, -room_px)]
    px = np.array([a + u * along + v * left for u, v in corners], np.float32)
    arc = np.array([(u, v, 0, length) for u, v in corners], np.float32)
    same = np.ones(4, np.float32)
    triangles = np.array([(0, 1, 2), (2, 1, 3)], np.uint32)
    pens = np.full(4, pen, np.uint32)
    return core.Strokes(px, arc, half_width * same, 0.8 * same, pens, triangles, 1, path_px=path_px * same)


@pytest.mark.parametrize("name", style.names())
def test_every_style(name):
    chosen, view = style.load(name), view_of(480, 300)
    drawn, reference = (
        pipeline.draw(room(), view, chosen, backend, pipeline.options()).lines
        for backend in (part("gpu.backend").Backend(), core.CpuBackend())
    )
    assert drawn.shape == reference.shape == (300, 480, 4) and drawn.dtype == np.float32
    assert reference[..., 3].mean() > 0.01
    assert np.abs(drawn - reference).max() < 0.02
    assert np.abs(drawn - reference).mean() < 5e-4


@pytest.mark.parametrize("cap", ["round", "butt"])
@pytest.mark.parametrize("textured", [False, True])
def test_caps_and_textures(cap, textured):
    ink = np.random.default_rng(1).uniform(0.2, 1, (5, 40)).astype(np.float32)
    look = style.Pen(color=(0.2, 0.4, 0.9), cap=cap)
    pens = [core.Pen(look=look, width_px=6, texture_length_px=31, texture=i if textured else None) for i in range(2)]

    textures = [core.PenTexture(ink), core.PenTexture(ink[:, ::-1].copy())]
    view = view_of(160, 100)
    for number in range(2):
        stroke = straight(number)
        drawn = on_gpu(stroke, pens, textures, view)
        np.testing.assert_allclose(drawn, stroke.raster(pens, textures, 160, 100), atol=0.01)
        assert 0.5 < drawn[..., 3].max() <= 0.8001


@pytest.mark.parametrize("path_px", [3.0, 40.0, 123.4, 248.0, 250.0, 400.0, 5000.0])
def test_textures_anchored_to_the_path(path_px):
    """Within an octave, at its ends, for paths shorter than the texture and much longer than what is seen of them."""
    ink = np.random.default_rng(1).uniform(0.2, 1, (5, 40)).astype(np.float32)
    textures = [core.PenTexture(ink)]
    stretch = {"width_px": 6, "texture_length_px": 31, "texture": 0}
    stroke, drawn = straight(1, path_px=path_px), {}
    for anchor in ("screen", "path"):
        pens = [PLAIN, core.Pen(look=style.Pen(texture_anchor=anchor), **stretch)]
        drawn[anchor] = on_gpu(stroke, pens, textures, view_of(160, 100))
        np.testing.assert_allclose(drawn[anchor], stroke.raster(pens, textures, 160, 100), atol=0.01)
    # Eight repetitions of 31 pixels are the one case in which both are the same.
    assert (np.abs(drawn["path"] - drawn["screen"]).max() < 0.01) == (path_px == 248.0)


def test_later_strokes_lie_over_earlier_ones():
    pens = [core.Pen(look=style.Pen(color=color)) for color in ((1, 0, 0), (0, 0, 1))]
    a, b = straight(0), straight(1, (10, 80), (150, 20))
    both = core.Strokes(
        np.r_[a.px, b.px],
        np.r_[a.arc, b.arc],
        np.r_[a.half_width, b.half_width],
        np.r_[a.opacity, 0.5 * b.opacity],
        np.r_[a.pen, b.pen],
        np.r_[a.triangles, b.triangles + 4],
        2,
    )
    view = view_of(160, 100)
    drawn = on_gpu(both, pens, [], view)
    np.testing.assert_allclose(drawn, both.raster(pens, [], 160, 100), atol=0.01)
    crossed = drawn[(drawn[..., 0] > 0.3) & (drawn[..., 2] > 0.3)]
    assert len(crossed) > 4 and np.allclose(np.median(crossed, 0), (0.48, 0, 0.4, 0.88), atol=0.01)


def on_both(scene, chosen):
    """(200, 320, 4) of a Frame's strokes in a Style by the gpu, how far they are from the cpu's at each pixel, and the
    strokes."""
    frame = frame_of(scene, view_of(320, 200), chosen, visibility="exact")
    frame.ink()
    drawn = part("gpu.backend").Backend().draw(frame)
    return drawn, np.abs(drawn - core.CpuBackend().draw(frame)).max(axis=2), frame.strokes


def test_strokes_that_thin_and_fade_with_strength():
    """Lines of a hilly surface whose strength varies, by pens that use it in every way."""
    kinds = {"suggestive_contour": {}, "suggestive_highlight": {}, "ridge": {}}
    pictures = []
    for share in (0.0, 0.5, 1.0):
        pen = style.Pen(width=7.0, strength_width=share)
        chosen = style.Style(line_sets=(style.LineSet(kinds=kinds, least_length=0, pen=pen),))
        drawn, off, strokes = on_both(scene_of([(hills(), np.eye(4))]), chosen)
        # Where a wide stroke folds, either may give single pixels to the neighbouring triangle.
        assert off.mean() < 1e-4 and (off > 0.02).sum() <= 4 and off.max() < 0.1
        assert np.ptp(strokes.half_width) > 1 if share else np.ptp(strokes.half_width) == 0
        pictures.append(drawn)
    assert all(picture[..., 3].max() > 0.5 for picture in pictures)
    assert np.abs(pictures[0] - pictures[2]).max() > 0.3


def test_strokes_on_their_way_out_of_focus():
    """Colour, ink, width and opacity between two pens, by a focus that falls off over the image."""
    pen = style.Pen(color=(1, 0, 0), width=5)
    away = style.Pen(color=(0, 0, 1), width=2, opacity=0.5, texture="pencil")
    lines = style.LineSet(kinds={"crease": {}, "contour": {}}, least_length=0, pen=pen, pen_away=away)
    look = style.Focus(model="image", points=(style.FocusPlace(at=(100 / 320, 0.5, 0.0), near=0.1, far=0.75),))
    drawn, off, strokes = on_both(room(), style.Style(line_sets=(lines,), focus=look))
    assert np.ptp(strokes.mix) > 0.9 and np.ptp(strokes.half_width) > 1
    assert off.mean() < 1e-3 and (off > 0.02).mean() < 1e-3
    assert drawn[..., 0].max() > 0.9 and drawn[..., 2].max() > 0.3


def test_no_strokes():
    empty = np.zeros(0, np.float32)
    none = core.Strokes(
        empty.reshape(0, 2), empty.reshape(0, 4), empty, empty, np.zeros(0, np.uint32), np.zeros((0, 3), np.uint32)
    )
    assert not on_gpu(none, [PLAIN], [], view_of(8, 6)).any()
