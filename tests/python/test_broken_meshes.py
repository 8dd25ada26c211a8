# SPDX-License-Identifier: GPL-3.0-or-later
"""Broken meshes: no crash, no NaN in the results, and skipped elements are counted."""

import numpy as np
import pytest
from broken_meshes import broken_matrix, broken_mesh
from native_core import ALL_LINES, SIZE, Mesh, box, core, counts, draw, scene, sphere, surface, view

SEEDS, PER_TEST = 500, 25
LINE_SETS = [({"contour": {}, "silhouette": {}}, 60.0), (ALL_LINES, 30.0), ({"crease": {"angle": 0.0}}, 180.0)]


def camera(rng, placed):
    """Mostly looks at where the objects are, from near or far, from inside or outside."""
    eye = rng.normal(size=3) * 10.0 ** rng.uniform(-1, 2)
    return view(eye, rng.normal(size=3), orthographic=bool(rng.random() < 0.3), near=10.0 ** rng.uniform(-3, 0))


def expected_report(arrays):
    """Counts that need no geometry."""
    used = np.zeros(len(arrays["edge_verts"]), bool)
    used[arrays["corner_edges"]] = True
    finite = np.isfinite(arrays["positions"]).all(axis=1)
    return {"non_finite_vertices": int((~finite).sum()), "loose_edges": int((~used).sum())}


def without_normal(arrays):
    """Polygons that must be skipped: few corners, one twice in a row, or a broken vertex."""
    offsets, verts = arrays["polygon_offsets"], arrays["corner_verts"]
    finite = np.isfinite(arrays["positions"]).all(axis=1)
    polygons = [verts[a:b] for a, b in zip(offsets, offsets[1:])]
    return sum(len(p) < 3 or (p == np.roll(p, 1)).any() or not finite[p].all() for p in polygons)


def check_surface(surface, arrays):
    report = counts(surface.report)
    assert expected_report(arrays).items() <= report.items()
    assert report["degenerate_polygons"] >= without_normal(arrays)
    assert report["degenerate_polygons"] + report["duplicate_polygons"] <= surface.polygon_count
    assert len(surface.triangles) == len(surface.triangle_facet)
    if len(surface.triangles):
        assert surface.triangles.max() < len(surface.positions) and surface.triangle_facet.max() < surface.facet_count
    assert surface.mesh_edges == len(arrays["edge_verts"]) <= len(surface.edges)


def check_drawing(arrays):
    for name, array in arrays.items():
        if array.dtype.kind == "f" and name != "strokes.arc":  # arcs of closed strokes have ends at 1e9
            assert np.isfinite(array).all(), name
    for stage in ("visible", "runs", "drawn"):
        assert (arrays[f"{stage}.start_px"] < arrays[f"{stage}.end_px"]).all(), stage
    assert (abs(arrays["clipped.px"] - np.array(SIZE) / 2) <= 0.551 * np.array(SIZE) + 0.01).all()
    assert (arrays["clipped.position_view"][:, 2] < 0).all()
    assert len(np.unique(arrays["paths.ids"])) == len(arrays["paths.ids"])
    if len(arrays["strokes.triangles"]):
        assert arrays["strokes.triangles"].max() < len(arrays["strokes.px"])
    lines = arrays["passes.lines"]
    assert lines.min() >= 0 and lines.max() <= 1


@pytest.mark.parametrize("first", range(0, SEEDS, PER_TEST))
def test_random_broken_meshes(first):
    drawn = 0
    for seed in range(first, first + PER_TEST):
        mesh, rng = broken_mesh(seed)
        arrays = mesh.arrays()
        try:
            broken = surface(mesh.name, arrays)
            check_surface(broken, arrays)
            others = [broken, box().surface(), sphere(4).surface()]
            matrices = [broken_matrix(rng) for _ in others]
            placed = scene(others, matrices, rng.integers(0, 8, 3))
            result = draw(placed, camera(rng, placed), LINE_SETS)
            check_drawing(result)
        except BaseException as error:
            raise AssertionError(f"seed {seed}: {mesh.name}") from error
        drawn += len(result["visible.piece"])
    assert drawn > 0


@pytest.mark.parametrize("first", range(0, 200, 50))
def test_broken_meshes_are_repaired_into_meshes_that_draw(first):
    for seed in range(first, first + 50):
        mesh, rng = broken_mesh(seed)
        for name in ("ngon_triangles", "ngon_polygon"):  # Blender's name none but the polygon's own vertices
            mesh.extra.pop(name, None)
        arrays = mesh.arrays()
        try:
            options = {"orient": rng.random() < 0.7, "resample": int(rng.choice([0, 1]))}
            repaired = core.RepairedMesh(mesh.name, core.Mesh(**arrays), **options)
            whole = core.Surface(mesh.name, repaired.mesh)
        except BaseException as error:
            raise AssertionError(f"seed {seed}: {mesh.name}") from error
        assert whole.polygon_count <= 4 * len(arrays["corner_verts"]) + len(arrays["polygon_offsets"])
        assert repaired.report.turned_polygons <= len(arrays["polygon_offsets"]) - 1


def test_polygons_without_corners_are_oriented_with_the_others():
    """However many there are; what has corners is turned as it is without them."""

    def oriented(mesh):
        return core.RepairedMesh(mesh.name, core.Mesh(**mesh.arrays()), orient=True)

    mesh = box()
    mesh.polygons[2] = mesh.polygons[2][::-1]
    alone = oriented(mesh)
    mesh.polygons = [(), *mesh.polygons[:3], (), (), *mesh.polygons[3:], ()]
    beside = oriented(mesh)
    assert counts(beside.report) == counts(alone.report) and alone.report.turned_polygons == 1
    assert np.array_equal(*(core.Surface("box", each.mesh).triangles for each in (beside, alone)))
    assert oriented(Mesh("empty", np.zeros((1, 3)), [()])).report.turned_polygons == 0


@pytest.mark.parametrize("seed", range(40))
def test_moved_vertices_equal_a_fresh_surface(seed):
    mesh, rng = broken_mesh(seed)
    arrays = mesh.arrays()
    moved = surface("moved", arrays)
    positions = (arrays["positions"] + rng.normal(size=arrays["positions"].shape)).astype(np.float32)
    if len(positions):
        positions[rng.integers(len(positions))] = np.nan
    moved.set_positions(positions)
    fresh = surface("fresh", arrays | {"positions": positions})
    assert counts(moved.report) == counts(fresh.report)
    for name in ("positions", "triangles", "triangle_facet", "edges"):
        assert np.array_equal(getattr(moved, name), getattr(fresh, name), equal_nan=name == "positions"), name
    with pytest.raises(ValueError, match="moved"):
        moved.set_positions(np.zeros((len(positions) + 1, 3), np.float32))


def spoil_index(rng, arrays):
    """One index out of range; None where the mesh has none."""
    vertices, edges = len(arrays["positions"]), len(arrays["edge_verts"])
    limits = {"edge_verts": vertices, "corner_verts": vertices, "corner_edges": edges}
    name = rng.choice(list(limits))
    if not arrays[name].size:
        return None
    spoiled = arrays[name].copy()
    spoiled.flat[rng.integers(spoiled.size)] = rng.choice([-1, limits[name], 2**31 - 1, -(2**31)])
    return {name: spoiled}


def spoil_size(rng, arrays):
    name = rng.choice(["corner_verts", "corner_edges", "polygon_offsets"])
    if len(arrays[name]) < 2:
        return None
    longer = np.append(arrays[name], arrays[name][-1] + 1).astype(np.int32)
    return {name: arrays[name][:-1] if rng.random() < 0.5 else longer}


@pytest.mark.parametrize("spoil", [spoil_index, spoil_size])
def test_broken_topology_is_refused_by_name(spoil):
    refused = 0
    for seed in range(200):
        mesh, rng = broken_mesh(seed)
        arrays = mesh.arrays()
        change = spoil(rng, arrays)
        if change is None:
            continue
        with pytest.raises(ValueError, match=mesh.name):
            surface(mesh.name, arrays | change)
        refused += 1
    assert refused > 100


def test_duplicates_of_a_polygon_with_a_thousand_corners():
    mesh, _ = broken_mesh(0)
    a = 2 * np.pi * np.arange(1000) / 1000
    mesh.positions = np.stack([np.cos(a), np.sin(a), 0 * a], -1).astype(np.float32)
    mesh.polygons, mesh.loose, mesh.extra = [tuple(range(1000))] * 300, [], {}
    assert mesh.surface().report.duplicate_polygons == 299
