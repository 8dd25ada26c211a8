# SPDX-License-Identifier: GPL-3.0-or-later
"""The spine test: the gpu backend's picture equals the cpu's, and both equal the segment atlas's except at the ends of
visible runs."""

import numpy as np
import pytest
from native_frames import box, core, frame_of, moved, pipeline, room, scene_of, style, view_of
from the_addon import part


def bare():
    """pen_and_ink, with the ends of lines where visibility has them."""
    base = style.load("pen_and_ink")
    sets = tuple(s.replace(halo=0.0, overshoot=0.0, overshoot_away=None) for s in base.line_sets)
    return base.replace(line_sets=sets, elision=base.elision.replace(enabled=False))


def picture(scene, view, backend, visibility="spine", probes=9):
    asked = pipeline.options(visibility=visibility, probes=probes, sample_step=1.0)
    return pipeline.draw(scene, view, bare(), backend, asked).lines


def off(a, b):
    return np.abs(a[..., 3] - b[..., 3])


@pytest.mark.gpu
@pytest.mark.parametrize("orthographic", [False, True])
@pytest.mark.parametrize("probes", [1, 9])
def test_gpu_and_cpu_draw_the_same(orthographic, probes):
    backends = part("gpu.backend").Backend(), core.CpuBackend()
    drawn, reference = (picture(room(), view_of(480, 300, orthographic), b, probes=probes) for b in backends)
    assert drawn.shape == (300, 480, 4) and reference[..., 3].mean() > 0.01
    # Where a line touches a surface, one probe more or less sees it.
    assert np.mean(off(drawn, reference) > 0.02) < 1e-3 and off(drawn, reference).mean() < 2e-4


@pytest.mark.gpu
@pytest.mark.parametrize("side", [200, 390])
@pytest.mark.parametrize("make", [lambda: part("gpu.backend").Backend(), core.CpuBackend])
def test_the_same_in_tiles(make, side):
    backend, seen = make(), view_of()
    whole = picture(room(), seen, backend, probes=4)
    backend.most_side = side
    assert len(frame_of(room(), seen, visibility="spine").layouts(side, 10)) > 3
    assert np.mean(off(picture(room(), seen, backend, probes=4), whole) > 0.01) < 5e-4


@pytest.mark.parametrize("orthographic", [False, True])
def test_it_agrees_with_the_atlas(orthographic):
    seen = view_of(480, 300, orthographic)
    spine, atlas = (picture(room(), seen, core.CpuBackend(), method) for method in ("spine", "atlas"))
    ink = atlas[..., 3].sum()
    assert abs(spine[..., 3].sum() / ink - 1) < 0.02
    assert off(spine, atlas).sum() / ink < 0.06


def test_what_lies_behind_is_drawn_nowhere():
    wall = box((3, 0.1, 3))
    scene = scene_of([(box(), moved((0, 0, 0))), (wall, moved((0, -2, 0)))])
    view = view_of(eye=(0, -8, 0.001))
    alone = scene_of([(wall, moved((0, -2, 0)))])
    both, wall_only = (picture(s, view, core.CpuBackend()) for s in (scene, alone))
    assert wall_only[..., 3].max() > 0.9 and off(both, wall_only).max() < 0.01


def test_without_occluders_it_is_every_line_in_full():
    scene = scene_of([(box(), moved((0, 0, 0)))], usage=[core.Usage.DRAW])
    frame = frame_of(scene, view_of(), bare(), visibility="spine")
    frame.ink()
    seen = core.CpuBackend().draw(frame)
    assert seen[..., 3].max() > 0.9
    np.testing.assert_array_equal(seen, frame.strokes.raster(frame.pens, frame.textures, 320, 200))
