# SPDX-License-Identifier: GPL-3.0-or-later
"""The gpu backend's depth and visibility equal those of the cpu backend."""

import numpy as np
import pytest
from native_frames import box, core, exact_samples, frame_of, moved, room, scene_of, view_of
from the_addon import part

pytestmark = pytest.mark.gpu

NEITHER = 0xFFFFFFFF


def gpu_backend():
    return part("gpu.backend").Backend()  # imported late: not every Blender that runs the other tests has a GPU


def both(frame):
    return gpu_backend().visibility(frame), core.CpuBackend().visibility(frame)


@pytest.mark.parametrize("orthographic", [False, True])
@pytest.mark.parametrize("scale, section", [(1, None), (2, None), (2, (0.2, -0.4, 0.9, -0.1))])
def test_depth(orthographic, scale, section):
    scene, view = room(section), view_of(orthographic=orthographic)
    layout = core.DepthLayout(view, scale)
    texels, target = layout.texels(scene, view), gpu_backend().draw_depth(scene, view, layout)
    drawn, edges = target.read(4), target.read(2, slot=1)
    assert drawn.shape[:2] == texels.shape
    facets = np.where(texels["facet"] == NEITHER, -1, texels["facet"].astype(np.int64))
    same = facets == drawn[..., 3]
    assert np.mean(same) > 0.9995
    seen = same & (facets >= 0)
    assert 0.2 < np.mean(seen) < 1
    np.testing.assert_allclose(drawn[seen, 0], texels["depth"][seen], rtol=1e-4)
    for slot, slope in ((1, "ddx"), (2, "ddy")):
        error = np.abs(drawn[seen, slot] - texels[slope][seen]) / texels["depth"][seen]
        assert np.quantile(error, 0.999) < 1e-5
    on_cpu = np.stack((texels["edges"]["x"], texels["edges"]["y"]), axis=-1)
    for off in ((0.9, 0.1), (-0.4, 0.6), (-0.8, -0.7), (0.3, -0.5)):
        reach, truth = edges_reach(edges[seen], off), edges_reach(on_cpu[seen], off)
        clear = np.abs(truth) > 0.03  # directions are rounded to 1/64, corners to 1/256 texel
        assert np.mean((reach >= 0) == (truth >= 0)) > 0.98
        # Of a triangle that is cut, the CPU packs the edges of the part around a texel, the GPU all three.
        assert np.mean((reach >= 0)[clear] == (truth >= 0)[clear]) > (0.9995 if section is None else 0.999)
        assert 0.5 < np.mean(reach >= 0) < 0.999


def edges_reach(packed, off):
    """(n,) how far inside their triangles places `off` texels beside the centers are, below 0 outside;
    native/fovea/visibility/triangle_edges.h."""
    a, b = packed.astype(np.int64).T
    codes = np.stack((a // 256, b // 256, a % 256 * 256 + b % 256))
    turn = codes // 256 / 64
    x, y = np.abs(turn - 2) - 1, np.where(turn < 2, 1 - np.abs(turn - 1), np.abs(turn - 3) - 1)
    return (codes % 256 / 255 + x * off[0] + y * off[1]).min(axis=0)


@pytest.mark.parametrize("orthographic", [False, True])
@pytest.mark.parametrize("scale, probes", [(1, 1), (2, 1), (1, 4), (2, 4), (2, 9), (2, 16), (3, 16)])
def test_visibility(orthographic, scale, probes):
    frame = frame_of(room(), view_of(orthographic=orthographic), depth_scale=scale, probes=probes)
    on_gpu, on_cpu = both(frame)
    assert on_gpu.dtype == np.float32 and on_gpu.shape == (frame.clipped.samples,)
    assert np.mean(on_gpu == on_cpu) > 0.999
    assert 0.2 < np.mean(on_gpu) < 0.9


@pytest.mark.parametrize("orthographic", [False, True])
def test_visibility_behind_a_section_plane(orthographic):
    scene, view = room((0.2, -0.4, 0.9, -0.1)), view_of(orthographic=orthographic)
    frame = frame_of(scene, view)
    on_gpu, on_cpu = both(frame)
    assert np.mean(on_gpu == on_cpu) > 0.995
    assert np.mean((on_gpu >= 0.5) == (exact_samples(scene, view) >= 0.5)) > 0.95


def test_agrees_with_exact_visibility():
    frame = frame_of(room(), view_of(960, 600))
    exact = exact_samples(room(), view_of(960, 600))
    assert np.mean((gpu_backend().visibility(frame) >= 0.5) == (exact >= 0.5)) > 0.97


def test_paths_longer_than_a_row_and_many_batches():
    frame = frame_of(room(), view_of(1000, 600), sample_step=0.25)
    counts = np.add.reduceat(frame.clipped.sample_count, frame.clipped.offsets[:-1])
    assert counts.max() > 2048
    backend = gpu_backend()
    whole = backend.visibility(frame)
    backend.batch_samples = 3000
    assert len(core.AtlasBatch.of(frame.clipped, 3000)) > 20
    np.testing.assert_array_equal(backend.visibility(frame), whole)
    assert np.mean(whole == core.CpuBackend().visibility(frame)) > 0.999


def test_nothing_hides_in_front_of_the_near_plane():
    scene = scene_of([(box(), moved((0, 0, 0))), (box((0.5, 0.5, 0.5)), moved((4.4, -5.3, 2.2), scale=0.3))])
    far, near = (frame_of(scene, view_of(near=near)) for near in (1.5, 0.1))
    cut, whole = both(far), both(near)
    assert np.mean(cut[0] == cut[1]) > 0.999 and np.mean(whole[0] == whole[1]) > 0.999
    assert np.mean(cut[0]) > np.mean(whole[0])


@pytest.mark.parametrize("orthographic", [False, True])
@pytest.mark.parametrize("side", [200, 390])
def test_pictures_larger_than_textures_are_looked_at_in_tiles(orthographic, side):
    """A texel's plane is the same whichever tile shows it, but for the rounding of corners to 1/256 texel."""
    frame, backend = frame_of(room(), view_of(orthographic=orthographic), probes=4), gpu_backend()
    whole = backend.visibility(frame)
    backend.most_side = side
    layouts = frame.layouts(side)
    assert len(layouts) > 3 and max(max(layout.width, layout.height) for layout in layouts) <= side
    tiled = backend.visibility(frame)
    assert np.mean(tiled == whole) > 0.9995 and np.abs(tiled - whole).mean() < 1e-4
    assert 0.2 < np.mean(tiled) < 0.9


def test_the_cpu_looks_in_tiles_too():
    frames = [frame_of(room(), view_of(), visibility=method, probes=4) for method in ("atlas", "item_buffer")]
    backend = core.CpuBackend()
    looks, lines = map(backend.visibility, frames)
    backend.most_side = 200
    assert len(frames[0].layouts(200)) > 3
    assert np.mean(backend.visibility(frames[0]) == looks) > 0.9999
    assert np.mean(backend.visibility(frames[1]) == lines) > 0.9995


@pytest.mark.parametrize("make", [gpu_backend, core.CpuBackend])
def test_tiles_need_room(make):
    backend = make()
    backend.most_side = 30
    with pytest.raises(ValueError, match="too few texels"):
        backend.visibility(frame_of(room(), view_of()))


def test_lines_without_occluders():
    frame = frame_of(scene_of([(box(), moved((0, 0, 0)))], usage=[core.Usage.DRAW]), view_of())
    assert frame.clipped.samples > 0 and np.all(gpu_backend().visibility(frame) == 1)


def test_nothing_to_see():
    frame = frame_of(scene_of([(box(), moved((0, 0, 900)))]), view_of())
    assert gpu_backend().visibility(frame).shape == (0,)


def test_surfaces_stay_on_the_gpu_until_they_are_gone():
    backend, crate = gpu_backend(), box()
    layout = core.DepthLayout(view_of(), 1)
    two = scene_of([(crate, moved((0, 0, 0))), (crate, moved((1, 2, 0)))])
    backend.draw_depth(two, view_of(), layout)
    (batch,) = backend.surfaces.values()
    backend.draw_depth(two, view_of(eye=(3, 3, 3)), layout)
    assert list(backend.surfaces.values()) == [batch]
    crate.set_positions(crate.positions * 2)
    backend.draw_depth(two, view_of(), layout)
    (other,) = backend.surfaces.values()
    assert other is not batch
    backend.draw_depth(scene_of([(box(), moved((0, 0, 0)))]), view_of(), layout)
    assert other not in backend.surfaces.values()


def test_state_is_left_as_it_was():
    import gpu

    before = gpu.state.depth_test_get(), gpu.state.depth_mask_get(), gpu.state.blend_get()
    gpu_backend().visibility(frame_of(room(), view_of()))
    assert (gpu.state.depth_test_get(), gpu.state.depth_mask_get(), gpu.state.blend_get()) == before
