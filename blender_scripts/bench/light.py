# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea bench light`: what lines, shade and shadows by light cost in a first frame.

blender -b -P light.py -- JSON (scenes, repeats, size, out): a row per scene, with medians of `repeats` rounds, in
seconds of the clock. Scenes have a sun; the office two lamps, too. `lines_s`: the stages of contours, creases and
borders, from Blender's meshes to runs; `light_contour_s`, `cast_shadow_s`, `hatching_s`: how much longer these are with
that definition; `shade_s`: with two sets of lines, one lit and one in shade; `colors_s`: the color layer in smooth
shading, `shadow_s` and `blacks_s`: how much longer it takes with them.

Grids of boxes are drawn by Line Art, too, which makes no picture: `line_art_s` without light, `line_art_shadow_s` with
shadows, `line_art_light_s` with light contours, too. `fovea_light_s`: the stages of Fovea's lines with both;
`ratio_shadow` and `ratio_light`: medians over the rounds of Line Art's time by that of the stages of Fovea's lines, all
lines included. Each variant is drawn in each round, one after the other."""

import json
import sys
import tempfile
from pathlib import Path
from statistics import median

sys.path.insert(0, str(Path(__file__).parents[1]))

import bpy
import ending
import scenes
from bl_ext.user_default.fovea.style import style_data
from scenes import stage

from bench import renderers, worker

LAMPS = ((3, 4, 2.3), (12, 5, 11.3))  # in two rooms of the office
DEFINITIONS = "light_contour", "cast_shadow", "hatching"


def build(spec, shared, path):
    """Writes the scene with the lights that are measured."""
    bpy.ops.wm.read_homefile()
    scenes.build(spec, shared)
    for obj in [obj for obj in bpy.data.objects if obj.type == "LIGHT"]:
        bpy.data.objects.remove(obj)
    stage.sun(-115, 48)
    for place in LAMPS if scenes.parse(spec)[0] == "office" else ():
        lamp = bpy.data.lights.new("Lamp", "POINT")
        lamp.energy, lamp.shadow_soft_size = 250, 0.1
        stage.link("Lamp", lamp).location = place
    bpy.ops.wm.save_as_mainfile(filepath=str(path))


class Drawn(renderers.Fovea):
    """Fovea with more definitions, sets by light, or colors."""

    def __init__(self, scene, definitions=(), by_light=False, **color):
        super().__init__(scene)
        held = style_data.own(scene)
        style_data.choose_lines(held, [*renderers.LINES, *definitions])
        if by_light:
            bpy.ops.fovea.line_set_duplicate()
            for line_set, light in zip(held.line_sets, ("LIT", "SHADED")):
                line_set.light = light
        for name, value in color.items():
            setattr(held.color, name, value)


class LineArtByLight(renderers.LineArt):
    """With shadows of the sun, and light contours."""

    def __init__(self, scene, contours=True):
        super().__init__(scene)
        self.modifier.light_contour_object = next(obj for obj in scene.objects if obj.type == "LIGHT")
        self.modifier.use_light_contour, self.modifier.use_shadow = contours, True


FOVEA = {  # variant -> (arguments of Drawn, which of its times is told, the variant that is subtracted)
    "lines": ({}, "lines", None),
    **{name: ({"definitions": [name]}, "lines", "lines") for name in DEFINITIONS},
    "shade": ({"by_light": True}, "lines", "lines"),
    "fovea_light": ({"definitions": DEFINITIONS[:2]}, "lines", None),
    "colors": ({"shading": "SMOOTH"}, "color", None),
    "shadow": ({"shading": "SMOOTH", "shadow": 1.0}, "color", "colors"),
    "blacks": ({"shading": "FLAT", "blacks": 0.16}, "color", "colors"),
}
LINE_ART = {
    "line_art": renderers.LineArt,
    "line_art_shadow": lambda scene: LineArtByLight(scene, contours=False),
    "line_art_light": LineArtByLight,
}
RATIOS = {"ratio_shadow": ("line_art_shadow", "cast_shadow"), "ratio_light": ("line_art_light", "fovea_light")}


def measure(path, size, make):
    """{part: seconds} of a first frame."""
    bpy.ops.wm.open_mainfile(filepath=str(path))
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = size
    told = worker.frame(make(scene), moved=False)
    stages = told.get("stages", {})
    runs, color = (stages.get(name, 0.0) / 1000 for name in ("runs", "color"))
    return {"lines": told.get("lines_s", 0.0) + runs, "color": color, "wall": told["wall_s"]}


def measured(spec, shared, size, repeats, path):
    build(spec, shared, path)
    rounds = []
    for number in range(repeats + 1):  # the first one fills caches
        times = {}
        for name, (arguments, which, _) in FOVEA.items():
            times[name] = measure(path, size, lambda scene, given=arguments: Drawn(scene, **given))[which]
        for name, make in LINE_ART.items() if spec.startswith("boxes") else ():
            times[name] = measure(path, size, make)["wall"]
        print(f"{spec}, round {number}: {times}", flush=True)
        rounds.append(times)
    del rounds[0]
    row = {"scene": spec, "lights": sum(obj.type == "LIGHT" for obj in bpy.data.objects)}
    for name, (_, _, less) in FOVEA.items():
        row[f"{name}_s"] = round(median(each[name] - (each[less] if less else 0.0) for each in rounds), 4)
    if "line_art" in rounds[0]:
        row |= {f"{name}_s": round(median(each[name] for each in rounds), 4) for name in LINE_ART}
        row |= {name: round(median(each[a] / each[b] for each in rounds), 2) for name, (a, b) in RATIOS.items()}
    return row


def main(asked):
    with tempfile.TemporaryDirectory() as folder:
        shared = Path(asked["shared"]) if asked["shared"] else None
        rows = [
            measured(spec, shared, asked["size"], asked["repeats"], Path(folder) / "lit.blend")
            for spec in asked["scenes"]
        ]
    Path(asked["out"]).write_text("[" + ",\n ".join(json.dumps(row) for row in rows) + "]\n")


if __name__ == "__main__":
    ending.run(lambda words: main(json.loads(words[0])))
