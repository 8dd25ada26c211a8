# SPDX-License-Identifier: GPL-3.0-or-later
"""Line elision: the gpu backend's samples equal the cpu's, and crowded lines yield to lines of higher priority."""

import numpy as np
import pytest
from native_frames import box, core, moved, pipeline, room, scene_of, style, view_of
from the_addon import part


def begun(backend, half_width, scene=None, *, orthographic=False, of_hidden=False, cut=0.0):
    """A Frame of pen_and_ink's lines, each of which wants so many pixels to both of its sides; None: from half a pixel
    in the middle of the picture to 12 px at its edge."""
    near, far = (0.5, 12.0) if half_width is None else (half_width, half_width)
    sets = []
    for line_set in style.load("pen_and_ink").line_sets:
        pen, away = (line_set.pen.replace(spacing=2 * half) for half in (near, far))
        parts = (style.Hidden(pen=pen),) if of_hidden else ()
        sets.append(line_set.replace(least_length=0.0, pen=pen, pen_away=away, hidden=parts))
    look = style.Focus(model="image", points=(style.FocusPlace(near=0.0, far=0.8),))
    chosen = style.Style(line_sets=tuple(sets), elision=style.Elision(enabled=True, cut=cut), focus=look)
    view, asked = view_of(480, 300, orthographic), pipeline.options(sample_step=1.0)
    return pipeline.frame(scene or room(), view, chosen, backend, asked)


def left(*given, **options):
    """(samples,) what elision leaves of a Frame's lines."""
    frame = begun(*given, **options)
    frame.thin()
    return frame.shown


def gpu_backend():
    return part("gpu.backend").Backend()  # imported late: not every Blender that runs the other tests has a GPU


@pytest.mark.gpu
@pytest.mark.parametrize("orthographic", [False, True])
@pytest.mark.parametrize("half_width", [0.5, 3.0, 20.0, None])
def test_gpu_and_cpu_leave_the_same(orthographic, half_width):
    on_gpu, on_cpu = (left(b, half_width, orthographic=orthographic) for b in (gpu_backend(), core.CpuBackend()))
    assert on_gpu.dtype == np.float32 and on_gpu.shape == on_cpu.shape
    assert np.mean(np.abs(on_gpu - on_cpu) <= 0.02) > 0.995
    assert on_cpu.min() >= 0 and on_cpu.max() == 1
    if half_width != 0.5:
        assert np.mean(on_cpu < 0.9) > 0.05


@pytest.mark.gpu
@pytest.mark.parametrize("batch_samples", [1 << 22, 4096])
def test_the_same_in_tiles_and_batches(batch_samples):
    backend = gpu_backend()
    whole = left(backend, 3.0)
    backend.most_side, backend.batch_samples = 200, batch_samples
    assert np.mean(np.abs(left(backend, 3.0) - whole) <= 0.001) > 0.999


@pytest.mark.gpu
def test_the_same_where_hidden_lines_are_drawn_too():
    on_gpu, on_cpu = (left(b, 4.0, of_hidden=True) for b in (gpu_backend(), core.CpuBackend()))
    assert np.mean(np.abs(on_gpu - on_cpu) <= 0.02) > 0.995
    assert np.mean(on_cpu < 0.9) > 0.05


@pytest.mark.gpu
@pytest.mark.parametrize("backend", [core.CpuBackend, gpu_backend])
def test_nothing_to_elide(backend):
    frame = begun(backend(), 3.0, scene_of([(box(), moved((0, 0, 900)))]))
    frame.ink()
    assert frame.clipped.samples == len(frame.strokes) == 0


def test_wider_bands_leave_less_and_cut_leaves_nothing_faint():
    stays = [left(core.CpuBackend(), half_width).mean() for half_width in (0.0, 2.0, 5.0, 12.0)]
    assert stays == sorted(stays, reverse=True) and stays[0] > 0.95 and stays[-1] < 0.96
    cut = left(core.CpuBackend(), 5.0, cut=0.5)
    assert np.all((cut == 0) | (cut >= 0.5)) and 0 < np.mean(cut == 0) < 1


def test_a_cancelled_call_stops():
    frame = begun(core.CpuBackend(), 3.0)
    frame.filter()
    frame.cancel.cancel()
    with pytest.raises(core.Cancelled):
        frame.thin()
