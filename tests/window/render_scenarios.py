# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of operators that start a render, in a window whose viewport draws; see inside.py. Tests check what a
scenario returns."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1] / "blender"))

import bpy
import numpy as np
from focus_scenarios import opened
from the_addon import part
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
