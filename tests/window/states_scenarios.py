# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of modes, scenes and errors of a viewport in Rendered shading. Tests check what a scenario returns."""

import bpy
import numpy as np
from showing import Steps, calm, is_calm, opened, turn
from the_addon import add_camera, box_mesh, new_object
from window import screen

MIDDLE = np.s_[120:-60]  # rows without the brushes and tools that modes show over the picture


def modes(folder):
    """Every mode of a mesh entered and left; a mesh remade while it is sculpted, and that undone."""
    watch = yield from opened("suzanne:1")
    steps, ops, layer = Steps(watch), bpy.ops, bpy.context.view_layer
    screen.space().region_3d.view_distance = 6
    obj = next(o for o in bpy.context.scene.objects if o.type == "MESH")
    layer.objects.active = obj
    yield from steps.step("start", bool)
    for mode in ("EDIT", "SCULPT", "VERTEX_PAINT", "WEIGHT_PAINT", "TEXTURE_PAINT"):
        yield from steps.step(mode, ops.object.mode_set, "EXEC_DEFAULT", True, mode=mode)
        turn(5)
        screen.swap()
        turn(-5)
        if mode == "SCULPT":
            obj.data.remesh_voxel_size = 0.2
            yield from steps.step("sculpted", ops.object.voxel_remesh, "EXEC_DEFAULT", True)
            yield from steps.step("not sculpted", ops.ed.undo)
        yield from steps.step(f"left {mode}", ops.object.mode_set, "EXEC_DEFAULT", True, mode="OBJECT")
    names = [name for name in steps.pictures if name not in ("start", "sculpted")]
    told = {"same": {name: steps.differ("start", name, MIDDLE) for name in names}}
    return told | {"sculpted": steps.differ("start", "sculpted", MIDDLE), "calm": (yield from calm())}


def troubles(folder):
    """What cannot be drawn, and what can be again: an empty scene, a camera that goes or is panoramic, another scene
    in the window, one that is deleted while it is drawn."""
    watch = yield from opened("boxes:2")
    steps, space, window = Steps(watch), screen.space(), bpy.context.window_manager.windows[0]
    first = bpy.context.scene
    yield from steps.step("start", bool)
    scene = bpy.data.scenes.new("Second")
    scene.render.engine = "FOVEA"
    window.scene = scene
    yield from at_rest()
    told = {"empty": [watch.of(screen.area()).shown is None, (yield from calm())]}
    scene.view_settings.view_transform = "Standard"
    scene.collection.objects.link(bpy.data.objects.new("Box", box_mesh()))
    yield from steps.step("second", bool)
    turn(20)
    screen.swap()
    turn(-20)
    bpy.data.scenes.remove(scene)
    yield from at_rest()
    window.scene = first
    yield from steps.step("first again", bool)
    space.region_3d.view_perspective = "CAMERA"
    yield from steps.step("camera", bool)
    camera = first.camera
    camera.data.type = "PANO"
    yield from at_rest()
    told["panoramic"] = yield from calm()
    camera.data.type = "PERSP"
    yield from steps.step("camera again", bool)
    place = camera.matrix_world.copy()
    bpy.data.objects.remove(camera)
    yield from at_rest()
    told["no camera"] = yield from calm()
    add_camera().matrix_world = place
    first.camera.data.lens = 50
    space.region_3d.view_perspective = "CAMERA"
    yield from steps.step("other camera", bool)
    for obj in list(first.objects):
        bpy.data.objects.remove(obj)
    yield from at_rest()
    told["all gone"] = yield from calm()
    space.region_3d.view_perspective = "PERSP"
    new_object(box_mesh(), "Box")
    yield from steps.step("box", bool)
    same, other = ("start, first again", "camera, camera again"), ("start, second", "start, camera", "first again, box")
    told["same"] = {pair: steps.differ(*pair.split(", ")) for pair in same}
    told["other"] = {pair: steps.differ(*pair.split(", ")) for pair in other}
    return told | {"calm": (yield from calm())}


def at_rest():
    """Waits until nothing is under way; there may be nothing to see."""
    yield from screen.rest(0.2)
    screen.swap()
    yield from screen.until(is_calm)
