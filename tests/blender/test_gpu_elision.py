# SPDX-License-Identifier: GPL-3.0-or-later
"""Line elision: the gpu's samples are the cpu's, and lines that crowd give way to more important ones."""

import numpy as np
import pytest
from native_frames import box, core, cpu, exact_runs, frame_of, moved, room, scene_of, view_of
from the_addon import part


def seen(orthographic=False, size=(480, 300)):
    """A Frame, its visible Runs and their ranks."""
    frame = frame_of(room(), view_of(*size, orthographic))
    runs = exact_runs(frame)
    return frame, runs, ranks_of(frame, runs)


def ranks_of(frame, runs):
    priority = core.path_priorities(frame.paths, frame.scene, frame.view)
    return core.rank_runs(frame.clipped, runs, priority, frame.paths.ids)


def left(backend, frame, runs, ranks, half_width, **options):
    """(samples,) what elision leaves of Runs."""
    elision = core.Elision(frame.clipped, runs, ranks, half_width, 12.0)
    return elision.opacities(frame.clipped, backend.elide(frame, elision), **options)


def widths(frame, half_width):
    """One width everywhere, or one that grows from left to right."""
    if half_width is not None:
        return np.full(frame.clipped.samples, half_width, np.float32)
    return np.linspace(0.5, 12, frame.clipped.samples, dtype=np.float32)


@pytest.mark.gpu
@pytest.mark.parametrize("orthographic", [False, True])
@pytest.mark.parametrize("half_width", [0.5, 3.0, 20.0, None])
def test_gpu_and_cpu_leave_the_same(orthographic, half_width):
    frame, runs, ranks = seen(orthographic)
    half = widths(frame, half_width)
    on_gpu, on_cpu = (left(b, frame, runs, ranks, half) for b in (part("backend.gpu").Backend(), cpu.Backend()))
    assert on_gpu.dtype == np.float32 and on_gpu.shape == (frame.clipped.samples,)
    assert np.mean(np.abs(on_gpu - on_cpu) <= 0.02) > 0.995
    assert on_cpu.min() >= 0 and on_cpu.max() == 1
    if half_width != 0.5:
        assert np.mean(on_cpu < 0.9) > 0.05


@pytest.mark.gpu
@pytest.mark.parametrize("batch_samples", [1 << 22, 4096])
def test_the_same_in_tiles_and_batches(batch_samples):
    frame, runs, ranks = seen()
    half, backend = widths(frame, 3.0), part("backend.gpu").Backend()
    whole = left(backend, frame, runs, ranks, half)
    backend.most_side, backend.batch_samples = 200, batch_samples
    assert np.mean(np.abs(left(backend, frame, runs, ranks, half) - whole) <= 0.001) > 0.999


@pytest.mark.gpu
def test_hidden_runs_give_way_on_both():
    frame, visible, _ = seen()
    runs = core.with_hidden(frame.clipped, visible, frame.paths)
    ranks, half = ranks_of(frame, runs), widths(frame, 4.0)
    hidden = runs.invisibility > 0
    assert ranks[hidden].max() < ranks[~hidden].min()
    on_gpu, on_cpu = (left(b, frame, runs, ranks, half) for b in (part("backend.gpu").Backend(), cpu.Backend()))
    assert np.mean(np.abs(on_gpu - on_cpu) <= 0.02) > 0.995


@pytest.mark.gpu
@pytest.mark.parametrize("backend", [cpu.Backend, lambda: part("backend.gpu").Backend()])
def test_nothing_to_elide(backend):
    frame = frame_of(scene_of([(box(), moved((0, 0, 900)))]), view_of())
    runs = exact_runs(frame)
    assert left(backend(), frame, runs, ranks_of(frame, runs), widths(frame, 3.0)).shape == (0,)


def test_what_no_runs_lie_on_is_not_asked_how_wide_it_wants_to_be():
    frame, runs, ranks = seen()
    points = np.diff(frame.clipped.offsets.astype(int))
    piece = np.repeat(np.repeat(np.arange(len(points)), points), frame.clipped.sample_count)
    elsewhere = ~np.isin(piece, runs.piece)
    assert 0 < elsewhere.sum() < frame.clipped.samples
    half = widths(frame, None)
    found, the_same = (left(cpu.Backend(), frame, runs, ranks, each) for each in (half, np.where(elsewhere, 0, half)))
    np.testing.assert_array_equal(found, the_same)
    assert np.all(found[elsewhere] == 1)


def test_wider_bands_leave_less_and_cut_leaves_nothing_faint():
    frame, runs, ranks = seen()
    stays = [left(cpu.Backend(), frame, runs, ranks, widths(frame, w)).mean() for w in (0.0, 2.0, 5.0, 12.0)]
    assert stays == sorted(stays, reverse=True) and stays[0] > 0.95 and stays[-1] < 0.9
    cut = left(cpu.Backend(), frame, runs, ranks, widths(frame, 5.0), cut=0.5)
    assert np.all((cut == 0) | (cut >= 0.5)) and 0 < np.mean(cut == 0) < 1


def test_what_the_caller_says_of_objects_counts():
    frame, _, _ = seen()
    objects = np.zeros(41, np.float32)
    objects[7] = 1
    weights = core.PriorityWeights(object=5)
    priority = core.path_priorities(frame.paths, frame.scene, frame.view, weights, objects)
    placement = np.asarray(frame.paths.placement)
    assert priority[placement == 7].min() > priority[placement != 7].max()


def test_a_cancelled_call_stops():
    frame, runs, ranks = seen()
    frame.cancel.cancel()
    with pytest.raises(core.Cancelled):
        left(cpu.Backend(), frame, runs, ranks, widths(frame, 3.0))
