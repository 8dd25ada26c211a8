# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea bench peers`: blender -b -P worker.py -- JSON (scene, renderer, size, repeats, shared,
out).

Each repeat starts from a new file: the first frame, then one after a small turn of the camera. A cold round precedes
them: it measures memory and compiles shaders. With one repeat the cold round is measured, after shaders were compiled
by a tiny picture of a box. Slow renderers draw only the first frame of the cold round: Freestyle compiles in every
render anyway. OUT is written after every frame, so that a timeout does not lose earlier results; each frame is
announced on stdout."""

import json
import math
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import bpy
import scenes
from mathutils import Matrix

from bench import renderers

STEP = math.radians(1)


def main(asked):
    make = renderers.BY_NAME[asked["renderer"]]
    repeats, kinds = (1, ("first",)) if make.is_slow else (asked["repeats"], ("first", "moved"))
    if repeats == 1 and not make.is_slow:
        warm(make)
    record = {"first": [], "moved": []}
    rounds = (True, *[False] * repeats) if repeats > 1 else (True,)
    for number, cold in enumerate(rounds, start=1):
        bpy.ops.wm.read_homefile()  # also clears caches that renderers keep between frames
        scenes.build(asked["scene"], Path(asked["shared"]) if asked["shared"] else None)
        render = bpy.context.scene.render
        render.resolution_x, render.resolution_y = asked["size"]
        renderer = make(bpy.context.scene)
        if cold:
            record["triangles"] = triangles()
            reset_peak()
            before = memory("VmRSS")
        for kind in kinds:
            print(f"round {number} of {len(rounds)}, {kind} frame", flush=True)
            told = frame(renderer, moved=kind == "moved")
            if repeats == 1 or not cold:
                record[kind].append(told)
            if cold:
                record["peak_mb"] = (memory("VmHWM") - before) / 1024
            Path(asked["out"]).write_text(json.dumps(record))


def frame(renderer, moved: bool):
    camera = bpy.context.scene.camera
    if moved:
        camera.matrix_world = Matrix.Rotation(STEP, 4, "Z") @ camera.matrix_world
    start = time.perf_counter()
    renderer.frame()
    return {"wall_s": time.perf_counter() - start, **renderer.told()}


def warm(renderer):
    """Compiles shaders, by a small picture of a box."""
    print("what is compiled once", flush=True)
    bpy.ops.wm.read_homefile()
    scenes.build("boxes:1", None)
    bpy.context.scene.render.resolution_percentage = 5
    renderer(bpy.context.scene).frame()


def triangles() -> int:
    """Number of triangles in the scene, with each instance counted."""
    depsgraph = bpy.context.evaluated_depsgraph_get()
    meshes = (instance.object.data for instance in depsgraph.object_instances if instance.object.type == "MESH")
    return sum(len(mesh.loop_triangles) for mesh in meshes)


def memory(field: str) -> int:
    """A field of /proc/self/status, kB."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith(field + ":"))


def reset_peak():
    """Resets the peak VmHWM. If the kernel refuses, the peak of building the scene may hide that of the renderer."""
    try:
        Path("/proc/self/clear_refs").write_text("5")
    except OSError as refusal:
        print(f"peak memory includes building the scene: {refusal}", file=sys.stderr)


if __name__ == "__main__":
    try:
        main(json.loads(sys.argv[sys.argv.index("--") + 1]))
    except (RuntimeError, ImportError, AttributeError, TypeError) as error:  # missing features; shown in the table
        sys.exit(f"Error: {error}")
