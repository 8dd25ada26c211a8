# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea bench scale`: blender -b -P worker.py -- JSON (scene, count, size, out).

Draws a frame with an engine that draws nothing, which is what a frame costs Blender itself; then Fovea's first frame,
and one after the camera has moved. Memory is that of the whole process; own_mb is the part of Fovea's frames above that
of Blender's. OUT is written after every frame, so that a timeout does not lose earlier results."""

import json
import math
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

import bpy
from bl_ext.user_default.fovea.render import session

from bench import worker
from bench.scale import builders


class Blank(bpy.types.RenderEngine):
    """Draws nothing."""

    bl_idname, bl_label = "BLANK", "Blank"

    def render(self, depsgraph):
        pass


def main(asked):
    bpy.ops.wm.read_homefile()
    builders.build(asked["scene"], asked["count"], asked["size"])
    bpy.context.view_layer.update()
    scene, out = bpy.context.scene, Path(asked["out"])
    bpy.utils.register_class(Blank)
    scene.render.engine = Blank.bl_idname
    worker.reset_peak()
    record = {"scene_mb": megabytes("VmRSS"), "blank_s": seconds(), "blank_mb": megabytes("VmHWM")}
    out.write_text(json.dumps(record))
    scene.render.engine, scene.fovea.backend = "FOVEA", "CPU"
    worker.reset_peak()
    for frame in ("first", "moved"):
        print(f"{frame} frame", flush=True)
        record[f"{frame}_s"] = seconds()
        told = session.last_statistics()
        record[f"{frame}_stages"] = {name: round(ms / 1000, 4) for name, ms in told["stages"].items()}
        record |= {"strokes": told["strokes"], "peak_mb": (peak := megabytes("VmHWM"))}
        record["own_mb"] = max(0, peak - record["blank_mb"])
        out.write_text(json.dumps(record))
        scene.camera.location.z *= 1.001


def seconds():
    """How long a render takes."""
    start = time.perf_counter()
    bpy.ops.render.render()
    return round(time.perf_counter() - start, 3)


def megabytes(field):
    return math.ceil(worker.memory(field) / 1024)


if __name__ == "__main__":
    main(json.loads(sys.argv[sys.argv.index("--") + 1]))
