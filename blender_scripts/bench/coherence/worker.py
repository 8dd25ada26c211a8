# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea bench coherence`: blender -b -P worker.py -- JSON (scene, renderer, lines, anchor,
window, marks, size, frames, shared, pictures, out). Draws the frames of a scene with motion forwards, some of them
backwards and in another order, and one alone in the scene built anew."""

import json
import sys
import time
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

import bpy
import numpy as np
from mathutils.bvhtree import BVHTree

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


@dataclass(frozen=True)
class Surfaces:
    """All meshes of a frame in world space, in the order of their names."""

    points: np.ndarray  # (V, 3)
    triangles: np.ndarray  # (T, 3) of points


def surfaces_now():
    """The Surfaces of the scene; None if none of them moves."""
    graph, parts, count = bpy.context.evaluated_depsgraph_get(), [], 0
    meshes = sorted((obj for obj in bpy.context.scene.objects if obj.type == "MESH"), key=lambda each: each.name)
    if not any(obj.animation_data or any(m.type == "ARMATURE" for m in obj.modifiers) for obj in meshes):
        return None
    for obj in meshes:
        mesh = obj.evaluated_get(graph).data
        mesh.calc_loop_triangles()
        points = np.empty((len(mesh.vertices), 3), np.float32)
        triangles = np.empty((len(mesh.loop_triangles), 3), np.int32)
        mesh.vertices.foreach_get("co", points.ravel())
        mesh.loop_triangles.foreach_get("vertices", triangles.ravel())
        matrix = np.array(obj.matrix_world)
        parts.append((points @ matrix[:3, :3].T + matrix[:3, 3], triangles + count))
        count += len(points)
    return Surfaces(*map(np.concatenate, zip(*parts)))


def carried(points, before, after):
    """Points (n, 3) that move as the nearest triangles of the Surfaces `before`, which become those `after`; None:
    nothing moves."""
    if before is None or not len(points):
        return points
    tree = BVHTree.FromPolygons(before.points.tolist(), before.triangles.tolist())
    nearest = before.triangles[[tree.find_nearest(point)[2] for point in points.tolist()]].T
    return measures.carried(points, before.points[nearest], after.points[nearest])


def main(asked):
    made = []
    for lines in asked["lines"]:
        row = measured(asked, lines)
        made.append({name: row[name] for name in coherence.COLUMNS})
        Path(asked["out"]).write_text(json.dumps(made))


def measured(asked, lines):
    """The row of a scene, a renderer and some kinds of lines."""
    drawer = built(asked, lines)
    steady, traces, seconds, drawn, surfaces = measures.Steadiness(), {}, [], [], None
    for k in range(1, asked["frames"] + 1):
        print(f"{lines} lines, frame {k} of {asked['frames']}", flush=True)
        seconds.append(draw(drawer, k))
        view, last, surfaces = view_now(), surfaces, surfaces_now()
        strokes = drawer.polylines(view)
        steady.see(strokes, lambda world: view.to_pixels(carried(world, last, surfaces)))
        traces[k] = trace(drawer, strokes)
        drawn.append(strokes)
    if asked["pictures"]:
        name = f"{asked['scene']}-{lines}-{asked['renderer']}"
        pictures.write(drawn, asked["size"], Path(asked["pictures"]), name)
    return {
        "scene": asked["scene"], "renderer": asked["renderer"], "lines": lines,
        "window": asked["window"], "marks": marks_of(asked, lines),
        "pure": is_pure(asked, lines, drawer, traces), "frame_s": round(float(np.median(seconds)), 4),
        **steady.figures(dashed=coherence.LINES[lines].dashed),
    }  # fmt: skip


def built(asked, lines):
    bpy.ops.wm.read_homefile()  # clears caches, too, that renderers keep between frames
    motions.build(asked["scene"], asked["frames"], Path(asked["shared"]) if asked["shared"] else None)
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = asked["size"]
    drawer = drawers.make(asked["renderer"], scene, asked["anchor"], asked["window"], marks_of(asked, lines))
    drawer.lines(coherence.LINES[lines])
    return drawer


def marks_of(asked, lines):
    """Frames over which marks are handed on: those of lines of the mesh need no others."""
    return asked["marks"] if coherence.LINES[lines].of_view else 0


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
