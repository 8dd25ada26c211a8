# SPDX-License-Identifier: GPL-3.0-or-later
"""Too little memory is a MemoryError, whichever part of the core finds it, and nothing else."""

import os
import subprocess
import sys

SCRIPT = """
import resource
from pathlib import Path
import numpy as np
from native_core import core, pipeline, scene, surface, view

SIDE = 400
numbers = np.arange(SIDE * SIDE, dtype=np.int32).reshape(SIDE, SIDE)
quads = np.stack([numbers[:-1, :-1], numbers[:-1, 1:], numbers[1:, 1:], numbers[1:, :-1]], axis=-1).reshape(-1, 4)
x, y = np.meshgrid(np.linspace(-1, 1, SIDE), np.linspace(-1, 1, SIDE))
positions = np.stack([x, y, np.sin(4 * x) * np.cos(4 * y)], axis=-1).reshape(-1, 3).astype(np.float32)
offsets = np.arange(0, quads.size + 1, 4, dtype=np.int32)
verts = quads.ravel()
edges = core.PolygonEdges(offsets, verts)
arrays = {"positions": positions, "edge_verts": edges.edge_verts, "corner_verts": verts}
arrays |= {"corner_edges": edges.corner_edges, "polygon_offsets": offsets}
style = pipeline.style_of_lines({"contour": {}}, 60.0, False)

def draw():
    placed = scene([surface("grid", arrays)], np.eye(4)[None])
    return pipeline.draw(placed, view((0, -4, 3), (0, 0, 0)), style, core.CpuBackend(), pipeline.options())

def used():
    return int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()

told = set()
draw()  # threads that cannot be started would be waited for
for megabytes in [*range(0, 32, 2), 4000]:
    resource.setrlimit(resource.RLIMIT_AS, (used() + (megabytes << 20), resource.RLIM_INFINITY))
    try:
        draw()
    except MemoryError as error:
        told.add(str(error))
    else:
        told.add("drawn")
print(sorted(told))
"""


def test_whatever_memory_there_is_a_picture_is_drawn_or_memory_is_too_small():
    paths = os.pathsep.join([os.path.dirname(__file__), os.environ.get("PYTHONPATH", "")])
    command = [sys.executable, "-c", SCRIPT]
    done = subprocess.run(command, env=os.environ | {"PYTHONPATH": paths}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-2000:]
    assert done.stdout.strip() == "['drawn', 'std::bad_alloc']"
