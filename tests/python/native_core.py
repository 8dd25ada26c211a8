# SPDX-License-Identifier: GPL-3.0-or-later
"""The native module in plain Python, and the whole pipeline from mesh arrays to a picture."""

import hashlib
import json
from dataclasses import dataclass, field

import numpy as np
import pytest

from addon import native

if native.problem():
    pytest.skip("the native module is not built", allow_module_level=True)

from addon import pipeline, style

core = native.load()
SIZE = (96, 64)
ALL_LINES = {d["name"]: {} for d in core.line_definitions()}


@dataclass
class Mesh:
    """A mesh as Blender holds it."""

    name: str
    positions: np.ndarray
    polygons: list
    loose: list = field(default_factory=list)  # edges without polygons
    extra: dict = field(default_factory=dict)  # optional arguments of the native Mesh

    def arrays(self):
        """The arguments of the native Mesh."""
        verts = np.array([v for polygon in self.polygons for v in polygon], np.int32)
        offsets = np.cumsum([0, *map(len, self.polygons)], dtype=np.int32)
        found = core.PolygonEdges(offsets, verts)
        edges = np.concatenate([found.edge_verts, np.array(self.loose, np.int32).reshape(-1, 2)])
        arrays = {"positions": np.asarray(self.positions, np.float32).reshape(-1, 3), "edge_verts": edges}
        arrays |= {"corner_verts": verts, "corner_edges": found.corner_edges, "polygon_offsets": offsets}
        return arrays | self.extra

    def surface(self):
        return surface(self.name, self.arrays())


def surface(name, arrays):
    return core.Surface(name, core.Mesh(**arrays))


def counts(report):
    """{what: number} of a native report."""
    return {name: getattr(report, name) for name in dir(report) if not name.startswith("_")}


def box(low=(-1, -1, -1), high=(1, 1, 1)):
    corners = [[(low, high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return Mesh("box", np.array(corners, np.float32), faces)


def sphere(n):
    """2 n segments around z, n rings."""
    t, p = np.meshgrid(np.pi * np.arange(1, n) / n, np.pi * np.arange(2 * n) / n, indexing="ij")
    rings = np.stack([np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)], -1).reshape(-1, 3)

    def at(j, i):
        return 2 + (j - 1) * 2 * n + i % (2 * n)

    faces = []
    for i in range(2 * n):
        faces.append((0, at(1, i), at(1, i + 1)))
        faces += [(at(j, i), at(j + 1, i), at(j + 1, i + 1), at(j, i + 1)) for j in range(1, n - 1)]
        faces.append((1, at(n - 1, i + 1), at(n - 1, i)))
    return Mesh("sphere", np.concatenate([[(0, 0, 1), (0, 0, -1)], rings]), faces)


def view(eye, target, *, orthographic=False, near=0.1, far=1000.0, size=SIZE):
    """Looks from eye to target; as wide as far away, or half of that when orthographic."""
    eye, target = np.asarray(eye, float), np.asarray(target, float)
    back = (eye - target) / np.linalg.norm(eye - target)
    right = np.cross((0, 0, 1), back)
    right = right / np.linalg.norm(right) if np.linalg.norm(right) > 1e-9 else np.array([1.0, 0, 0])
    rotation = np.stack([right, np.cross(back, right), back])
    world_to_view = np.eye(4)
    world_to_view[:3, :3], world_to_view[:3, 3] = rotation, -rotation @ eye
    sx, sy = 2.0, 2.0 * size[0] / size[1]
    if orthographic:
        reach = np.linalg.norm(eye - target) / 2
        depth = [0, 0, -2 / (far - near), -(far + near) / (far - near)]
        clip = np.array([[1 / reach, 0, 0, 0], [0, size[0] / size[1] / reach, 0, 0], depth, [0, 0, 0, 1]])
    else:
        depth = [0, 0, -(far + near) / (far - near), -2 * far * near / (far - near)]
        clip = np.array([[sx, 0, 0, 0], [0, sy, 0, 0], depth, [0, 0, -1, 0]])
    return core.View(world_to_view, clip, *size, orthographic, near, far)


def scene(surfaces, matrices=None, usage=None):
    """One placement per surface."""
    count = len(surfaces)
    matrices = np.array([np.eye(4)] * count if matrices is None else matrices, float).reshape(count, 4, 4)
    usage = np.array([core.Usage.DRAW | core.Usage.OCCLUDE] * count if usage is None else usage, np.uint8)
    return core.Scene(surfaces, np.arange(count, dtype=np.int32), matrices, np.arange(count, dtype=np.uint64), usage)


def members(stage, owner, names):
    """Arrays of a stage, by "stage.name"."""
    return {f"{stage}.{name}": getattr(owner, name) for name in names.split()}


def frame(placed, seen, line_sets=((ALL_LINES, 60.0),), *, notes=None, cancel=None, **options):
    """A native Frame of line sets, pairs of {definition: {parameter: value}} and the angle of corners, each with
    haloes, overshoot, and pens for what is visible and what is hidden."""
    pen = {"width": 3.0, "opacity": 0.8, "taper": 4.0}
    common = {"least_length": 0.0, "halo": 2.5, "overshoot": 1.5, "pen": pen, "hidden": [{"pen": pen}]}
    sets = [{"kinds": kinds, "corner_angle": angle, **common} for kinds, angle in line_sets]
    chosen = style.parse(json.dumps({"schema": style.SCHEMA, "line_sets": sets}))
    beside = {"notes": notes} if notes else {}
    return pipeline.frame(placed, seen, chosen, core.CpuBackend(), pipeline.options(**options), cancel=cancel, **beside)


def draw(placed, seen, line_sets=((ALL_LINES, 60.0),)):
    """Every array of a Frame, by the names of its members."""
    made = frame(placed, seen, line_sets, with_depth=True)
    made.picture()
    arrays = members("paths", made.paths, "offsets points_obj place kinds closed ids")
    arrays |= members("clipped", made.clipped, "offsets path px depth position_view arc_px sample_start sample_count")
    for stage in ("visible", "runs", "drawn"):
        arrays |= members(stage, getattr(made, stage), "piece start_px end_px invisibility")
    names = "offsets path_id path piece start_px end_px invisibility line_set closed pen shown px position_view arc_px"
    arrays |= members("polylines", made.polylines(), names + " strength kinds")
    arrays |= members("strokes", made.strokes, "px arc half_width opacity triangles")
    arrays["samples"] = made.visible.samples(made.clipped)
    return arrays | {f"passes.{name}": pixels for name, pixels in images(made.passes()).items()}


def images(passes):
    """{name: pixels} of all passes that a frame has, those of several images one by one."""
    several = {"line_sets": passes["line_sets"], "mattes": dict(enumerate(passes["mattes"]))}
    found = {name: pixels for name, pixels in passes.items() if name not in several}
    found |= {f"{name}.{each}": pixels for name, of in several.items() for each, pixels in of.items()}
    return {name: pixels for name, pixels in found.items() if pixels is not None}


def digest(arrays):
    """One hash of all bytes."""
    total = hashlib.sha256()
    for name in sorted(arrays):
        total.update(name.encode() + np.ascontiguousarray(arrays[name]).tobytes())
    return total.hexdigest()
