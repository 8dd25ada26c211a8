# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of viewports, windows, view layers and their settings. Tests check what a scenario returns."""

import bpy
from pointer import drag
from showing import Steps, calm, opened, side_by_side, turn
from the_addon import box_mesh, new_object
from window import screen


def switches(folder):
    """Shadings, X-ray, overlays, view layers, local collections, a camera that is locked to the view."""
    watch = yield from opened("boxes:2")
    scene, space, ops = bpy.context.scene, screen.space(), bpy.ops
    steps, told = Steps(watch), {}
    step = steps.step
    beside = bpy.data.collections.new("Beside")
    scene.collection.children.link(beside)
    new_object(box_mesh(0.6), "Beside", (1.5, -1.5, 1), beside)
    space.region_3d.view_distance = 9
    yield from step("start", bool)
    yield from step("x-ray", setattr, space.shading, "show_xray", True)
    yield from step("x-ray off", setattr, space.shading, "show_xray", False)
    for name in ("WIREFRAME", "SOLID"):
        space.shading.type = name
        space.shading.show_xray = name == "SOLID"
        yield from screen.rest(0.2)
        turn(10)
        screen.swap()
    turn(-20)
    space.shading.type = "RENDERED"
    yield from step("shaded again", bool)
    space.overlay.show_overlays = True
    yield from step("overlays", bool)
    space.overlay.show_overlays = False
    yield from step("no overlays", bool)

    second = scene.view_layers.new("Second")
    second.layer_collection.children["Beside"].exclude = True
    window = bpy.context.window_manager.windows[0]
    for name, layer in (("second layer", second), ("first layer", scene.view_layers[0])):
        window.view_layer = layer
        yield from step(name, bool)
    layer = scene.view_layers[0].layer_collection.children["Beside"]
    yield from step("hidden collection", setattr, layer, "hide_viewport", True)
    yield from step("shown collection", setattr, layer, "hide_viewport", False)
    yield from step("local collections", setattr, space, "use_local_collections", True)
    yield from step("hidden here", ops.object.hide_collection, collection_index=1, toggle=True)
    yield from step("shown here", ops.object.hide_collection, collection_index=1, toggle=True)
    yield from step("no meshes", setattr, space, "show_object_viewport_mesh", False)
    yield from step("meshes", setattr, space, "show_object_viewport_mesh", True)
    yield from step("clipped", setattr, space, "clip_start", 9.0)
    yield from step("unclipped", setattr, space, "clip_start", 0.01)

    pairs = "start, x-ray; start, x-ray off; start, shaded again; start, no overlays; start, first layer"
    pairs += "; start, shown collection; second layer, hidden collection; start, local collections"
    pairs += "; second layer, hidden here; start, shown here; start, meshes; start, unclipped"
    told["same"] = {pair: steps.differ(*pair.split(", ")) for pair in pairs.split("; ")}
    pairs = "start, second layer; start, hidden here; start, no meshes; start, clipped"
    told["other"] = {pair: steps.differ(*pair.split(", ")) for pair in pairs.split("; ")}
    return told | {"calm": (yield from calm())}


def locked_camera(folder):
    """In camera view with the camera locked to it the mouse moves the camera: nothing is read of the scene, and the
    frame of the camera keeps its pens."""
    watch = yield from opened("boxes:2")
    steps, space, camera = Steps(watch), screen.space(), bpy.context.scene.camera
    space.region_3d.view_perspective = "CAMERA"
    yield from steps.step("start", bool)
    reads, place = watch.read, camera.matrix_world.copy()
    yield from drag("MIDDLEMOUSE", (400, 300), (500, 330))
    yield from steps.step("view left", bool)
    told = {"unlocked": [space.region_3d.view_perspective, camera.matrix_world == place]}
    space.region_3d.view_perspective, space.lock_camera = "CAMERA", True
    yield from drag("MIDDLEMOUSE", (400, 300), (500, 330))
    yield from steps.step("camera moved", bool)
    told["locked"] = [space.region_3d.view_perspective, camera.matrix_world != place]
    told["read"] = watch.read - reads
    camera.matrix_world = place
    yield from steps.step("back", bool)
    told["differences"] = [steps.differ("start", name) for name in ("view left", "camera moved", "back")]
    return told | {"calm": (yield from calm())}


def many(folder):
    """Several viewports and windows: local view in one of them, four views in one region, a window that goes while it
    is drawn."""
    watch = yield from opened("boxes:2")
    new_object(box_mesh(0.6), "Beside", (1.5, -1.5, 1))
    steps, ops = Steps(watch), bpy.ops
    yield from steps.step("start", bool)
    told = {}
    with screen.override():
        ops.screen.region_quadview()
    yield from screen.rest(0.5)
    regions = [r for r in screen.area().regions if r.type == "WINDOW"]
    keys = [r.as_pointer() for r in regions]
    yield from screen.until(lambda: all(key in watch.kept and watch.kept[key].is_final() for key in keys))
    told["four"] = len({watch.kept[key].shown.image for key in keys})
    bpy.data.objects["Beside"].location.z += 1
    yield from screen.rest(0.1)
    yield from screen.until(lambda: all(watch.kept[key].is_final() for key in keys))
    bpy.data.objects["Beside"].location.z -= 1
    with screen.override():
        ops.screen.region_quadview()
    yield from screen.rest(0.3)
    yield from steps.step("one again", bool)

    with screen.override():
        ops.screen.back_to_previous()
    yield from screen.rest(0.3)
    with screen.override():
        ops.wm.window_new_main()
    yield from screen.rest(0.5)
    windows = bpy.context.window_manager.windows
    other = next(a for a in windows[1].screen.areas if a.type in ("VIEW_3D", "PROPERTIES", "OUTLINER"))
    other.type = "VIEW_3D"
    other.spaces.active.shading.type = "RENDERED"
    yield from watch.refined(other)
    told["second window"] = watch.of(other).shown.quality
    layer = bpy.context.scene.view_layers.new("Second")
    layer.layer_collection.collection.objects["Beside"].hide_set(True, view_layer=layer)
    windows[1].view_layer = layer
    yield from watch.refined(other, screen.area())
    told["placed"] = [
        len(watch.of(area).shown.wanted.scene.gathered.snapshot.objects) for area in (screen.area(), other)
    ]
    bpy.data.objects["Beside"].location.z += 1
    with bpy.context.temp_override(window=windows[1]):
        ops.wm.window_close()
    yield from screen.fill()
    yield from steps.step("moved", bool)
    bpy.data.objects["Beside"].location.z -= 1
    yield from steps.step("alone", bool)
    pairs = ("start", "one again"), ("start", "alone"), ("start", "moved")
    told["differences"] = [steps.differ(*pair) for pair in pairs]
    return told | {"windows": len(windows), "calm": (yield from calm())}


def local(folder):
    """Two viewports side by side, one of them in local view."""
    watch = yield from opened("boxes:2")
    new_object(box_mesh(0.6), "Beside", (1.5, -1.5, 1))
    both = yield from side_by_side()
    for obj in bpy.context.scene.objects:
        obj.select_set(obj.name == "Beside")
    with screen.override():
        bpy.ops.view3d.localview()
    told = []
    yield from watch.refined(*both)
    told.append(placed(watch, both))
    bpy.data.objects["Beside"].location.x += 0.5
    yield from watch.refined(*both)
    told.append(placed(watch, both))
    with screen.override():
        bpy.ops.view3d.localview()
    yield from watch.refined(*both)
    told.append(placed(watch, both))
    return {"placed": told, "calm": (yield from calm())}


def placed(watch, areas):
    """How many objects with lines each viewport draws."""
    return [len(watch.of(area).shown.wanted.scene.gathered.snapshot.objects) for area in areas]
