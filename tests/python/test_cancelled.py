# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures that are cancelled at any moment, on all threads, in a process of their own: none of them ends it."""

import subprocess
import sys
import threading

import numpy as np
from native_core import core, scene, surface, view

from addon import pipeline, style


def wavy_grid(side=100):
    n = np.arange(side * side, dtype=np.int32).reshape(side, side)
    verts = np.stack([n[:-1, :-1], n[:-1, 1:], n[1:, 1:], n[1:, :-1]], -1).ravel()
    offsets = np.arange(0, verts.size + 1, 4, dtype=np.int32)
    x, y = np.meshgrid(*[np.linspace(-1, 1, side)] * 2)
    positions = np.stack([x, y, 0.1 * np.sin(9 * x) * np.cos(7 * y)], -1).reshape(-1, 3).astype(np.float32)
    edges = core.PolygonEdges(offsets, verts)
    arrays = {"positions": positions, "edge_verts": edges.edge_verts, "corner_verts": verts}
    return surface("grid", arrays | {"corner_edges": edges.corner_edges, "polygon_offsets": offsets})


def draw_and_cancel(stage, wait):
    """A picture of a new surface, cancelled so many seconds after a stage has begun; or whole, if it was quicker."""
    cancel = core.Cancel()

    def progress(share, begun):
        if begun == stage:
            threading.Timer(wait, cancel.cancel).start()

    placed, camera = scene([wavy_grid()], np.eye(4)[None]), view((0, -4, 3), (0, 0, 0), size=(640, 360))
    words = {"cancel": cancel, "progress": progress}
    frame = pipeline.frame(placed, camera, style.load("pen_and_ink"), core.CpuBackend(), pipeline.options(), **words)
    try:
        with cancel:
            frame.picture()
    except core.Cancelled:
        pass


def test_cancelling_ends_no_process():
    """Embree keeps a context of the parallel loop that it builds a BVH in; who cancels must not meet the end of it."""
    path = [entry for entry in sys.path if entry]
    script = f"import sys; sys.path[:0] = {path!r}; import test_cancelled; test_cancelled.cancel_often()"
    ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr[-2000:]


def cancel_often():
    for stage in ("lines", "visibility", "elision", "strokes"):
        for wait in (0.0, 0.02, 0.05, 0.1):
            draw_and_cancel(stage, wait)
