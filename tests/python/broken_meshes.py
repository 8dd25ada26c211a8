# SPDX-License-Identifier: GPL-3.0-or-later
"""Random meshes with every kind of defect, deterministic for a seed."""

import numpy as np
from native_core import Mesh, box, sphere

NON_FINITE = (np.nan, np.inf, -np.inf)


def soup(rng):
    count = int(rng.integers(3, 40))
    polygons = [tuple(map(int, rng.integers(0, count, rng.integers(3, 7)))) for _ in range(rng.integers(1, 40))]
    return Mesh("soup", rng.normal(size=(count, 3)), polygons)


def terrain(rng):
    n = int(rng.integers(1, 12))
    x, y = np.meshgrid(np.linspace(-1, 1, n + 1), np.linspace(-1, 1, n + 1))
    z = rng.choice([0.0, 0.1, 1.0]) * rng.normal(size=x.shape)

    def at(i, j):
        return i + (n + 1) * j

    quads = [(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)) for j in range(n) for i in range(n)]
    return Mesh("terrain", np.stack([x, y, z], -1).reshape(-1, 3), quads)


def disc(rng):
    n = int(rng.choice([5, 6, 17, 300, 10000], p=[0.3, 0.3, 0.3, 0.08, 0.02]))
    a = 2 * np.pi * np.arange(n) / n
    z = rng.choice([0.0, 0.0, 0.3]) * rng.normal(size=n)
    mesh = Mesh("disc", np.stack([np.cos(a), np.sin(a), z], -1), [tuple(range(n))])
    if rng.random() < 0.6:  # fans from its first corner
        triangles = np.stack([np.zeros(n - 2), np.arange(1, n - 1), np.arange(2, n)], -1)
        mesh.extra["ngon_triangles"] = triangles.astype(np.int32)
        mesh.extra["ngon_polygon"] = np.zeros(n - 2, np.int32)
    return mesh


def few(rng):
    vertices = int(rng.integers(0, 4))
    loose = [(0, vertices - 1)] if vertices > 1 else []
    return Mesh("few", rng.normal(size=(vertices, 3)), [], loose)


SHAPES = (soup, terrain, disc, few, lambda rng: box(), lambda rng: sphere(int(rng.integers(2, 9))))


def some(rng, count, share=0.2):
    """A few indices below count."""
    return rng.choice(count, size=max(1, int(share * count * rng.random())), replace=False) if count else []


def non_finite(rng, mesh):
    for v in some(rng, len(mesh.positions)):
        mesh.positions[v, rng.integers(3)] = rng.choice(NON_FINITE)


def collapsed(rng, mesh):
    for v in some(rng, len(mesh.positions), 0.5):
        mesh.positions[v] = mesh.positions[rng.integers(len(mesh.positions))]


def flattened(rng, mesh):
    mesh.positions[:, rng.integers(3)] *= rng.choice([0.0, 1e-20])


def duplicated(rng, mesh):
    for f in some(rng, len(mesh.polygons), 0.5):
        polygon = mesh.polygons[f]
        turn = int(rng.integers(len(polygon) + 1))
        again = polygon[turn:] + polygon[:turn]
        mesh.polygons.append(again[::-1] if rng.random() < 0.5 else again)


def with_fins(rng, mesh):
    """More polygons at edges that have some."""
    base = len(mesh.positions)
    for f in some(rng, len(mesh.polygons), 0.5):
        mesh.polygons.append((*mesh.polygons[f][:2], base))
    mesh.positions = np.concatenate([mesh.positions, rng.normal(size=(1, 3))])


def with_loose_edges(rng, mesh):
    if len(mesh.positions):
        mesh.loose += [tuple(map(int, rng.integers(0, len(mesh.positions), 2))) for _ in range(5)]


def turned(rng, mesh):
    mesh.polygons = [p[::-1] if rng.random() < 0.3 else p for p in mesh.polygons]


def with_small_polygons(rng, mesh):
    if len(mesh.positions):
        mesh.polygons += [tuple(map(int, rng.integers(0, len(mesh.positions), k))) for k in (0, 1, 2)]


def sized(rng, mesh):
    mesh.positions = mesh.positions * 10.0 ** rng.uniform(-30, 30)


def far_away(rng, mesh):
    mesh.positions = mesh.positions + 10.0 ** rng.uniform(0, 8) * rng.normal(size=3)


def marked(rng, mesh):
    polygons, edges = len(mesh.polygons), len(mesh.arrays()["edge_verts"])
    mesh.extra["material"] = rng.integers(-2, 5, polygons).astype(np.int32)
    mesh.extra["occluding"] = rng.integers(0, 2, polygons).astype(np.uint8)
    for name in ("sharp_edges", "seams", "edge_marks"):
        mesh.extra[name] = (rng.random(edges) < 0.2).astype(np.uint8)


def badly_triangulated(rng, mesh):
    """Triangles of n-gons that name vertices of anywhere."""
    ngons = [f for f, p in enumerate(mesh.polygons) if len(p) > 4]
    if ngons:
        polygon = np.sort(rng.choice(ngons, 12)).astype(np.int32)
        mesh.extra["ngon_polygon"] = polygon
        mesh.extra["ngon_triangles"] = rng.integers(0, len(mesh.positions), (12, 3)).astype(np.int32)


OF_POLYGONS = (duplicated, with_fins, with_loose_edges, turned, with_small_polygons)
SPOILERS = (non_finite, collapsed, flattened, sized, far_away, *OF_POLYGONS)


def broken_mesh(seed):
    """A mesh with up to four faults."""
    rng = np.random.default_rng(seed)
    mesh = rng.choice(SHAPES)(rng)
    mesh.positions = np.array(mesh.positions, np.float64).reshape(-1, 3)
    with np.errstate(all="ignore"):
        for spoil in rng.choice(SPOILERS, rng.integers(0, 5), replace=False):
            spoil(rng, mesh)
        for last in (marked, badly_triangulated):
            if rng.random() < 0.5:
                last(rng, mesh)
        mesh.positions = mesh.positions.astype(np.float32)
    return mesh, rng


def broken_matrix(rng):
    """Mostly a motion; sometimes mirrored, flattened, huge, or no matrix at all."""
    matrix = np.eye(4)
    matrix[:3, :3] = np.linalg.qr(rng.normal(size=(3, 3)))[0] * rng.choice([1.0, -1.0, 0.5])
    matrix[:3, 3] = rng.normal(size=3)
    fault = rng.integers(12)
    if fault == 0:
        matrix[:3, rng.integers(3)] = 0.0
    elif fault == 1:
        matrix[rng.integers(3), rng.integers(4)] = rng.choice(NON_FINITE)
    elif fault == 2:
        matrix[:3] *= 10.0 ** rng.uniform(-200, 200)
    return matrix
