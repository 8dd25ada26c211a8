# SPDX-License-Identifier: GPL-3.0-or-later
"""`fovea bench lines`: the cost of line extraction, per surface and per view, and its growth with the mesh.

Runs without Blender. Times are medians of wall time over views, in ms; cpu_ms is the sum over all threads. Reference
times are those of a single-threaded viewer for the same task on the same kind of machine."""

import argparse
import json
import math
import statistics
import sys
import time
from collections import defaultdict
from pathlib import Path

import numpy as np
from command import eye as camera
from command import obj

from . import line_meshes
from .peers import count

VIEW = ("smooth_contour", "suggestive_contour", "apparent_ridge", "suggestive_highlight", "laplacian_line", "isophote")
TRIANGLES = (1 << 16, 1 << 18, 1 << 20)
STATIC = ("ridge", "valley", "parabolic", "zero_mean_curvature", "demarcating_curve")
TOGETHER = VIEW[:3]
KEPT = STATIC[:4]
TOWARDS = np.array([0.4, 0.3, 1.0]) / math.sqrt(1.25)  # unit direction to the viewer, who is five radii away
ESTIMATORS = {"one_ring": {"estimator": "one_ring"}, "jets 3/3": {"degree": 3, "rings": 3}, "automatic": {}}
COLUMNS = ("mesh", "triangles", "step", "ms", "cpu_ms", "count", "reference_ms", "ratio")

# Single-threaded, ms: one_ring is curvature and its derivative, once; others are fields plus tracing, per view.
REFERENCE = {
    "1M": {"one_ring": 714, "smooth_contour": 11.8 + 2.7, "suggestive_contour": 16.6 + 3.6, "ridge": 9.2, "valley": 5.8,
           "suggestive_highlight": 16.6 + 3.5, "apparent_ridge": 11.8 + 34.7 + 7.5,
           "together": 16.6 + 34.7 + 2.7 + 3.6 + 7.5},
    "bunny": {"one_ring": 47, "smooth_contour": 0.81 + 0.16, "suggestive_contour": 1.12 + 0.37, "ridge": 0.57,
              "valley": 0.32, "suggestive_highlight": 1.12 + 0.37, "apparent_ridge": 0.81 + 3.3 + 0.89,
              "together": 1.12 + 3.3 + 0.16 + 0.37 + 0.89},
    "rocker arm": {"one_ring": 13.4, "smooth_contour": 0.23 + 0.065, "suggestive_contour": 0.32 + 0.094, "ridge": 0.16,
                   "valley": 0.10, "suggestive_highlight": 0.32 + 0.094, "apparent_ridge": 0.23 + 1.1 + 0.32,
                   "together": 0.32 + 1.1 + 0.065 + 0.094 + 0.32},
}  # fmt: skip


def parse(words):
    parser = argparse.ArgumentParser("fovea bench lines", description=__doc__)
    add = parser.add_argument
    add("--triangles", type=counts, metavar="A,B", help="of the generated meshes (65536,262144,1048576)")
    add("--views", type=count, metavar="N", help="of which medians are taken (15)")
    add("--quick", action="store_true", help="generated meshes of up to 262k triangles, 5 views")
    add("--json", action="store_true", help="print JSON instead of a table")
    options = parser.parse_args(words)
    options.triangles = options.triangles or TRIANGLES[: 2 if options.quick else 3]
    options.views = options.views or (5 if options.quick else 15)
    return options


def counts(text):
    return [count(word) for word in text.split(",")]


def main(words, native, shared: Path | None) -> int:
    options = parse(words)
    rows = []
    for name, reference, mesh in meshes(options.triangles, shared):
        print(f"fovea: {name}", file=sys.stderr, flush=True)
        for step, timed, found in steps(native, name, mesh, options.views):
            rows.append(row(name, len(mesh.triangles), step, timed, found, REFERENCE.get(reference, {})))
    growth = exponents(rows)
    print(json.dumps({"rows": rows, "growth": growth}, indent=1) if options.json else table(rows, growth))
    return 0


def meshes(sizes, shared):
    """Yields (name, key in REFERENCE, mesh): generated meshes of the given sizes, then models if available."""
    for shape in line_meshes.SHAPES:
        for triangles in sizes:
            label = f"{triangles // 10**6}M" if triangles >= 10**6 else f"{triangles // 10**3}k"
            yield f"{shape} {label}", label, line_meshes.SHAPES[shape](triangles)
    for name, file in (("bunny", "stanford-bunny"), ("rocker arm", "rocker-arm")):
        path = shared / "models" / "organic" / f"{file}.obj" if shared else None
        if path and path.is_file():
            polygons = obj.read(path)
            yield name, name, line_meshes.Mesh(polygons.positions, polygons.corner_verts.reshape(-1, 3))


class Stopwatch:
    """Records wall and CPU time of each call, ms."""

    def __init__(self):
        self.wall, self.cpu = [], []

    def time(self, call):
        cpu, wall = time.process_time(), time.perf_counter()
        result = call()
        self.wall.append(1e3 * (time.perf_counter() - wall))
        self.cpu.append(1e3 * (time.process_time() - cpu))
        return result

    def less(self, other):
        """A Stopwatch with the differences to another's times, at least 0."""
        rest = Stopwatch()
        rest.wall = [max(a - b, 0.0) for a, b in zip(self.wall, other.wall)]
        rest.cpu = [max(a - b, 0.0) for a, b in zip(self.cpu, other.cpu)]
        return rest


def steps(native, name, mesh, views):
    """Yields (step, Stopwatch, number of pieces or paths, or None) for each measurement on one mesh."""
    surface = mesh.surface(native, name)
    for step, options in ESTIMATORS.items():
        fresh, watch = mesh.surface(native, name), Stopwatch()
        watch.time(lambda: fresh.fields(**options))
        yield step, watch, None
    surface.fields()
    eyes = eyes_around(mesh, views)
    for definition in STATIC:
        watch, pieces = finding(surface, definition, eyes[:3])
        yield f"{definition}: find, once", watch, pieces
    first = Stopwatch()
    first.time(lambda: surface.find_curves("apparent_ridge", {}, eyes[0], False))
    yield "first view", first, None
    tracers = [native.Tracer(*placed(native, surface, mesh, eye)) for eye in eyes]
    for definition in VIEW:
        found, pieces = finding(surface, definition, eyes)
        yield f"{definition}: find", found, pieces
        whole, paths = extracting(tracers, (definition,))
        yield f"{definition}: chain", whole.less(found), paths
    yield "together: find", sum_of(finding(surface, d, eyes)[0] for d in TOGETHER), None
    yield "together", *extracting(tracers, TOGETHER)
    yield f"kept {len(KEPT)}: per view", *extracting(tracers, KEPT)


def eyes_around(mesh, count):
    """Eye positions on an arc of 40 degrees around the mesh."""
    center, radius = mesh.sphere()
    turn = np.radians(np.linspace(-20, 20, count))
    x, y, z = TOWARDS
    directions = np.stack(
        [np.cos(turn) * x - np.sin(turn) * y, np.sin(turn) * x + np.cos(turn) * y, np.full(count, z)], 1
    )
    return [tuple(center + 5 * radius * direction) for direction in directions]


def placed(native, surface, mesh, eye):
    """(native Scene of the surface alone, native View from `eye`)."""
    usage = native.Usage.DRAW | native.Usage.OCCLUDE
    ids, usages = np.ones(1, np.uint64), np.full(1, usage, np.uint8)
    scene = native.Scene([surface], np.zeros(1, np.int32), np.eye(4)[None], ids, usages)
    return scene, native.View(*camera.view(mesh.positions, np.array(eye), False))


def finding(surface, definition, eyes):
    surface.find_curves(definition, {}, eyes[0], False)
    watch, counts = Stopwatch(), []
    for eye in eyes:
        counts.append(len(watch.time(lambda: surface.find_curves(definition, {}, eye, False))))
    return watch, int(statistics.median(counts))


def extracting(tracers, definitions):
    kinds = {definition: {} for definition in definitions}
    tracers[0].extract_paths(kinds)
    watch, counts = Stopwatch(), []
    for tracer in tracers:
        counts.append(len(watch.time(lambda: tracer.extract_paths(kinds))))
    return watch, int(statistics.median(counts))


def sum_of(watches):
    total = Stopwatch()
    watches = list(watches)
    total.wall = [sum(times) for times in zip(*(watch.wall for watch in watches))]
    total.cpu = [sum(times) for times in zip(*(watch.cpu for watch in watches))]
    return total


def row(mesh, triangles, step, watch, count, reference):
    ms, known = statistics.median(watch.wall), reference.get(step.split(":")[0]) if "chain" not in step else None
    return {
        "mesh": mesh,
        "triangles": triangles,
        "step": step,
        "ms": round(ms, 3),
        "cpu_ms": round(statistics.median(watch.cpu), 3),
        "count": count,
        "reference_ms": known and round(known, 3),
        "ratio": known and round(ms / known, 3),
    }


def exponents(rows):
    """Per shape and step: exponent of the growth of CPU time with the number of triangles, over the generated sizes."""
    points = defaultdict(list)
    for r in rows:
        shape, _, size = r["mesh"].rpartition(" ")
        if shape in line_meshes.SHAPES and r["cpu_ms"] > 0:
            points[shape, r["step"]].append((math.log(r["triangles"]), math.log(r["cpu_ms"])))
    return [
        {"shape": shape, "step": step, "exponent": round(float(np.polyfit(*zip(*p), 1)[0]), 2)}
        for (shape, step), p in points.items()
        if len(p) > 1
    ]


def table(rows, growth):
    lines = aligned([COLUMNS] + [tuple("" if r[c] is None else str(r[c]) for c in COLUMNS) for r in rows], (0, 2))
    columns = ("shape", "step", "exponent")
    return "\n".join([*lines, "", *aligned([columns] + [tuple(str(g[c]) for c in columns) for g in growth], (0, 1))])


def aligned(cells, left):
    widths = [max(len(line[k]) for line in cells) for k in range(len(cells[0]))]
    return [
        "  ".join(c.ljust(w) if k in left else c.rjust(w) for k, (c, w) in enumerate(zip(line, widths))).rstrip()
        for line in cells
    ]
