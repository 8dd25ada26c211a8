# SPDX-License-Identifier: GPL-3.0-or-later
"""Refined and repaired meshes through the native module: arguments, errors, and results."""

import numpy as np
import pytest
from native_core import core as native
from native_core import counts

CORNERS = np.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], np.float32)
QUADS = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]], np.int32)
OFFSETS = np.arange(0, 25, 4, dtype=np.int32)


def box():
    return "box", mesh(CORNERS, QUADS.ravel())


def mesh(positions, quads, **more):
    """A native Mesh of four corners to a polygon."""
    edges = native.PolygonEdges(OFFSETS, quads)
    return native.Mesh(
        positions=positions,
        edge_verts=edges.edge_verts,
        corner_verts=quads,
        corner_edges=edges.corner_edges,
        polygon_offsets=OFFSETS,
        **more,
    )


def test_a_refined_surface_is_a_surface():
    surface = native.RefinedSurface(*box(), level=3)
    assert isinstance(surface, native.Surface) and surface.polygon_count == 6 * 4**3
    assert np.linalg.norm(surface.positions, axis=1).max() == pytest.approx(np.sqrt(0.75), abs=1e-6)
    version = surface.version
    surface.set_positions(2 * CORNERS)
    assert np.linalg.norm(surface.positions, axis=1).max() == pytest.approx(2 * np.sqrt(0.75), abs=1e-6)
    assert surface.version != version


@pytest.mark.parametrize(
    "words, complaint",
    [
        ({"level": 0}, "1 to 7"),
        ({"level": 8}, "1 to 7"),
        ({"level": 2, "edge_creases": np.zeros(3, np.float32)}, "differ in number"),
        ({"level": 2, "vertex_creases": np.zeros(9, np.float32)}, "differ in number"),
    ],
)
def test_what_cannot_be_refined(words, complaint):
    with pytest.raises(ValueError, match=f"box.*{complaint}"):
        native.RefinedSurface(*box(), **words)


def test_a_cage_whose_arrays_do_not_fit_cannot_be_refined():
    with pytest.raises(ValueError, match="box.*material has 5"):
        native.RefinedSurface("box", mesh(CORNERS, QUADS.ravel(), material=np.zeros(5, np.int32)), level=2)


def test_positions_of_another_cage():
    with pytest.raises(ValueError, match="box: 3 positions for 8 vertices"):
        native.RefinedSurface(*box(), level=1).set_positions(CORNERS[:3])


def test_repaired_arrays_make_a_surface():
    quads = QUADS.copy()
    quads[2] = quads[2][::-1]
    turned = mesh(CORNERS, quads.ravel())
    whole = native.RepairedMesh("turned", turned, orient=True)
    assert counts(whole.report) == {"turned_polygons": 1, "refused_polygons": 0, "too_many_triangles": 0}
    surface = native.Surface("turned", whole.mesh)
    assert surface.mesh_edges == 12 and surface.report.inconsistent_edges == 0
    with pytest.raises(ValueError, match="turned: repair: lengths"):
        native.RepairedMesh("turned", turned, resample=1, edge_length=-1.0)
