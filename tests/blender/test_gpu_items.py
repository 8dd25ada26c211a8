# SPDX-License-Identifier: GPL-3.0-or-later
"""The item buffer: the gpu backend's samples equal the cpu's, and are close to exact ones where lines are sparse."""

import numpy as np
import pytest
from native_frames import ball, box, core, exact_samples, frame_of, moved, room, scene_of, view_of
from the_addon import part


def frame(scale, layers, view=None, scene=None):
    asked = {"visibility": "item_buffer", "depth_scale": scale, "layers": layers}
    return frame_of(scene or room(), view or view_of(480, 300), **asked)


LOW, HIGH = (1, 1), (3, 3)


@pytest.mark.gpu
@pytest.mark.parametrize("orthographic", [False, True])
@pytest.mark.parametrize("scale, layers", [LOW, (2, 2), HIGH])
def test_gpu_and_cpu_see_the_same(orthographic, scale, layers):
    seen = frame(scale, layers, view_of(480, 300, orthographic))
    on_gpu, on_cpu = (backend.visibility(seen) for backend in (part("gpu.backend").Backend(), core.CpuBackend()))
    assert on_gpu.dtype == np.float32 and on_gpu.shape == (seen.clipped.samples,)
    assert np.mean(on_gpu == on_cpu) > 0.995
    assert 0.2 < np.mean(on_cpu) < 0.9


@pytest.mark.gpu
@pytest.mark.parametrize("batch_samples", [1 << 22, 3000])
def test_the_same_in_tiles_and_batches(batch_samples):
    seen, backend = frame(2, 3), part("gpu.backend").Backend()
    whole = backend.visibility(seen)
    backend.most_side, backend.batch_samples = 300, batch_samples
    assert len(seen.layouts(300)) > 3
    assert np.mean(backend.visibility(seen) == whole) > 0.998


def agreement(scale, layers):
    seen = frame(scale, layers, view_of(960, 600))
    exact = exact_samples(room(), view_of(960, 600)) >= 0.5
    return np.mean((core.CpuBackend().visibility(seen) >= 0.5) == exact)


def test_more_layers_and_texels_come_nearer_to_exact():
    low, high = agreement(*LOW), agreement(*HIGH)
    assert 0.85 < low < high and high > 0.95


@pytest.mark.parametrize("scale, layers", [LOW, HIGH])
def test_a_ball_in_front_of_a_box_hides_it(scale, layers):
    """Edges of a box that are seen past a ball, away from where it begins to hide them."""
    scene = scene_of([(box((2, 0.8, 1.5)), moved((0, 1.5, 0))), (ball(), moved((0, -2, 0)))])
    view = view_of(480, 300, eye=(1, -8, 2))
    seen, exact = frame(scale, layers, view, scene), exact_samples(scene, view)
    value = core.CpuBackend().visibility(seen)
    edges = np.zeros(len(exact), bool)
    for start, count in zip(seen.clipped.sample_start, seen.clipped.sample_count, strict=True):
        edges[start : start + count] = count > 40  # of the box: the ball's segments are short
    assert edges.sum() > 400
    hidden, shown = (edges & (np.convolve(exact == v, np.ones(9), "same") == 9) for v in (0, 1))
    assert np.mean(value[hidden] < 0.5) > 0.98 and np.mean(value[shown] >= 0.5) > 0.98


@pytest.mark.gpu
@pytest.mark.parametrize("backend", [core.CpuBackend, lambda: part("gpu.backend").Backend()])
def test_lines_without_occluders_that_do_not_cross_are_all_seen(backend):
    scene = scene_of([(box(), moved((0, 0, 0)))], usage=[core.Usage.DRAW])
    seen = frame(*HIGH, view_of(480, 300), scene)
    assert np.mean(backend().visibility(seen) == 1) > 0.99


def test_nothing_to_see():
    seen = frame(*LOW, scene=scene_of([(box(), moved((0, 0, 900)))]))
    assert core.CpuBackend().visibility(seen).shape == (0,)
