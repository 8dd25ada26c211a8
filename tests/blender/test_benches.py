# SPDX-License-Identifier: GPL-3.0-or-later
"""Benchmarks that hook into a render measure what it does, and report when there is nothing to hook into."""

import json
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from the_addon import part

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

import scenes
from bench import agreement, over, renderers, worker
from bench import focus as bench
from bench.focus import PER_SAMPLE, coherence, density, reproject, world
from bench.focus import emphasis as emphasis_bench
from bench.focus.places import Places
from bench.visibility import methods
from bench.visibility.worker import orbit

SIZE = (320, 180)


def test_agreement_judges_the_samples_of_a_render(tmp_path):
    out = tmp_path / "rows.json"
    agreement.main(out, "boxes:2", "--size", "160x120")
    rows = json.loads(out.read_text())
    assert [(row["probes"], row["depth_scale"]) for row in rows] == list(agreement.METHODS)
    assert all(row["samples"] > 100 and row["ms"] >= 0 and row["all"]["agree"] > 0.95 for row in rows)
    shares = [row[far][name] for row in rows for far in ("all", "path", "image") for name in row[far]]
    assert len(shares) == len(rows) * 3 * 4 and all(0 <= share <= 1 for share in shares)


def test_what_lines_over_a_render_cost_is_told_by_its_parts(tmp_path, monkeypatch):
    if part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")
    monkeypatch.setattr(over, "REPEATS", 1)
    over.main(tmp_path / "row.json", "boxes:2", "--size", "64x36", "--over", "workbench")
    row = json.loads((tmp_path / "row.json").read_text())
    for clock in ("cpu", "wall"):
        photo, lines, evaluation, both = (row[f"{p}_{clock}_s"] for p in ("photo", "lines", "evaluation", "both"))
        assert min(photo, lines, evaluation) > 0 and both > lines
        assert row[f"beyond_{clock}"] == pytest.approx(1 - (photo + lines + evaluation) / both, abs=1e-3)
    assert len(bpy.data.scenes) == 1, "the scene is left as it was"


def test_passes_of_later_stages_are_not_counted_among_those_of_visibility():
    clock = part("gpu.clock").Clock()
    with methods.passes(SimpleNamespace(clock=clock)) as found:
        clock.start()
        clock.mark("depth")
    clock.start()
    clock.mark("bands")
    assert list(found) == ["depth"]


def lines(*ends, step=2.0):
    """Places on straight lines in the image, all fully drawn, each line a path and a run: ((x, y), (x, y))."""
    found = []
    for start, end in np.array(ends, float):
        length = np.hypot(*(end - start))
        along = (np.arange(round(length / step)) + 0.5) * step
        direction = (end - start) / length
        found.append((start + along[:, None] * direction, np.tile(direction, (len(along), 1)), along, length))
    number = np.repeat(np.arange(len(found)), [len(part[2]) for part in found])
    px, direction, along = (np.concatenate([part[k] for part in found]) for k in range(3))
    to_end = np.minimum(along, np.array([part[3] for part in found])[number] - along)
    index, ones = np.arange(len(px)), np.ones(len(px))
    return Places(index, index, ones, px, direction, ones * step, along, number, number, to_end, ones)


def test_lines_nearer_than_they_want_to_be_are_found():
    near = density.nearest_alongside(lines([(0, 0), (200, 0)], [(0, 4), (200, 4)]), 10.0)
    inner = np.isfinite(near)
    assert inner.mean() == pytest.approx(0.9, abs=0.02)  # all but 10 pixels at each end
    np.testing.assert_allclose(near[inner], 4.0)
    far = lines([(0, 0), (200, 0)], [(0, 20), (200, 20)])
    assert np.isinf(density.nearest_alongside(far, 10.0)).all()
    faint = replace(far, px=far.px * (1, 0.2), shown=np.where(far.path == 1, 0.5, 1.0))
    assert np.isinf(density.nearest_alongside(faint, 10.0)).all()


def test_lines_that_cross_or_go_elsewhere_are_not_crowded():
    right_angle = lines([(0, 50), (200, 50)], [(100, -50), (100, 150)])
    assert np.isinf(density.nearest_alongside(right_angle, 10.0)).all()
    shallow = lines([(0, 0), (200, 0)], [(0, -36.4), (200, 36.4)])  # 20 degrees: 10 pixels apart 27 pixels from there
    near = density.nearest_alongside(shallow, 10.0)
    away = np.abs(shallow.px[:, 0] - 100)
    assert np.isinf(near[away < 9]).all() and np.isfinite(near[(away > 12) & (away < 24)]).all()
    assert np.isinf(near[away > 30]).all()


def test_frames_that_do_not_change_are_steady():
    """And what the bench counts is there."""
    new_scene("boxes:6")

    def work(place):
        drawn = place.draw(world.evenly_spaced(20.0))
        alone, smooth, of_view = coherence.Static(10.0), coherence.Static(10.0), coherence.OfView(10.0)
        in_time = coherence.InTime(1, smooth)
        for _ in range(4):
            again = place.draw(world.evenly_spaced(20.0))
            for watch in (alone, in_time, of_view):
                watch.see(again)
        told = coherence.rows("boxes:6", alone, {1: smooth}, of_view)
        return density.rows("boxes:6", drawn, 20.0), told, drawn.places()

    crowded, steady, places = world.measure(work, SIZE)
    value = {row["figure"]: row["value"] for row in crowded + steady}
    assert value["samples drawn"] > value["samples fully drawn"] > 100 and value["samples left out, share"] > 0
    assert value["fully drawn samples nearer than d / 2, share"] < 0.01
    assert value["static lines: places a frame"] > 0.9 * len(places.shown)
    for how in ("", ", smoothed over 1 to each side"):
        assert value[f"static lines: places a frame{how}"] == value["static lines: places a frame"]
        assert value[f"static lines: largest change of opacity{how}"] < 1e-6
    for what in ("ink", "share of ink taken"):
        assert value[f"lines of the view: {what}, mean difference, soft"] == pytest.approx(0, abs=1e-6)


def test_a_place_is_found_again_from_another_side():
    """The middle of the picture is elsewhere after a turn, by as much as its ink is."""
    new_scene("boxes:3")

    def work(place):
        turned = orbit(place.view, np.zeros(3), 2, np.radians(1.0))
        one, two = (place.draw(world.evenly_spaced(1.0), view) for view in turned)
        seen = [reproject.Seen(each.view, each.image.depth) for each in (one, two)]
        over = seen[1].brought_over(seen[0])
        shade = [np.where(s.distance < reproject.NOTHING, np.sin(40 * s.points()).sum(axis=2), 0) for s in seen]
        still = np.abs(shade[1] - shade[0])[over.known].mean()
        changed = coherence.changes(coherence.on_paths(one), coherence.on_paths(two), 2.0)[0]
        return over.known.mean(), over.difference(shade[1], shade[0])[0], still, len(changed) / len(one.places().shown)

    known, moved, still, followed = world.measure(work, SIZE)
    assert known > 0.3 and moved < 0.35 * still
    assert followed > 0.7


def test_fall_off_is_measured_ring_by_ring():
    f = np.tile(np.linspace(-0.2, 1.2, 281), (10, 1)).clip(0, 1)
    sharp = np.ones_like(f)
    smooth = emphasis_bench.fall_off(f, 1 - f, sharp)
    assert smooth[0] == 1 and smooth[-1] == 0 and emphasis_bench.largest_jump(smooth) == pytest.approx(0.1, abs=0.01)
    assert emphasis_bench.largest_jump(emphasis_bench.fall_off(f, (f < 0.5) * 1.0, sharp)) == 1


@pytest.mark.parametrize("is_slow, first, moved", [(True, 1, 0), (False, 3, 3)])
def test_a_slow_renderer_draws_one_frame_of_a_scene(tmp_path, monkeypatch, is_slow, first, moved):
    drawn = []

    class Renderer(renderers.Picture):
        def frame(self):
            drawn.append(bpy.context.scene.render.resolution_percentage)

    Renderer.is_slow = is_slow
    monkeypatch.setitem(renderers.BY_NAME, "it", Renderer)
    out = tmp_path / "rows.json"
    asked = {"scene": "boxes:2", "renderer": "it", "repeats": 3, "size": SIZE, "shared": "", "out": str(out)}
    worker.main(asked)
    record = json.loads(out.read_text())
    assert (len(record["first"]), len(record["moved"])) == (first, moved) and record["triangles"] > 0
    assert drawn == [100] * (1 if is_slow else 8)  # percent of the picture's size; others have a cold round, too


def test_of_the_renderers_freestyle_alone_is_slow():
    assert [name for name, renderer in renderers.BY_NAME.items() if renderer.is_slow] == ["freestyle"]


def test_bench_rows_are_told_as_a_table():
    rows = [{"figure": PER_SAMPLE, "scene": str(value), "value": value, "wanted": None} for value in (1.0, 1.5)]
    assert bench.linearity(rows)[0]["value"] == 1.5 and bench.linearity(rows[:1]) == []
    assert len(bench.table(rows).splitlines()) == 3


def new_scene(spec):
    bpy.ops.wm.read_homefile()
    scenes.build(spec)
    return bpy.context.scene
