# SPDX-License-Identifier: GPL-3.0-or-later
"""Small scenes as native objects, up to the stages that the backends implement."""

import math

import landscape
import numpy as np
from the_addon import part

native, pipeline, style = part("native"), part("pipeline"), part("style")
core = native.load()


def surface(positions, polygons, name="Mesh"):
    """A native Surface of polygons given by their vertices."""
    corners = np.concatenate(polygons).astype(np.int32)
    offsets = np.cumsum([0, *map(len, polygons)], dtype=np.int32)
    edges = core.PolygonEdges(offsets, corners)
    mesh = core.Mesh(
        positions=np.array(positions, np.float32),
        edge_verts=edges.edge_verts,
        corner_verts=corners,
        corner_edges=edges.corner_edges,
        polygon_offsets=offsets,
    )
    return core.Surface(name, mesh)


def box(half=(1.0, 1.0, 1.0)):
    corners = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return surface(np.array(corners) * half, quads, "Box")


def ball(rings=24):
    """A sphere of radius 1 in quads and triangles."""
    around = 2 * rings
    points = [(0, 0, 1)]
    for i in range(1, rings):
        z, r = math.cos(math.pi * i / rings), math.sin(math.pi * i / rings)
        points += [(r * math.cos(math.pi * j / rings), r * math.sin(math.pi * j / rings), z) for j in range(around)]
    points.append((0, 0, -1))

    def at(i, j):
        return 1 + (i - 1) * around + j % around

    polygons = [(0, at(1, j), at(1, j + 1)) for j in range(around)]
    polygons += [
        (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)) for i in range(1, rings - 1) for j in range(around)
    ]
    polygons += [(at(rings - 1, j + 1), at(rings - 1, j), len(points) - 1) for j in range(around)]
    return surface(points, polygons, "Ball")


def hills():
    return surface(landscape.points(), landscape.quads(), "Hills")


def moved(location, turn=0.0, scale=1.0):
    """(4, 4): turned about z by an angle, scaled, then moved."""
    matrix = np.eye(4)
    c, s = math.cos(turn) * scale, math.sin(turn) * scale
    matrix[:2, :2] = (c, -s), (s, c)
    matrix[2, 2] = scale
    matrix[:3, 3] = location
    return matrix


def scene_of(placed, usage=None, section=None):
    """A native Scene of (surface, matrix) pairs, cut open by a plane (x, y, z, w) or by none."""
    surfaces = list(dict.fromkeys(surface for surface, _ in placed))
    numbers = np.array([surfaces.index(surface) for surface, _ in placed], np.int32)
    matrices = np.array([matrix for _, matrix in placed], np.float64).reshape(-1, 4, 4)
    usage = np.array([core.Usage.DRAW | core.Usage.OCCLUDE] * len(placed) if usage is None else usage, np.uint8)
    return core.Scene(surfaces, numbers, matrices, np.arange(1, len(placed) + 1, dtype=np.uint64), usage, None, section)


def room(section=None):
    """Boxes and balls that cover, pierce and touch each other, on a floor that reaches behind the eye."""
    rng = np.random.default_rng(4)
    shapes = [box(), box((0.4, 0.4, 1.5)), ball()]
    placed = [(box((30, 30, 0.1)), moved((0, 0, -0.6)))]
    for i in range(40):
        place = (*rng.uniform(-3, 3, 2), rng.uniform(-0.2, 0.8))
        placed.append((shapes[i % 3], moved(place, rng.uniform(0, 6), rng.uniform(0.2, 0.6))))
    return scene_of(placed, section=section)


def view_of(width=320, height=200, orthographic=False, eye=(5, -6, 2.5), near=0.1, far=60.0):
    """A native View from `eye` to the origin."""
    back = np.array(eye) / np.linalg.norm(eye)
    right = np.cross((0, 0, 1), back)
    right /= np.linalg.norm(right)
    rotation = np.array([right, np.cross(back, right), back])
    world_to_view = np.eye(4)
    world_to_view[:3, :3], world_to_view[:3, 3] = rotation, -rotation @ eye
    clip, aspect = np.zeros((4, 4)), width / height
    if orthographic:
        clip[0, 0], clip[1, 1], clip[3, 3] = 1 / (3 * aspect), 1 / 3, 1
        clip[2, 2:] = -2 / (far - near), -(far + near) / (far - near)
    else:
        clip[0, 0], clip[1, 1], clip[3, 2] = 2 / aspect, 2, -1
        clip[2, 2:] = -(far + near) / (far - near), -2 * far * near / (far - near)
    return core.View(world_to_view, clip, width, height, orthographic, near, far)


def frame_of(scene, view, line_style=None, *, backend=None, notes=None, **options):
    """A Frame ready for a backend's `visibility`: its lines are found. By default they are those of pen_and_ink, with a
    sample at every pixel, which the segment atlas looks at once."""
    asked = pipeline.options(**{"visibility": "atlas", "probes": 1, "sample_step": 1.0, **options})
    chosen = line_style or style.load("pen_and_ink")
    frame = pipeline.frame(scene, view, chosen, backend or core.CpuBackend(), asked, notes=notes)
    frame.find()
    return frame


def exact_samples(scene, view, line_style=None):
    """(samples,) float32 of the same Frame, by rays."""
    frame = frame_of(scene, view, line_style, visibility="exact")
    frame.see()
    return frame.visible.samples(frame.clipped)
