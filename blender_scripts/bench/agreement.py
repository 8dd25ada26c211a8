"""Runs inside Blender for `fovea bench agreement`: how far depth-buffer visibility agrees with exact visibility.

blender -b -P agreement.py -- SCENE SHARED OUT.json: one frame at the scene's own size, every atlas sample judged both ways.
"""

import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import bpy
import numpy as np
import scenes
from bl_ext.user_default.fovea import native, pipeline
from bl_ext.user_default.fovea.backend import cpu

SCALES = (1, 2)
NEAR_SAMPLES = 1  # 2 px at the default step


def main(spec, shared, out):
    bpy.ops.wm.read_homefile()
    scenes.build(spec, Path(shared) if shared else None)
    bpy.context.scene.render.engine = "FOVEA"
    rows = []

    def both_ways(frame, backend, options, cancel):
        runs = cpu.exact(frame, cancel)
        exact = native.load().samples_from_runs(frame.clipped, runs) >= 0.5
        for scale in SCALES:
            depth = native.load().draw_depth(frame.scene, frame.view, scale)
            rows.append({"scene": spec, "depth_scale": scale, **compare(frame, depth, exact)})
        return runs

    pipeline.visibility = both_ways
    bpy.ops.render.render()
    Path(out).write_text(json.dumps(rows))


def compare(frame, depth, exact):
    """Shares among all samples."""
    clipped = frame.clipped
    sampled = native.load().sampled_visibility(clipped, depth, frame.probes) >= 0.5
    real = own_samples(clipped)
    wrong = (sampled != exact) & real
    return {
        "samples": int(real.sum()),
        "agree": 1 - wrong.sum() / real.sum(),
        "falsely_hidden": (wrong & exact).sum() / real.sum(),
        "falsely_visible": (wrong & ~exact).sum() / real.sum(),
        "near_a_change_of_its_path": (wrong & near_change(exact)).sum() / max(wrong.sum(), 1),
    }


def own_samples(clipped):
    """Atlas samples of segments, without padding."""
    marks = np.zeros(clipped.samples + 1, np.int32)
    np.add.at(marks, clipped.sample_start, (clipped.sample_count > 0).astype(np.int32))
    np.add.at(marks, clipped.sample_start + clipped.sample_count, -(clipped.sample_count > 0).astype(np.int32))
    return np.cumsum(marks[:-1]) > 0


def near_change(exact):
    """Samples within NEAR_SAMPLES of one that is judged otherwise."""
    near = np.zeros_like(exact)
    for step in range(1, NEAR_SAMPLES + 1):
        changes = exact[step:] != exact[:-step]
        near[step:] |= changes
        near[:-step] |= changes
    return near


if __name__ == "__main__":
    main(*sys.argv[sys.argv.index("--") + 1 :])
