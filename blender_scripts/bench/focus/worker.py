# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea bench focus`: blender -b -P worker.py -- JSON (part, scene, size, distance, frames,
places, shared, out)."""

import json
import math
import sys
import time
from functools import partial
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

import bpy
import numpy as np
import scenes
from bl_ext.user_default.fovea import gaze, native, style
from bl_ext.user_default.fovea.render import gpu_context

from bench.focus import PER_ATLAS_SAMPLE, PER_SAMPLE, coherence, density, emphasis, salience, world
from bench.visibility.worker import middle, orbit

STEP = math.radians(0.25)
REPEATS = 3


def main(asked):
    bpy.ops.wm.read_homefile()
    scenes.build(asked["scene"], Path(asked["shared"]) if asked["shared"] else None)
    rows = PARTS[asked["part"]](asked)
    Path(asked["out"]).write_text(json.dumps(rows))


def density_rows(asked):
    def work(place):
        return density.rows(asked["scene"], place.draw(world.evenly_spaced(asked["distance"])), asked["distance"])

    return world.measure(work, asked["size"])


def coherence_rows(asked):
    pivot = middle(bpy.context.scene)

    def work(place):
        distance, most = asked["distance"] * place.view.reference_scale, max(asked["smoothed"], default=0)
        watches = {frames: coherence.Static(distance) for frames in (0, *asked["smoothed"])}
        in_time = [coherence.InTime(frames, watch) for frames, watch in watches.items()]
        of_view, style = coherence.OfView(distance), world.evenly_spaced(asked["distance"])
        # Starts before and ends after the measured frames, as the widest temporal filter needs.
        for k, view in enumerate(orbit(place.view, pivot, asked["frames"], STEP, most), start=-most):
            drawn = place.draw(style, view)
            for each in in_time:
                if -each.frames <= k < asked["frames"] + each.frames:
                    each.see(drawn)
            if 0 <= k < asked["frames"]:
                of_view.see(drawn)
        return coherence.rows(asked["scene"], watches.pop(0), watches, of_view)

    return world.measure(work, asked["size"], named="pen_and_ink")


def emphasis_rows(asked):
    return world.measure(lambda place: emphasis.rows(asked["scene"], place, asked["places"]), asked["size"])


def salience_rows(asked):
    def work(place):
        return salience.rows(asked["scene"], place, asked["places"])

    return world.measure(work, gaze.frame_size(*asked["size"]))


def cost_rows(asked):
    render = bpy.context.scene.render
    render.engine = "BLENDER_WORKBENCH"
    render.resolution_x, render.resolution_y, render.resolution_percentage = *asked["size"], 100
    workbench = median_ms(bpy.ops.render.render)
    return world.measure(partial(stage_costs, asked["scene"], workbench), asked["size"])


def stage_costs(scene, workbench, place):
    """Rows of stage costs for watercolor, which has all color effects, with focus in the middle of the image."""
    middle_ = style.Focus(model="image", points=(style.FocusPlace(at=(0.5, 0.5, 0.0), near=0.1, far=0.6),))
    chosen = world.named_style("watercolor").replace(focus=middle_)
    told, backends = [("Workbench, ms a frame", workbench, None)], [native.load().CpuBackend()]
    if gpu_context.available():
        from bl_ext.user_default.fovea.gpu import backend as gpu

        backends.append(gpu.Backend())
    for backend in backends:
        place.draw(chosen, backend=backend)  # warm-up: compiles shaders
        drawn = [place.draw(chosen, backend=backend) for _ in range(REPEATS)]
        elision, colors = (stage_ms(drawn, name) for name in ("elision", "focus"))
        told += [(f"elision, {backend.name}, of Workbench's frame", elision / workbench, "<= .15")]
        if backend.name == "cpu":
            told += [("effects of color, of Workbench's frame", colors / workbench, "<= .2")]
            told += [(PER_SAMPLE, 1000 * elision / max(len(drawn[-1].places().index), 1), None)]
            told += [(PER_ATLAS_SAMPLE, 1000 * elision / max(drawn[-1].frame.clipped.samples, 1), None)]
    return [{"figure": figure, "scene": scene, "value": value, "wanted": wanted} for figure, value, wanted in told]


def stage_ms(drawn, name):
    return float(np.median([each.image.statistics["stages"][name] for each in drawn]))


def median_ms(work):
    """Median time of REPEATS calls, after a warm-up call."""
    times = []
    for _ in range(REPEATS + 1):
        start = time.perf_counter()
        work()
        times.append(1000 * (time.perf_counter() - start))
    return float(np.median(times[1:]))


PARTS = {
    "density": density_rows,
    "coherence": coherence_rows,
    "cost": cost_rows,
    "emphasis": emphasis_rows,
    "salience": salience_rows,
}

if __name__ == "__main__":
    main(json.loads(sys.argv[sys.argv.index("--") + 1]))
