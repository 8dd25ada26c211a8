# SPDX-License-Identifier: GPL-3.0-or-later
"""The spine test: the gpu's picture is the cpu's, and both are the segment atlas's but for the ends of what is seen."""

import numpy as np
import pytest
from native_frames import box, cpu, frame_of, moved, room, scene_of, style, view_of
from the_addon import part

Textures, METHODS = part("textures").Textures, part("visibility").METHODS


def strokes_of(frame, method, backend, chosen):
    textures = Textures(chosen)
    pens = cpu.pens_of(chosen, textures, 1.0)
    return cpu.shape(frame, METHODS[method].runs(frame, backend, None)[0], chosen, pens), pens, textures


def picture(frame, method, backend, name="pen_and_ink"):
    return METHODS[method].draw(frame, backend, *strokes_of(frame, method, backend, style.load(name)))


def off(a, b):
    return np.abs(a[..., 3] - b[..., 3])


@pytest.mark.gpu
@pytest.mark.parametrize("orthographic", [False, True])
@pytest.mark.parametrize("probes", [1, 9])
def test_gpu_and_cpu_draw_the_same(orthographic, probes):
    frame = frame_of(room(), view_of(480, 300, orthographic), 2, probes)
    drawn, reference = (picture(frame, "spine", backend) for backend in (part("backend.gpu").Backend(), cpu.Backend()))
    assert drawn.shape == (300, 480, 4) and reference[..., 3].mean() > 0.01
    # Where a line touches a surface, one probe more or less sees it.
    assert np.mean(off(drawn, reference) > 0.02) < 1e-3 and off(drawn, reference).mean() < 2e-4


@pytest.mark.gpu
@pytest.mark.parametrize("side", [200, 390])
@pytest.mark.parametrize("make", [lambda: part("backend.gpu").Backend(), cpu.Backend])
def test_the_same_in_tiles(make, side):
    frame, backend = frame_of(room(), view_of(), 2, 4), make()
    whole = picture(frame, "spine", backend)
    backend.most_side = side
    assert len(backend.layouts(frame, 10)) > 3
    assert np.mean(off(picture(frame, "spine", backend), whole) > 0.01) < 5e-4


@pytest.mark.parametrize("orthographic", [False, True])
def test_it_agrees_with_the_atlas(orthographic):
    frame, backend = frame_of(room(), view_of(480, 300, orthographic), 2, 9), cpu.Backend()
    spine, atlas = (picture(frame, method, backend) for method in ("spine", "atlas"))
    ink = atlas[..., 3].sum()
    assert abs(spine[..., 3].sum() / ink - 1) < 0.02
    assert off(spine, atlas).sum() / ink < 0.06


def test_what_lies_behind_is_drawn_nowhere():
    wall = box((3, 0.1, 3))
    scene = scene_of([(box(), moved((0, 0, 0))), (wall, moved((0, -2, 0)))])
    view = view_of(eye=(0, -8, 0.001))
    alone = scene_of([(wall, moved((0, -2, 0)))])
    both, wall_only = (picture(frame_of(s, view, 2, 9), "spine", cpu.Backend()) for s in (scene, alone))
    assert wall_only[..., 3].max() > 0.9 and off(both, wall_only).max() < 0.01


def test_without_occluders_it_is_every_line_in_full():
    frame = frame_of(scene_of([(box(), moved((0, 0, 0)))], usage=[part("native").load().DRAW]), view_of(), 2, 9)
    strokes, pens, textures = strokes_of(frame, "spine", cpu.Backend(), style.load("pen_and_ink"))
    seen = cpu.Backend().draw_seen(frame, strokes, pens, textures)
    np.testing.assert_array_equal(seen, cpu.Backend().draw(strokes, pens, textures, frame.view))
