# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea bench coherence`: blender -b -P worker.py -- JSON (scene, renderer, lines, anchor,
size, frames, shared, pictures, out). Draws the frames of a scene with motion forwards, some of them backwards and in
another order, and one alone in the scene built anew."""

import json
import sys
import time
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

import bpy
import numpy as np

from bench import coherence
from bench.coherence import drawers, measures, motions, pictures


@dataclass(frozen=True)
class View:
    """The camera of a frame."""

    world_to_view: np.ndarray  # (4, 4)
    view_to_clip: np.ndarray  # (4, 4)
    size: tuple  # pixels

    def to_pixels(self, world):
        """((n, 2) pixels from the lower left corner, (n,) depths) of (n, 3) points."""
        position = world @ self.world_to_view[:3, :3].T + self.world_to_view[:3, 3]
        clip = position @ self.view_to_clip[:, :3].T + self.view_to_clip[:, 3]
        return (clip[:, :2] / clip[:, 3:] + 1) / 2 * self.size, self.depth(position)

    def to_world(self, position):
        made = np.linalg.inv(self.world_to_view)
        return position @ made[:3, :3].T + made[:3, 3]

    def depth(self, position):
        return -position[:, 2]


def view_now():
    scene = bpy.context.scene
    size = scene.render.resolution_x, scene.render.resolution_y
    camera = scene.camera
    clip = camera.calc_matrix_camera(bpy.context.evaluated_depsgraph_get(), x=size[0], y=size[1])
    return View(np.array(camera.matrix_world.inverted()), np.array(clip), size)


def vertices_now():
    """(V, 3) vertices in world space of the meshes that move, in the order of their names."""
    graph, parts = bpy.context.evaluated_depsgraph_get(), []
    for obj in sorted(bpy.context.scene.objects, key=lambda each: each.name):
        if obj.type != "MESH" or not (obj.animation_data or any(m.type == "ARMATURE" for m in obj.modifiers)):
            continue
        mesh = obj.evaluated_get(graph).data
        points = np.empty((len(mesh.vertices), 3), np.float32)
        mesh.vertices.foreach_get("co", points.ravel())
        matrix = np.array(obj.matrix_world)
        parts.append(points @ matrix[:3, :3].T + matrix[:3, 3])
    return np.concatenate(parts) if parts else np.zeros((0, 3))


def carried(points, before, after):
    """Points that move as the nearest of the vertices `before`, which become those `after`."""
    if not len(before):
        return points
    moved = np.empty_like(points)
    square = (before**2).sum(axis=1)
    for first in range(0, len(points), 512):
        some = points[first : first + 512]
        nearest = (square - 2 * some @ before.T).argmin(axis=1)
        moved[first : first + 512] = some + after[nearest] - before[nearest]
    return moved


def main(asked):
    made = []
    for lines in asked["lines"]:
        row = measured(asked, lines)
        made.append({name: row[name] for name in coherence.COLUMNS})
        Path(asked["out"]).write_text(json.dumps(made))


def measured(asked, lines):
    """The row of a scene, a renderer and some kinds of lines."""
    drawer = built(asked, lines)
    steady, traces, seconds, drawn, vertices = measures.Steadiness(), {}, [], [], None
    for k in range(1, asked["frames"] + 1):
        print(f"{lines} lines, frame {k} of {asked['frames']}", flush=True)
        seconds.append(draw(drawer, k))
        view, last, vertices = view_now(), vertices, vertices_now()
        strokes = drawer.polylines(view)
        steady.see(strokes, lambda world: view.to_pixels(carried(world, last, vertices)))
        traces[k] = trace(drawer, strokes)
        drawn.append(strokes)
    if asked["pictures"]:
        name = f"{asked['scene']}-{lines}-{asked['renderer']}"
        pictures.write(drawn, asked["size"], Path(asked["pictures"]), name)
    return {
        "scene": asked["scene"], "renderer": asked["renderer"], "lines": lines, "window": 0,
        "pure": is_pure(asked, lines, drawer, traces), "frame_s": round(float(np.median(seconds)), 4),
        **steady.figures(),
    }  # fmt: skip


def built(asked, lines):
    bpy.ops.wm.read_homefile()  # clears caches, too, that renderers keep between frames
    motions.build(asked["scene"], asked["frames"], Path(asked["shared"]) if asked["shared"] else None)
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = asked["size"]
    drawer = drawers.make(asked["renderer"], scene, asked["anchor"])
    drawer.lines(coherence.LINES[lines])
    return drawer


def draw(drawer, frame):
    """Seconds that a frame takes, the scene's evaluation included."""
    start = time.perf_counter()
    bpy.context.scene.frame_set(frame)
    drawer.frame()
    return time.perf_counter() - start


def trace(drawer, strokes):
    """Hash of what was drawn: of the picture, where there is one."""
    return drawer.trace() if hasattr(drawer, "trace") else drawers.hashed(strokes.offsets, strokes.world)


def is_pure(asked, lines, drawer, traces):
    """Whether frames drawn backwards, in another order, and alone are those drawn forwards."""
    some = sorted(traces)[:: max(1, len(traces) // 3)]
    for frame in some[::-1] + some[1::2] + some[::2]:
        draw(drawer, frame)
        if trace(drawer, drawer.polylines(view_now())) != traces[frame]:
            return False
    alone = built(asked, lines)
    draw(alone, some[len(some) // 2])
    return trace(alone, alone.polylines(view_now())) == traces[some[len(some) // 2]]


if __name__ == "__main__":
    try:
        main(json.loads(sys.argv[sys.argv.index("--") + 1]))
    except (RuntimeError, ImportError, AttributeError, TypeError, ValueError) as error:  # missing features
        sys.exit(f"Error: {error}")
