# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea bench over`: what lines over another engine's render cost beside that render.

blender -b -P over.py -- OUT.json WORDS, the words of `fovea draw` with --over: a row with medians of REPEATS rounds, in
seconds of all processors (`cpu`), which other programs disturb little, and of the clock (`wall`): `photo` is the render
without lines, `both` with them, `lines` what Fovea does of that, `evaluation` one more evaluation of the scene, as a
render does it. `beyond`: the share of `both` that is beyond photo, lines and evaluation."""

import json
import sys
import time
from pathlib import Path
from statistics import median

sys.path.insert(0, str(Path(__file__).parents[1]))

import bpy
import draw
import drawing_settings
import ending
import over
import scene_source
from bl_ext.user_default.fovea.render import as_rendered, lines_over, session
from command import draw_options

REPEATS = 5
CLOCKS = {"cpu": time.process_time, "wall": time.perf_counter}


def timed(act):
    """{clock: seconds} of a function without arguments."""
    start = {name: clock() for name, clock in CLOCKS.items()}
    act()
    return {name: clock() - start[name] for name, clock in CLOCKS.items()}


def of_lines(act):
    """Times of `act`, and of what Fovea renders meanwhile."""
    inside, render = [], session.render

    def watched(*arguments, **words):
        inside.append(timed(lambda: render(*arguments, **words)))

    session.render = watched
    try:
        whole = timed(act)
    finally:
        session.render = render
    return whole, {name: sum(each[name] for each in inside) for name in CLOCKS}


def measured(words):
    options = draw_options.parse(words)
    scene_source.open_scene(options.scene)
    scene = bpy.context.scene
    draw.set_size(scene, options)
    draw.set_camera(scene, options)
    drawing_settings.set_drawing(scene, options)
    over.set_up(scene, options)
    lines_over.remove(scene)
    rounds = [measure(scene) for _ in range(REPEATS + 1)][1:]  # the first one fills caches
    row = {"scene": options.scene, "engine": options.over, "size": list(options.size)}
    for clock in CLOCKS:
        row |= {f"{name}_{clock}_s": round(median(r[name][clock] for r in rounds), 4) for name in rounds[0]}
        parts = sum(row[f"{name}_{clock}_s"] for name in ("photo", "lines", "evaluation"))
        row[f"beyond_{clock}"] = round(1 - parts / row[f"both_{clock}_s"], 4)
    return row


def measure(scene):
    """{part: {clock: seconds}} of one round."""
    photo = timed(bpy.ops.render.render)
    evaluation = timed(lambda: as_rendered.look(bpy.context, lambda *_: None))
    lines_over.put(scene)
    both, lines = of_lines(bpy.ops.render.render)
    lines_over.remove(scene)
    return {"photo": photo, "evaluation": evaluation, "both": both, "lines": lines}


def main(out, *words):
    Path(out).write_text(json.dumps(measured(words)) + "\n")


if __name__ == "__main__":
    ending.run(lambda words: main(*words))
