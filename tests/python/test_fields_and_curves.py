# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields and pieces of curves as NumPy arrays, and the benchmark that measures them."""

import json

import numpy as np
import pytest
from bench import line_meshes, lines
from native_core import core, counts, sphere


@pytest.fixture(scope="module")
def ball():
    return sphere(24).surface()


def test_a_unit_sphere_has_curvature_one(ball):
    for estimator in ("automatic", "jets", "one_ring"):
        fields = ball.fields(estimator)
        assert np.allclose(fields.k1, 1, atol=0.05) and np.allclose(fields.k2, 1, atol=0.05)
        assert np.allclose(fields.normal, ball.positions, atol=0.02)
        assert fields.feature_size > 0 and fields.reason


def test_the_smooth_contour_of_a_sphere_is_a_great_circle(ball):
    found = ball.find_curves("smooth_contour", eye=(0, 0.3, 0.9))
    assert len(found) == len(found.triangle) == len(found.start) == len(found.end)
    assert np.isclose(np.linalg.norm(found.end - found.start, axis=1).sum(), 2 * np.pi, rtol=0.02)
    near = ball.find_curves("smooth_contour", eye=(0, 0, 2), orthographic=False)
    assert np.allclose(near.start[:, 2], 0.5, atol=0.02)


def test_parameters_are_taken_by_name(ball):
    few, many = (ball.find_curves("isophote", {"count": count}, eye=(0, 0.3, 0.9)) for count in (2, 8))
    assert 0 < len(few) < len(many)


@pytest.mark.parametrize(
    "call, complaint",
    [
        (lambda ball: ball.fields("guess"), "sphere: estimator is 'guess'; it can be: automatic, jets, one_ring"),
        (lambda ball: ball.find_curves("crease"), "crease is no line across triangles"),
        (lambda ball: ball.find_curves("isophote", {"counts": 3}), "unknown parameter 'counts'"),
    ],
)
def test_mistakes_are_named(ball, call, complaint):
    with pytest.raises(ValueError, match=complaint):
        call(ball)


@pytest.mark.parametrize("shape", line_meshes.SHAPES)
def test_generated_meshes_are_whole(shape):
    mesh = line_meshes.SHAPES[shape](2048)
    surface = mesh.surface(core, shape)
    assert abs(len(mesh.triangles) / 2048 - 1) < 0.05 and not any(counts(surface.report).values())


def test_the_benchmark_measures_every_step(monkeypatch, capsys):
    monkeypatch.setitem(lines.REFERENCE, "2k", lines.REFERENCE["1M"])
    small = ["--triangles", "512,2048", "--views", "2"]
    lines.main([*small, "--json"], core, None)
    measured = json.loads(capsys.readouterr().out)
    meshes = {f"{shape} {size}" for shape in line_meshes.SHAPES for size in ("0k", "2k")}
    assert {row["mesh"] for row in measured["rows"]} == meshes
    steps = {row["step"] for row in measured["rows"]}
    assert {"one_ring", "together", "apparent_ridge: find", "apparent_ridge: chain", "kept 4: per view"} <= steps
    assert all(set(row) == set(lines.COLUMNS) for row in measured["rows"])
    assert all(row["ms"] >= 0 and row["triangles"] > 0 for row in measured["rows"])
    assert any(row["ratio"] for row in measured["rows"])
    assert all((row["ratio"] is None) == (row["reference_ms"] is None) for row in measured["rows"])
    assert len(measured["growth"]) > 10
    lines.main(small, core, None)
    assert "exponent" in capsys.readouterr().out
