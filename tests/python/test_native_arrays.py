# SPDX-License-Identifier: GPL-3.0-or-later
"""What crosses the border to the native module: views without copies, nothing kept, errors by name."""

import gc
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from native_core import box, core, draw, members, scene, sphere, view

CORNER = ((4, -5, 3), (0, 0, 0))


def test_arrays_are_read_only_views():
    surface = box().surface()
    tracer = core.Tracer(scene([surface]), view(*CORNER))
    paths = core.extract_paths(tracer, [({"crease": {}}, 60.0)])
    clipped = core.project(paths, tracer)
    runs = core.exact_visibility(clipped, paths, tracer)
    views = [
        *members("surface", surface, "positions triangles triangle_facet edges").values(),
        *members("paths", paths, "offsets points_obj place edge_t kinds strength closed ids").values(),
        *members("clipped", clipped, "offsets px depth position_view arc_px source facet0").values(),
        *members("runs", runs, "piece start_px end_px").values(),
    ]
    for array in views:
        assert array.size and not array.flags.writeable
        with pytest.raises(ValueError):
            array[...] = 0
    for owner, name in ((surface, "positions"), (paths, "points_obj"), (clipped, "px"), (runs, "start_px")):
        assert np.shares_memory(getattr(owner, name), getattr(owner, name)), "the same memory, not a copy"


def test_views_keep_their_owner():
    surface = sphere(40).surface()
    expected = surface.triangles.copy()
    triangles = surface.triangles
    del surface
    gc.collect()
    others = [sphere(40).surface() for _ in range(3)]  # would reuse the memory
    assert np.array_equal(triangles, expected) and others


def test_borrowed_arrays_are_not_kept():
    mesh = box().arrays()
    before = {name: sys.getrefcount(array) for name, array in mesh.items()}
    surface = core.Surface("box", **mesh)
    assert {name: sys.getrefcount(array) for name, array in mesh.items()} == before
    mesh["positions"][:] = 7.0
    mesh["corner_verts"][:] = 0
    assert surface.positions.max() == 1.0
    surface.set_positions(mesh["positions"])
    assert surface.positions.max() == 7.0 and surface.report["degenerate_polygons"] == 6


def test_other_types_and_layouts_are_converted():
    plain = box().arrays()
    wide = {name: array.astype(np.float64 if array.dtype == np.float32 else np.int64) for name, array in plain.items()}
    other = {name: np.asfortranarray(array) for name, array in wide.items()}
    assert np.array_equal(core.Surface("box", **other).triangles, core.Surface("box", **plain).triangles)
    read_only = {name: array.copy() for name, array in plain.items()}
    for array in read_only.values():
        array.flags.writeable = False
    assert core.Surface("box", **read_only).polygon_count == 6


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("positions", np.zeros((8, 2), np.float32)),
        ("positions", np.zeros(24, np.float32)),
        ("positions", np.zeros((0, 3), np.float32)),
        ("edge_verts", np.zeros((12, 3), np.int32)),
        ("edge_verts", np.full((12, 2), 8, np.int32)),
        ("corner_verts", np.full(24, -1, np.int32)),
        ("corner_verts", np.full(24, 8, np.int32)),
        ("corner_verts", np.zeros((24, 1), np.int32)),
        ("corner_edges", np.full(24, 12, np.int32)),
        ("corner_edges", np.zeros(23, np.int32)),
        ("polygon_offsets", np.array([0, 4], np.int32)),
        ("polygon_offsets", np.array([0, 99, 24], np.int32)),
        ("polygon_offsets", np.array([-4, 24], np.int32)),
        ("material", np.zeros(5, np.int32)),
        ("occluding", np.ones(7, np.uint8)),
        ("sharp_edges", np.ones(11, np.uint8)),
        ("seams", np.ones(1, np.uint8)),
        ("edge_marks", np.ones((12, 1), np.uint8)),
        ("ngon_triangles", np.array([[0, 1, 2]], np.int32)),
        ("ngon_polygon", np.array([0], np.int32)),
    ],
)
def test_arrays_that_do_not_fit_are_value_errors(name, value):
    with pytest.raises(ValueError, match=f"box|{name}"):
        core.Surface("box", **box().arrays() | {name: value})


def test_polygon_edges_refuses_broken_offsets():
    verts = np.arange(4, dtype=np.int32)
    for offsets in ([0, 1000000, 4], [-1000000, 4], [0, 5]):
        with pytest.raises(ValueError, match="polygon_offsets"):
            core.polygon_edges(np.array(offsets, np.int32), verts)


def test_scenes_refuse_what_does_not_fit():
    surface = box().surface()
    good = [[surface], np.zeros(1, np.int32), np.eye(4)[None], np.zeros(1, np.uint64), np.ones(1, np.uint8)]
    assert len(core.Scene(*good)) == 1
    bad = [
        (0, [None]),
        (0, []),
        (1, np.array([1], np.int32)),
        (1, np.array([-1], np.int32)),
        (1, np.zeros(2, np.int32)),
        (2, np.eye(4)),
        (2, np.zeros((1, 3, 4))),
        (3, np.zeros(2, np.uint64)),
        (4, np.zeros(0, np.uint8)),
    ]
    for index, value in bad:
        with pytest.raises((ValueError, TypeError)):
            core.Scene(*good[:index], value, *good[index + 1 :])


def test_views_refuse_what_is_no_camera():
    eye = np.eye(4)
    for bad in [
        (eye[:3], eye, 10, 10, False, 0.1, 10.0),
        (eye, eye[:, :3], 10, 10, False, 0.1, 10.0),
        (eye, eye, 0, 10, False, 0.1, 10.0),
        (eye, eye, 10, -1, False, 0.1, 10.0),
        (eye, eye, 10, 10, False, 0.0, 10.0),
        (eye, eye, 10, 10, False, np.nan, 10.0),
        (eye, eye, 10, 10, False, 1.0, 1.0),
    ]:
        with pytest.raises(ValueError):
            core.View(*bad)


def test_line_sets_refuse_unknown_names():
    tracer = core.Tracer(scene([box().surface()]), view(*CORNER))
    with pytest.raises(ValueError, match="outline"):
        core.extract_paths(tracer, [({"outline": {}}, 60.0)])
    with pytest.raises(ValueError, match="angel"):
        core.extract_paths(tracer, [({"crease": {"angel": 3.0}}, 60.0)])
    paths = core.extract_paths(tracer, [({"crease": {}}, 60.0)])
    with pytest.raises(ValueError, match="sample_step"):
        core.project(paths, tracer, 0.0)


def test_a_scene_outlives_its_names():
    surface = box().surface()
    tracer = core.Tracer(scene([surface]), view(*CORNER))
    del surface
    gc.collect()
    paths = core.extract_paths(tracer, [({"crease": {}}, 60.0)])
    assert len(paths) == 12


def test_a_box_has_nine_visible_edges():
    arrays = draw(scene([box().surface()]), view(*CORNER, size=(640, 480)), [({"crease": {}}, 30.0)], (640, 480))
    assert len(arrays["clipped.path"]) == 12
    assert len(arrays["runs.piece"]) == 9
    assert arrays["image"].shape == (480, 640, 4) and 0.79 < arrays["image"][..., 3].max() <= 1.0
    assert arrays["depth_image"].min() == pytest.approx(np.sqrt(50) - np.sqrt(3), abs=0.1)


def test_calls_can_be_cancelled():
    tracer = core.Tracer(scene([box().surface()]), view(*CORNER))
    cancel = core.Cancel()
    cancel.cancel()
    with pytest.raises(core.Cancelled):
        core.extract_paths(tracer, [({"crease": {}}, 60.0)], cancel)


HASH = """
import os, sys
if sys.argv[1] == "one":
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
import numpy as np
from native_core import *
place = lambda x, y: np.array([[1, 0, 0, x], [0, 1, 0.2, y], [0, 0, 1, 0.3 * x], [0, 0, 0, 1.0]])
ball = sphere(60).surface()
placed = scene([ball] * 9, [place(i % 3 - 1, i // 3 - 1) for i in range(9)])
print(digest(draw(placed, view((4, -5, 3), (0, 0, 0), size=(640, 480)), size=(640, 480))))
"""


@pytest.mark.skipif(len(os.sched_getaffinity(0)) < 2, reason="one processor only")
def test_bytes_do_not_depend_on_the_number_of_threads():
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(Path(__file__).parent), *sys.path])}

    def bytes_with(threads):
        return subprocess.check_output([sys.executable, "-c", HASH, threads], env=environment, text=True)

    assert bytes_with("one") == bytes_with("all") == bytes_with("all")


@pytest.fixture
def stages():
    """Stages of a scene with much in it, and of one with little."""

    def run(surface):
        tracer = core.Tracer(scene([surface]), view(*CORNER))
        paths = core.extract_paths(tracer, [({"crease": {"angle": 0.0}}, 10.0)])
        clipped = core.project(paths, tracer)
        return surface, tracer, paths, clipped, core.exact_visibility(clipped, paths, tracer)

    return run(sphere(16).surface()), run(box().surface())


def test_stages_of_different_scenes_are_not_mixed(stages):
    (_, _, paths, clipped, runs), (_, tracer, few_paths, few_clipped, few_runs) = stages
    for mixed in (
        lambda: core.project(paths, tracer),
        lambda: core.exact_visibility(clipped, few_paths, tracer),
        lambda: core.exact_visibility(clipped, paths, tracer),
        lambda: core.samples_from_runs(few_clipped, runs),
        lambda: core.close_gaps(few_clipped, runs, 1.0, np.ones(len(paths), np.float32)),
        lambda: core.close_gaps(clipped, runs, 1.0, np.ones(len(few_paths), np.float32)),
        lambda: core.trim_folds(few_clipped, runs, few_paths, 5.0),
        lambda: core.trim_folds(clipped, runs, few_paths, 5.0),
        lambda: core.meet_ends(few_clipped, runs, few_paths, 8.0),
        lambda: core.meet_ends(clipped, runs, few_paths, 8.0),
        lambda: core.halo(few_clipped, runs, paths, np.ones(len(paths), np.float32)),
        lambda: core.halo(clipped, runs, few_paths, np.ones(len(few_paths), np.float32)),
        lambda: core.overshoot(few_clipped, runs, np.ones(len(paths), np.float32)),
        lambda: core.overshoot(clipped, runs, np.ones(len(few_paths), np.float32)),
        lambda: core.compact(few_clipped, paths, runs),
        lambda: core.compact(clipped, few_paths, runs),
        lambda: core.pens_of_runs(few_clipped, runs, paths.line_set, np.zeros((0, 4), np.uint32)),
        lambda: core.pens_of_runs(clipped, runs, few_paths.line_set, np.zeros((0, 4), np.uint32)),
        lambda: core.tessellate(few_clipped, runs, np.zeros(len(runs), np.uint32), None, [core.Pen()]),
        lambda: core.tessellate(clipped, runs, np.zeros(len(few_runs), np.uint32), None, [core.Pen()]),
    ):
        with pytest.raises(ValueError):
            mixed()


def test_runs_are_read_back_in_path_order(stages):
    _, tracer, paths, clipped, runs = stages[0]
    parts = core.with_hidden(clipped, runs, paths)
    found = core.compact(clipped, paths, parts)
    assert len(found) == len(parts) and np.all(np.diff(found.path.astype(int)) >= 0)
    np.testing.assert_array_equal(found.path, clipped.path[parts.piece])
    np.testing.assert_array_equal(found.path_id, paths.ids[found.path])
    np.testing.assert_array_equal(found.invisibility, parts.invisibility)
    first, last = found.offsets[:-1], found.offsets[1:] - 1
    np.testing.assert_array_equal(found.arc_px[first], parts.start_px)
    np.testing.assert_array_equal(found.arc_px[last], parts.end_px)
    lengths = np.linalg.norm(np.diff(found.px, axis=0), axis=1)
    along = np.add.reduceat(np.append(lengths, 0), first) - np.append(lengths, 0)[last]
    np.testing.assert_allclose(along, parts.end_px - parts.start_px, atol=2e-3)
    ids = found.path_id
    del found
    gc.collect()
    np.testing.assert_array_equal(ids, paths.ids[clipped.path[parts.piece]])


def test_a_tracer_of_moved_surfaces_is_refused(stages):
    surface, tracer, paths, clipped, _ = stages[0]
    surface.set_positions(np.full_like(surface.positions, np.nan))
    for late in (
        lambda: core.extract_paths(tracer, [({"crease": {}}, 60.0)]),
        lambda: core.exact_visibility(clipped, paths, tracer),
        lambda: core.depth_image(tracer),
    ):
        with pytest.raises(ValueError, match="sphere"):
            late()


def test_filters_of_line_sets_are_arrays_over_placements_and_materials():
    mesh = box()
    mesh.extra["material"] = np.array([0, 1, 0, 0, 0, 0], np.int32)
    tracer = core.Tracer(scene([mesh.surface()]), view((4, -5, 3), (0, 0, 0)))
    rows, creases = np.zeros(1, np.uint32), {"crease": {}}

    def edges(*of_set, **own):
        paths = core.extract_paths(tracer, [(creases, 60.0, *of_set)], **own)
        return len(paths.place) - len(paths)

    assert edges() == edges(None, None) == 12
    assert edges(np.zeros(1, np.uint8)) == 0
    assert edges(None, (rows, [np.array([0, 1], np.uint8)])) == 4
    assert edges(materials=(rows, [[0, 1]])) == 4
    assert edges(shown=np.zeros(1, np.uint32)) == 0
    assert edges(parameters={"crease": {"angle": np.array([100.0])}}) == 0
    assert edges(parameters={"crease": {"angle": np.array([np.nan])}}) == 12
    for wrong in ({"shown": [1, 2]}, {"materials": ([1], [[0]])}, {"parameters": {"crease": {"angel": [1.0]}}}):
        with pytest.raises(ValueError, match="placement|mask|unknown parameter 'angel'"):
            edges(**wrong)
