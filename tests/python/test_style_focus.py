# SPDX-License-Identifier: GPL-3.0-or-later
"""Shipped styles: what they make of focus reads at a glance, and how deep they look behind surfaces."""

import numpy as np
import pytest
from native_core import Mesh, box, core, scene

from addon import pipeline, style

SIZE = (960, 540)  # two reference pixels are one
OF_FOCUS = ("blueprint", "brush", "charcoal", "pen_and_ink", "pencil", "technical", "watercolor")


def camera(half_height):
    """From above, orthographic, so many units high."""
    clip = np.diag([SIZE[1] / SIZE[0] / half_height, 1 / half_height, -2 / 100, 1])
    clip[2, 3] = -1
    world_to_view = np.eye(4)
    world_to_view[2, 3] = -20
    return core.View(world_to_view, clip, *SIZE, True, 0.0, 100.0, reference_scale=0.5, frame=(0, 0, *SIZE))


def ink(placed, seen, chosen, visibility="exact"):
    """(H, W): how far a picture is from the tone of its paper, as a share of the way to black or white; the least, the
    relief of the paper, left out."""
    options = pipeline.options(visibility=visibility)
    picture = pipeline.draw(placed, seen, chosen, core.CpuBackend(), options).combined[..., :3].mean(-1)
    tone = np.median(picture)
    away = np.abs(picture - tone) / max(tone, 1 - tone)
    return np.where(away < 0.08, 0, away)


def comb(x):
    """A block of ten thin boards side by side: many lines, near each other."""
    boards = [box((x - 3 + 0.6 * i, -3, 0), (x - 2.6 + 0.6 * i, 3, 1)) for i in range(10)]
    faces = [tuple(8 * i + v for v in face) for i, board in enumerate(boards) for face in board.polygons]
    return Mesh("comb", np.concatenate([board.positions for board in boards]), faces)


@pytest.mark.parametrize("name", OF_FOCUS)
def test_focus_reads_at_a_glance(name):
    """Of two equal things, that in focus has four times the ink, and its darkest strokes are 2.5 times as dark."""
    focus = style.Focus(model="image", points=(style.FocusPlace(at=(0.25, 0.5, 0), near=0.3, far=0.6),))
    chosen = style.load(name).replace(focus=focus, color=style.Color())
    picture = ink(scene([comb(-5).surface(), comb(5).surface()]), camera(5), chosen)
    inside, outside = picture[:, : SIZE[0] // 2], picture[:, SIZE[0] // 2 :]
    darkest = [np.quantile(half[half > 0], 0.9) for half in (inside, outside)]
    assert darkest[0] > (0.85 if name == "charcoal" else 0.5) and outside.sum() > 100, "both are drawn"
    assert inside.sum() > 4 * outside.sum()
    assert darkest[0] > 2.5 * darkest[1]


def card(name, x, z, half):
    corners = [(x - half, -half, z), (x + half, -half, z), (x + half, half, z), (x - half, half, z)]
    return Mesh(name, np.array(corners, np.float32), [(0, 1, 2, 3)]).surface()


@pytest.mark.parametrize("visibility", ["exact", "atlas", "item_buffer"])
@pytest.mark.parametrize("name", ["technical", "blueprint"])
def test_what_three_surfaces_hide_is_left_out(name, visibility):
    """Three sheets that fill the picture, one above the other, and a small card below each, from left to right."""
    sheets = [card("sheet", 0, -2 * level, 99) for level in range(3)]
    cards = [card("card", 6 * level - 6, -2 * level - 1, 1.5) for level in range(3)]
    picture = ink(scene(sheets + cards), camera(5), style.load(name), visibility)
    drawn = [picture[:, 320 * i : 320 * i + 320].max() > 0.2 for i in range(3)]
    assert drawn == [True, True, False]
