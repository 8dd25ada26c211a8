# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea bench visibility`: blender -b -P worker.py -- JSON (scene, methods, frames, size,
shared, out).

Everything runs inside one render, where there is a GPU context. OUT is written after every method, so that a later
failure does not lose earlier results."""

import json
import math
import sys
from dataclasses import dataclass, replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

import bpy
import numpy as np
import scenes
from bl_ext.user_default.fovea import native, pipeline
from bl_ext.user_default.fovea.scene import camera, scene
from bl_ext.user_default.fovea.style import style_data
from mathutils import Matrix, Vector

from bench.visibility import methods, quality

STEP = math.radians(1)
LINES = ("contour", "crease", "border")


@dataclass(frozen=True)
class World:
    """The scene as passed to the pipeline."""

    placed: object  # native Scene
    object_to_world: np.ndarray  # (n, 4, 4) float64

    def seen(self, view):
        """The native View of a stages.View."""
        return scene.seen(native.load(), view)


def main(asked):
    bpy.ops.wm.read_homefile()
    scenes.build(asked["scene"], Path(asked["shared"]) if asked["shared"] else None)
    set_drawing(bpy.context.scene, asked["size"])
    pivot, kept = middle(bpy.context.scene), {}
    draw = pipeline.draw

    def measured(placed, seen, style, backend, options, **watching):
        if "snapshot" not in kept:  # the GPU is tried before the scene is read
            return draw(placed, seen, style, backend, options, **watching)
        pipeline.draw = draw
        world = World(placed, kept["snapshot"].object_to_world)
        run(world, orbit(kept["view"], pivot, asked["frames"]), style, options, asked)
        return draw(placed, seen, style, native.load().CpuBackend(), options, **watching)

    camera.of_render = remembering(kept, "view", camera.of_render)
    scene.gather = remembering(kept, "snapshot", scene.gather)
    pipeline.draw = measured
    bpy.ops.render.render()


def remembering(kept, name, function):
    """Wraps a function to store its last result in kept[name]."""

    def call(*arguments, **named):
        kept[name] = function(*arguments, **named)
        return kept[name]

    return call


def middle(scene_):
    """Center of the bounding box of all meshes, world space."""
    corners = np.array(
        [obj.matrix_world @ Vector(c) for obj in scene_.objects if obj.type == "MESH" for c in obj.bound_box]
    )
    return (corners.min(axis=0) + corners.max(axis=0)) / 2


def set_drawing(scene_, size):
    scene_.render.engine = "FOVEA"
    scene_.render.resolution_x, scene_.render.resolution_y = size
    scene_.render.resolution_percentage = 100
    held = style_data.own(scene_)
    style_data.choose_lines(held, LINES)
    held.elision.enabled = False  # the spine test has none: every method draws the same lines


def orbit(view, pivot, frames, step=STEP, more=0):
    """Views rotated about the vertical axis through the pivot in steps of `step` radians; `more`: additional views
    before and after."""
    views = []
    for k in range(-more, frames + more):
        turn = np.array(Matrix.Rotation(k * step, 4, "Z"))
        turn[:3, 3] = pivot - turn[:3, :3] @ pivot
        views.append(replace(view, world_to_view=view.world_to_view @ turn))
    return views


def run(world, views, style, options, asked):
    judge, rows = quality.Judge(), []
    for name in ("exact", *[name for name in asked["methods"] if name != "exact"]):
        method = methods.make(name, world, style, options)
        told = [method.frame(view) for view in views[:1] + views][1:]  # the first one compiles and uploads
        disagree, flicker = judge.compare(name, told)
        if name not in asked["methods"]:
            continue
        stages = {stage: round(float(np.mean([frame.stages[stage] for frame in told])), 2) for stage in told[0].stages}
        rows.append({
            "scene": asked["scene"],
            "method": name,
            "segments": told[0].segments,
            "samples": told[0].samples,
            "fps": round(1000 / sum(stages.values()), 2),
            "stages": stages,
            "disagree": disagree,
            "flicker": flicker,
        })  # fmt: skip
        Path(asked["out"]).write_text(json.dumps(rows))


if __name__ == "__main__":
    main(json.loads(sys.argv[sys.argv.index("--") + 1]))
