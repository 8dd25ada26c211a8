# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs inside Blender for `fovea study make`: JSON of what is asked (command/study.py). Draws a scene in several
styles, and finds places for gauges and the normals that they should show there."""

import json
import sys
from functools import partial
from pathlib import Path

import bpy
import numpy as np
from bl_ext.user_default.fovea import native, pipeline
from bl_ext.user_default.fovea.render import as_rendered, reading
from bl_ext.user_default.fovea.scene import camera
from bl_ext.user_default.fovea.scene import scene as placed

sys.path.insert(0, str(Path(__file__).parent))

import draw
import drawing_settings
import ending
import over
import picture
from command import draw_options
from gauges import formulas

CLEAR, CLEAR_OF_STRING = 6.0, 2.0  # pixels at a height of 768 around a gauge that are one surface
MOST_TRIED = 200  # places for each gauge that is wanted
GRAY, PAPER = (0.7, 0.7, 0.7), (1.0, 1.0, 1.0)  # of shaded pictures


def main(words):
    asked = json.loads(words[0])
    options = draw_options.parse([*asked["draw"], "--style", "plain"])
    scene = draw.opened(options)
    drawing_settings.set_drawing(scene, options)
    draw.set_output(scene, options)
    found = gauges(scene, asked["gauges"], asked["seed"])
    add_strings(scene, asked["strings"], found)
    for style, path in asked["pictures"].items():
        render(scene, draw_options.parse([*asked["draw"], *asked["styles"][style]]), path, style == asked["shaded"])
    found["blender"] = bpy.app.version_string
    Path(asked["out"]).write_text(json.dumps(found), encoding="utf-8")


def render(scene, options, path, shaded):
    """Renders a picture in a style, or in gray, shaded by the lamps of Workbench's studio."""
    world = scene.world
    if shaded:
        over.set_engine(scene, "workbench")
        shading = scene.display.shading
        shading.light, shading.color_type, shading.single_color = "STUDIO", "SINGLE", GRAY
        shading.show_shadows = shading.show_cavity = shading.show_object_outline = False
        scene.world = bpy.data.worlds.new("Paper")
        scene.world.color = PAPER
    else:
        drawing_settings.set_drawing(scene, options)
    picture.render(scene, Path(path))
    scene.world = world


def gauges(scene, count, seed):
    """{gauges: [{x, y, n, object}], tried: how many places were}. ValueError where the scene has too few places."""
    width, height = scene.render.resolution_x, scene.render.resolution_y
    first, most = formulas.SKIP + seed * MOST_TRIED * count, MOST_TRIED * count
    places = formulas.places(first, most, (width, height))
    look = partial(seen, px=places * (1, -1) + (0, height), radius=CLEAR * height / 768, wanted=count)
    normals, names, which = as_rendered.look(bpy.context, look)
    if len(which) < count:
        raise ValueError(
            f"--gauges {count}: only {len(which)} places of this picture are on a surface, away from its outlines, "
            "creases and steps: ask for fewer, or come nearer"
        )
    return {"gauges": _told(places[which], normals, names), "tried": int(which[-1]) + 1}


def add_strings(scene, asked, found):
    """Adds gauges along lines, of (u, v, degrees) each, to `found`, and where each begins and ends. ValueError where
    some of them are on no surface."""
    width, height = scene.render.resolution_x, scene.render.resolution_y
    found["strings"] = []
    for u, v, degrees in asked:
        places = formulas.string((u, v), degrees, (width, height))
        radius = CLEAR_OF_STRING * height / 768
        look = partial(seen, px=places * (1, -1) + (0, height), radius=radius, wanted=formulas.STRING)
        normals, names, which = as_rendered.look(bpy.context, look)
        if len(which) < len(places):
            raise ValueError(
                f"--string {u:g},{v:g},{degrees:g}: {len(places) - len(which)} of its {len(places)} gauges are not on "
                "a surface, away from its outlines, creases and steps: move or turn it, or come nearer"
            )
        first = len(found["gauges"])
        found["gauges"] += _told(places, normals, names)
        found["strings"].append([first, first + len(places)])


def _told(places, normals, names):
    return [
        {"x": round(float(x), 3), "y": round(float(y), 3), "n": [round(float(value), 9) for value in n], "object": name}
        for (x, y), n, name in zip(places, normals, names)
    ]


def seen(engine, depsgraph, px, radius, wanted):
    """(normals (n, 3) as gauges show them, names of objects, (n,) which places) of the first `wanted` of places px
    (N, 2) from the lower left that are on one surface."""
    core, read = native.load(), reading.Reader().read(depsgraph, pipeline.style_of_lines({"contour": {}}))
    tracer = core.Tracer(read.placed, placed.seen(core, camera.of_render(engine, depsgraph)))
    normals, placements, which = [], [], []
    for start in range(0, len(px), wanted):
        found = core.GaugePlaces.of(tracer, px[start : start + wanted], radius)
        good = np.flatnonzero(found.placement != native.UNSET)
        normals.append(found.normal[good])
        placements.append(found.placement[good])
        which.append(good + start)
        if sum(map(len, which)) >= wanted:
            break
    normals, placements, which = (np.concatenate(each)[:wanted] for each in (normals, placements, which))
    return normals, [read.snapshot.objects[number] for number in placements], which


if __name__ == "__main__":
    ending.run(main)
