# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of operators that start a render, in a window whose viewport draws; see inside.py. Tests check what a
scenario returns."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1] / "blender"))

import bpy
import numpy as np
from focus_scenarios import opened
from picture import pixels
from the_addon import part, use_style
from watch import Watch
from window import screen


def beside_a_viewport(_folder):
    """Line layer, strokes and report while a viewport is in Rendered shading, and while another engine draws it."""
    scene = yield from opened()
    scene.objects["Far"].hide_render = True
    watch = Watch()
    screen.space().shading.type = "RENDERED"
    yield from watch.refined()
    before = screen.picture()[16:]  # above the pointer
    with screen.override():
        told = {"done": [bpy.ops.fovea.render_lines() == {"FINISHED"}, bpy.ops.fovea.report() == {"FINISHED"}]}
    screen.swap()
    yield from watch.refined()
    told["apart"] = float(np.abs(screen.picture()[16:] - before).max())
    told["report"] = bpy.data.texts[part("render.report").TEXT].as_string()
    told["result"] = [image.name for image in bpy.data.images if image.type == "RENDER_RESULT"]
    told["windows"] = len(bpy.context.window_manager.windows)
    scene.render.engine = "BLENDER_WORKBENCH"
    screen.space().shading.type = "SOLID"
    yield from screen.rest(0.5)
    with screen.override():
        told["done"].append(bpy.ops.fovea.bake_strokes(kind="MESH") == {"FINISHED"})
    told["engine"] = scene.render.engine
    told["strokes"] = sum(len(obj.data.edges) for obj in bpy.data.collections["Lines"].objects)
    with screen.override():
        bpy.ops.ed.undo()
    told["undone"] = "Lines" in bpy.data.collections
    watch.end()
    return told


def line_layer(_folder):
    """The line layer rendered twice from its button."""
    yield from opened()

    def shown():
        areas = (area for window in bpy.context.window_manager.windows for area in window.screen.areas)
        return [area.spaces.active.image.name for area in areas if area.type == "IMAGE_EDITOR"]

    with screen.override():
        done = bpy.ops.fovea.render_lines("INVOKE_DEFAULT") == {"FINISHED"}
    yield from screen.rest(0.5)
    told = {"done": done, "shown": shown()}
    with screen.override():
        bpy.ops.fovea.render_lines("INVOKE_DEFAULT")
    yield from screen.rest(0.5)
    return told | {"again": shown(), "windows": len(bpy.context.window_manager.windows)}


def lines_over(folder):
    """Lines over another engine's render by F12, which runs beside the interface, and by a script; then undo."""
    scene = yield from opened("BLENDER_WORKBENCH")
    over, scenes = part("render.lines_over"), part("render.lines_scenes")
    scene.render.resolution_x, scene.render.resolution_y = 96, 64
    scene.render.dither_intensity = 0.0
    use_style(scene, "plain").line_sets[-1].pen.width = 60.0
    scene.render.image_settings.file_format = "PNG"
    paths = [Path(folder) / f"{name}.png" for name in ("photo", "script", "f12")]
    photo, script, f12 = map(str, paths)
    scene.render.filepath = photo
    bpy.ops.render.render(write_still=True)
    with screen.override():
        told = {"done": bpy.ops.fovea.lines_over("EXEC_DEFAULT", True) == {"FINISHED"}}
    yield from screen.rest(0.3)
    scene.render.filepath = script
    bpy.ops.render.render(write_still=True)
    with screen.override():
        bpy.ops.render.render("INVOKE_DEFAULT")
    yield from screen.until(lambda: bpy.app.is_job_running("RENDER"))
    yield from screen.until(lambda: not bpy.app.is_job_running("RENDER"))
    next(image for image in bpy.data.images if image.type == "RENDER_RESULT").save_render(f12, scene=scene)
    scene.render.use_border = True
    yield from screen.rest(0.3)
    told["in_step"] = scenes.of(scene).render.use_border
    plain, with_lines, again = (pixels(path) for path in paths)
    told["lines"] = float(np.abs(with_lines - plain).max())
    told["apart"] = float(np.abs(again - with_lines).max())
    with screen.override():
        bpy.ops.ed.undo()
    yield from screen.rest(0.3)
    scene = bpy.context.scene
    return told | {"left": over.is_on(scene), "scenes": len(bpy.data.scenes), "engine": scene.render.engine}
