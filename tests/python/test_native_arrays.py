# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays passed to and from the native module: views without copies, no references kept, errors by name."""

import gc
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from native_core import box, core, counts, draw, frame, members, scene, sphere, surface, view

from addon import pipeline

CORNER = ((4, -5, 3), (0, 0, 0))
CREASES = [({"crease": {}}, 60.0)]


def test_arrays_are_read_only_views():
    cube = box().surface()
    made = frame(scene([cube]), view(*CORNER), CREASES)
    made.picture()
    views = [
        *members("surface", cube, "positions triangles triangle_facet edges").values(),
        *members("paths", made.paths, "offsets points_obj place edge_t kinds strength closed ids").values(),
        *members("clipped", made.clipped, "offsets px depth position_view arc_px source facet0").values(),
        *members("visible", made.visible, "piece start_px end_px").values(),
        *members("polylines", made.polylines(), "offsets px path_id pen").values(),
        *members("strokes", made.strokes, "px arc triangles").values(),
    ]
    for array in views:
        assert array.size and not array.flags.writeable
        with pytest.raises(ValueError):
            array[...] = 0
    owners = ((cube, "positions"), (made.paths, "points_obj"), (made.clipped, "px"), (made.visible, "start_px"))
    for owner, name in owners:
        assert np.shares_memory(getattr(owner, name), getattr(owner, name)), "the same memory, not a copy"


def test_views_keep_their_owner():
    ball = sphere(40).surface()
    made = frame(scene([ball]), view(*CORNER), CREASES)
    lines = made.polylines()
    views = [ball.triangles, made.paths.points_obj, lines.px]
    expected = [array.copy() for array in views]
    del ball, made, lines
    gc.collect()
    others = [sphere(40).surface() for _ in range(3)]  # would reuse the memory
    assert all(map(np.array_equal, views, expected)) and others


def test_borrowed_arrays_are_not_kept():
    mesh = box().arrays()
    before = {name: sys.getrefcount(array) for name, array in mesh.items()}
    cube = surface("box", mesh)
    assert {name: sys.getrefcount(array) for name, array in mesh.items()} == before
    mesh["positions"][:] = 7.0
    mesh["corner_verts"][:] = 0
    assert cube.positions.max() == 1.0
    cube.set_positions(mesh["positions"])
    assert cube.positions.max() == 7.0 and counts(cube.report)["degenerate_polygons"] == 6


def test_a_mesh_keeps_the_arrays_that_it_borrows():
    arrays = box().arrays()
    mesh = core.Mesh(**arrays)
    expected = surface("box", arrays).triangles
    del arrays
    gc.collect()
    others = [box().arrays() for _ in range(9)]  # would reuse the memory
    assert np.array_equal(core.Surface("box", mesh).triangles, expected) and others


def test_other_types_and_layouts_are_converted():
    plain = box().arrays()
    wide = {name: array.astype(np.float64 if array.dtype == np.float32 else np.int64) for name, array in plain.items()}
    other = {name: np.asfortranarray(array) for name, array in wide.items()}
    assert np.array_equal(surface("box", other).triangles, surface("box", plain).triangles)
    read_only = {name: array.copy() for name, array in plain.items()}
    for array in read_only.values():
        array.flags.writeable = False
    assert surface("box", read_only).polygon_count == 6


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
        surface("box", box().arrays() | {name: value})


def test_polygon_edges_refuses_broken_offsets():
    verts = np.arange(4, dtype=np.int32)
    for offsets in ([0, 1000000, 4], [-1000000, 4], [0, 5]):
        with pytest.raises(ValueError, match="polygon_offsets"):
            core.PolygonEdges(np.array(offsets, np.int32), verts)


def test_scenes_refuse_what_does_not_fit():
    good = [[box().surface()], np.zeros(1, np.int32), np.eye(4)[None], np.zeros(1, np.uint64), np.ones(1, np.uint8)]
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
    placed, seen = scene([box().surface()]), view(*CORNER)
    for kinds, unknown in (({"outline": {}}, "outline"), ({"crease": {"angel": 3.0}}, "angel")):
        with pytest.raises(ValueError, match=unknown):
            pipeline.frame(placed, seen, pipeline.style_of_lines(kinds), core.CpuBackend(), pipeline.options()).find()
    with pytest.raises(ValueError, match="sample_step"):
        frame(placed, seen, CREASES, sample_step=0.0).find()


def test_a_scene_outlives_its_names():
    made = frame(scene([box().surface()]), view(*CORNER), CREASES)
    gc.collect()
    made.find()
    assert len(made.paths) == 12


def test_a_box_has_nine_visible_edges():
    arrays = draw(scene([box().surface()]), view(*CORNER, size=(640, 480)), [({"crease": {}}, 30.0)])
    assert len(arrays["clipped.path"]) == 12
    assert len(arrays["visible.piece"]) == 9
    lines = arrays["passes.lines"]
    assert lines.shape == (480, 640, 4) and 0.79 < lines[..., 3].max() <= 1.0
    assert arrays["passes.depth"].min() == pytest.approx(np.sqrt(50) - np.sqrt(3), abs=0.1)


def test_calls_can_be_cancelled():
    cancel = core.Cancel()
    cancel.cancel()
    with pytest.raises(core.Cancelled):
        frame(scene([box().surface()]), view(*CORNER), CREASES, cancel=cancel).find()


HASH = """
import os, sys
if sys.argv[1] == "one":
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
import numpy as np
from native_core import *
place = lambda x, y: np.array([[1, 0, 0, x], [0, 1, 0.2, y], [0, 0, 1, 0.3 * x], [0, 0, 0, 1.0]])
ball = sphere(60).surface()
placed = scene([ball] * 9, [place(i % 3 - 1, i // 3 - 1) for i in range(9)])
print(digest(draw(placed, view((4, -5, 3), (0, 0, 0), size=(640, 480)))))
"""


PROCESSORS = os.sched_getaffinity(0) if hasattr(os, "sched_getaffinity") else ()  # that a process may leave


@pytest.mark.skipif(len(PROCESSORS) < 2, reason="one processor only, or a system that gives no process fewer")
def test_bytes_do_not_depend_on_the_number_of_threads():
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(Path(__file__).parent), *sys.path])}

    def bytes_with(threads):
        return subprocess.check_output([sys.executable, "-c", HASH, threads], env=environment, text=True)

    assert bytes_with("one") == bytes_with("all") == bytes_with("all")


def test_surfaces_that_have_moved_since_a_frame_began_are_refused():
    ball = sphere(16).surface()
    begun, found = (frame(scene([ball]), view(*CORNER), CREASES, with_depth=True) for _ in range(2))
    found.find()
    ball.set_positions(np.full_like(ball.positions, np.nan))
    with pytest.raises(ValueError, match="sphere"):
        found.see()
    begun.picture()  # it had looked at nothing yet
    assert len(begun.paths) == 0


def test_filters_of_line_sets_are_arrays_over_placements_and_materials():
    mesh = box()
    mesh.extra["material"] = np.array([0, 1, 0, 0, 0, 0], np.int32)
    placed, rows = scene([mesh.surface()]), np.zeros(1, np.uint32)

    def edges(*of_set, **own):
        materials = [rule and core.MaterialFilter(*rule) for rule in of_set[1:]]
        if "lined" in own:
            own["lined"] = core.MaterialFilter(*own["lined"])
        said = core.Overrides(placements=of_set[:1], materials=materials, **own)
        made = frame(placed, view(*CORNER), CREASES, notes=said)
        made.find()
        return len(made.paths.place) - len(made.paths)

    assert edges() == edges(None, None) == 12
    assert edges(np.zeros(1, np.uint8)) == 0
    assert edges(None, (rows, [np.array([0, 1], np.uint8)])) == 4
    assert edges(lined=(rows, [[0, 1]])) == 4
    assert edges(shown=np.zeros(1, np.uint32)) == 0
    assert edges(parameters={"crease": {"angle": np.array([100.0])}}) == 0
    assert edges(parameters={"crease": {"angle": np.array([np.nan])}}) == 12
    for wrong in ({"shown": [1, 2]}, {"lined": ([1], [[0]])}, {"parameters": {"crease": {"angel": [1.0]}}}):
        with pytest.raises(ValueError, match="placement|mask|unknown parameter 'angel'"):
            edges(**wrong)
