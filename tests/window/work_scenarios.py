# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of typical work in Rendered shading. Tests check what a scenario returns."""

import bpy
from pointer import drag, event, press
from showing import Steps, calm, opened


def operators(folder):
    """What artists do while they look at the picture."""
    watch = yield from opened("boxes:2")
    steps, ops = Steps(watch), bpy.ops
    step = steps.step
    yield from step("start", ops.ed.undo_push, message="start")
    yield from step("selected", ops.object.select_all, "EXEC_DEFAULT", True, action="SELECT")
    reads = watch.read
    yield from step("none", ops.object.select_all, "EXEC_DEFAULT", True, action="DESELECT")
    told = {"read of a selection": watch.read - reads}
    yield from step("added", ops.mesh.primitive_monkey_add, "EXEC_DEFAULT", True, location=(0, 0, 4), size=4)
    yield from step("moved", ops.transform.translate, "EXEC_DEFAULT", True, value=(1, 0, 0))
    yield from step("undone", ops.ed.undo)
    yield from step("redone", ops.ed.redo)
    yield from step("deleted", ops.object.delete, "EXEC_DEFAULT", True)
    yield from step("back", ops.ed.undo)
    bpy.context.view_layer.objects.active = bpy.data.objects["Suzanne"]
    yield from step("edited", ops.object.mode_set, "EXEC_DEFAULT", True, mode="EDIT")
    yield from step("subdivided", ops.mesh.subdivide, "EXEC_DEFAULT", True)
    yield from step("left", ops.object.mode_set, "EXEC_DEFAULT", True, mode="OBJECT")
    yield from step("alone", ops.view3d.localview)
    yield from step("together", ops.view3d.localview)
    yield from step("hidden", bpy.data.objects["Suzanne"].hide_set, True)
    yield from step("shown", bpy.data.objects["Suzanne"].hide_set, False)
    same = "start selected,selected none,added undone,moved redone,moved back,left together,left shown"
    other = "start added,added moved,moved deleted,back left,left alone,left hidden"
    told["same"], told["other"] = (
        {pair: steps.differ(*pair.split()) for pair in pairs.split(",")} for pairs in (same, other)
    )
    told["calm"] = yield from calm()
    return told


def events(folder):
    """The view turned by the mouse, an object grabbed and put down, and that undone by keys."""
    watch = yield from opened("boxes:2")
    steps, obj = Steps(watch), next(o for o in bpy.context.scene.objects if o.type == "MESH")
    bpy.context.view_layer.objects.active = obj
    bpy.ops.object.select_all(action="DESELECT")
    obj.select_set(True)
    yield from steps.step("start", bpy.ops.ed.undo_push, message="start")
    told = {"reads": watch.read}
    yield from drag("MIDDLEMOUSE", (400, 300), (520, 340))
    yield from steps.step("turned", bool)
    told["read to turn"] = watch.read - told.pop("reads")
    reads = watch.read
    yield from press("G", (400, 300))
    for x in range(400, 480, 10):
        yield from event("MOUSEMOVE", "NOTHING", (x, 320))
    yield from press("LEFTMOUSE", (480, 320))
    yield from steps.step("grabbed", bool)
    told["read to grab"] = watch.read - reads
    yield from event("Z", "PRESS", (480, 320), ctrl=True)
    yield from event("Z", "RELEASE", (480, 320))
    yield from steps.step("undone", bool)
    pairs = ("start", "turned"), ("turned", "grabbed"), ("turned", "undone")
    told["differences"] = [steps.differ(*pair) for pair in pairs]
    told["calm"] = yield from calm()
    return told
