# SPDX-License-Identifier: GPL-3.0-or-later
"""Benchmarks that start Blender processes, at their smallest size: their output as JSON and as a table."""

import json
import math
import os
import re
import sys
from pathlib import Path

import bpy
import pytest
from long_tests import takes_long
from the_addon import part

sys.path.insert(0, str(Path(__file__).parents[2] / "blender_scripts"))

from bench import coherence, focus, peers, scale, visibility

SMALL = ("--size", "160x90", "--scenes", "boxes:3", "--json")


@pytest.fixture(autouse=True)
def opengl():
    if part("render.gpu_context").gl_renderer() is None:
        pytest.skip("OpenGL is unusable here")


@pytest.fixture
def rows_of(capfd):
    """A function from a benchmark and its words to the rows of its JSON."""

    def run(bench, *words):
        status = bench.main([*SMALL, *words], bpy.app.binary_path, dict(os.environ), None)
        told, problems = capfd.readouterr()
        assert status == 0, problems
        rows = json.loads(told)
        assert len(bench.table(rows).splitlines()) > len(rows)
        return rows

    return run


def are_times(stages):
    return bool(stages) and all(0 <= ms < math.inf for ms in stages.values())


@takes_long
def test_bench_peers_tells_times_and_strokes_of_each_renderer(rows_of):
    """Without Freestyle, which compiles shaders for minutes."""
    rows = rows_of(peers, "--quick", "--repeats", "1")
    assert [row["renderer"] for row in rows] == [name for name in peers.RENDERERS if name != "freestyle"]
    for row in rows:
        assert row["triangles"] == 9 * 12 and row["first_s"] > 0 and row["moved_s"] > 0
        assert math.isfinite(row["peak_mb"])
        assert row["renderer"] == "workbench" or row["strokes"] > 0
    for row in rows[-2:]:
        assert are_times(row["stages"]) and row["lines_s"] > 0 and row["lines_moved_s"] > 0


def test_bench_visibility_tells_stages_and_errors_of_every_method(rows_of):
    """Of a smooth model, too, of whose contours folds are taken out before they are drawn."""
    rows = [
        row for scene in ("boxes:3", "suzanne:1") for row in rows_of(visibility, "--scenes", scene, "--frames", "2")
    ]
    assert sorted(row["method"] for row in rows) == sorted(2 * visibility.METHODS)
    for row in rows:
        assert row["segments"] > 0 and row["samples"] > 0 and row["fps"] > 0
        assert are_times(row["stages"]), row
        if row["method"] == "OGL":
            assert row["disagree"] is None and row["flicker"] is None
        else:
            assert 0 <= row["disagree"] < 0.2 and 0 <= row["flicker"] < 0.2
        if row["method"] == "exact":
            assert row["disagree"] == row["flicker"] == 0


@takes_long
def test_bench_focus_tells_figures_of_every_part(rows_of):
    rows = rows_of(focus, "--quick", "--frames", "2", "--smoothed", "1")
    value = {row["figure"]: row["value"] for row in rows}
    assert all(set(row) == {"figure", "scene", "value", "wanted"} for row in rows) and len(value) == len(rows)
    assert all(0 <= each < math.inf for each in value.values())
    assert all(each <= 1 for figure, each in value.items() if re.search(r", share\b", figure))
    counts = ("samples drawn", "static lines: places a frame", "Workbench, ms a frame", focus.PER_SAMPLE)
    assert all(value[figure] > 0 for figure in counts)
    assert any("gpu" in figure for figure in value)
    assert sum("in focus / out of it" in figure for figure in value) == 14  # of two styles, two kinds of focus


def test_bench_coherence_finds_dashes_that_hold_still_and_those_that_slide(capfd):
    """In a zoom, on lines of the mesh: Line Art's begin at the strokes' starts, from where they slide."""
    words = "--quick", "--frames", "3", "--scenes", "zoom", "--renderers", "fovea,line_art", "--lines", "mesh"
    assert coherence.main([*words, "--json"], bpy.app.binary_path, dict(os.environ), None) == 0
    rows = json.loads(capfd.readouterr().out)
    assert [row["renderer"] for row in rows] == ["fovea", "line_art"] and len(coherence.table(rows).splitlines()) == 3
    for row in rows:
        assert tuple(row) == coherence.COLUMNS and row["pure"] and row["frame_s"] > 0
    assert rows[0]["slide_p95_px"] < 0.02 and rows[1]["slide_median_px"] > 0.2


@takes_long
def test_bench_coherence_leaves_lines_to_the_renderers_that_have_them(capfd):
    """Smooth contours are of Fovea and Freestyle, hatching is of Fovea alone. In 4.3 Freestyle fails on smooth contours
    of meshes with borders, which is said."""
    words = "--quick", "--frames", "3", "--scenes", "orbit", "--lines", "smooth,hatching"
    fails = bpy.app.version < (4, 4)
    assert coherence.main([*words, "--json"], bpy.app.binary_path, dict(os.environ), None) == (1 if fails else 0)
    *own, freestyle = json.loads(capfd.readouterr().out)
    assert [(row["renderer"], row["lines"]) for row in own] == [("fovea", "smooth"), ("fovea", "hatching")]
    assert all(row["pure"] for row in own) and own[0]["slide_median_px"] is not None
    assert freestyle["renderer"] == "freestyle"
    if fails:
        assert "Freestyle fails on these lines" in freestyle["problem"]
    else:
        assert freestyle["lines"] == "smooth" and freestyle["pure"]


@takes_long
def test_bench_coherence_measures_where_there_is_no_line(capfd):
    """A bracket has no smooth contours."""
    words = "--quick", "--frames", "3", "--scenes", "turntable", "--lines", "smooth", "--renderers", "fovea"
    assert coherence.main([*words, "--json"], bpy.app.binary_path, dict(os.environ), None) == 0
    (row,) = json.loads(capfd.readouterr().out)
    assert row["pure"] and "problem" not in row


@takes_long
def test_bench_scale_tells_times_memory_and_stages_of_every_count(capfd):
    given = [("instances", 1000), ("objects", 100), ("picture", 160 * 90)]
    words = "--quick", "--size", "160x90", "--scenes", ",".join(["grid", *(f"{name}:{n}" for name, n in given)])
    assert scale.main([*words, "--json"], bpy.app.binary_path, dict(os.environ), None) == 0
    rows = json.loads(capfd.readouterr().out)
    counts = [("grid", count // scale.QUICK) for count in scale.COUNTS["grid"]] + given
    assert [(row["scene"], row["count"]) for row in rows] == counts
    for row in rows:
        assert row["first_s"] > 0 and row["moved_s"] > 0 and row["blank_s"] >= 0, row
        assert row["peak_mb"] >= row["scene_mb"] > 0 and row["strokes"] > 0 and row["exponents"].keys() <= row.keys()
        assert row["blank_mb"] > 0 and row["own_mb"] == max(0, row["peak_mb"] - row["blank_mb"])
        assert are_times(row["first_stages"]) and are_times(row["moved_stages"])
        assert sum(row["first_stages"].values()) <= row["first_s"]  # seconds, both
    assert "first" in scale.table(rows).splitlines()[2]
