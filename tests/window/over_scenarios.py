# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of lines over what other engines show in viewports. Tests check what a scenario returns."""

import bpy
import numpy as np
import scenes
from showing import calm, turn
from the_addon import only_lines, part, use_style
from window import screen

overlay = part("render.lines_overlay")
RED, SHOWN = 0.5, 0.735  # of pens, scene-linear and sRGB


def shown():
    """The _Lines over the regions of the window's first 3D viewport."""
    regions = [r for r in screen.area().regions if r.type == "WINDOW"]
    return [overlay._of_region[r.as_pointer()] for r in regions if r.as_pointer() in overlay._of_region]


def refined(count=1):
    """Waits until so many regions show their best lines, and gives the picture: `yield from` it."""

    def done():
        return len(shown()) == count and all(lines.is_final() for lines in shown())

    yield from screen.rest(0.1)
    screen.swap()  # what a script changes need not make Blender draw
    yield from screen.until(done)
    screen.swap()
    yield from screen.until(done)
    screen.swap()
    return screen.picture()


def plain():
    """The picture where no lines are to be shown: `yield from` it."""
    yield from screen.rest(0.2)
    screen.swap()
    return screen.picture()


def red(picture):
    """(H, W) bool: where lines are, by the color of their pens as sRGB has it."""
    return np.abs(picture - (SHOWN, 0, 0)).max(axis=2) < 0.02


def scene_with_lines():
    scenes.build("boxes:2")
    scene = bpy.context.scene
    scene.render.engine = "BLENDER_WORKBENCH"
    scene.view_settings.view_transform = "AgX"
    only_lines(scene, "contour", "crease") if scene.fovea.style else use_style(scene, "plain")
    for line_set in scene.fovea.style.fovea.line_sets:
        line_set.pen.color, line_set.pen.opacity, line_set.pen.width = (RED, 0, 0), 1.0, 8.0
    scene.fovea.style.fovea.elision.enabled = False
    bpy.ops.fovea.lines_over()
    yield from screen.fill()
    return scene


def views(folder):
    """Shadings, views, borders, engines: how many pixels are red in each."""
    scene = yield from scene_with_lines()
    space, told = screen.space(), {}
    space.shading.type = "SOLID"
    solid = yield from refined()
    np.save(folder / "solid.npy", solid)
    told["solid"] = int(red(solid).sum())
    scene.fovea.lines_in_viewports = False
    told["off"] = int(red((yield from plain())).sum())
    told["kept while off"] = len(overlay._of_region)
    scene.fovea.lines_in_viewports = True
    yield from refined()
    space.shading.type = "WIREFRAME"
    told["wireframe"] = int(red((yield from plain())).sum())
    space.shading.type = "RENDERED"
    rendered = yield from refined()
    np.save(folder / "rendered.npy", rendered)
    told["rendered differs"] = float((red(rendered) != red(solid)).mean())
    space.region_3d.view_perspective = "CAMERA"
    whole = red((yield from refined()))
    scene.render.use_border = True
    scene.render.border_min_x, scene.render.border_max_x = 0.0, 0.5
    scene.render.border_min_y, scene.render.border_max_y = 0.0, 1.0
    half = red((yield from refined()))
    middle = half.shape[1] // 2
    told["border"] = [
        int(part.sum()) for part in (whole[:, :middle], half[:, :middle], whole[:, middle:], half[:, middle:])
    ]
    space.region_3d.view_camera_zoom = 20
    told["zoomed"] = int(red((yield from refined())).sum())
    scene.render.use_border = False
    space.region_3d.view_perspective = "ORTHO"
    told["orthographic"] = int(red((yield from refined())).sum())
    with screen.override():
        bpy.ops.screen.region_quadview()
    yield from refined(4)
    told["quad"] = len(overlay._of_region)
    with screen.override():
        bpy.ops.screen.region_quadview()
    yield from refined()
    told["one again"] = len(shown())
    space.region_3d.view_perspective, scene.camera.data.type = "CAMERA", "PANO"
    yield from screen.until(lambda: shown() and shown()[0].problem)
    told["problem"] = shown()[0].problem
    picture = yield from plain()
    told["letters"] = int((picture[: len(picture) // 10, :-40].min(axis=2) > 0.95).sum())  # without the pointer
    scene.camera.data.type = "PERSP"
    yield from refined()
    told["no problem"] = shown()[0].problem
    scene.render.engine = "FOVEA"
    yield from screen.rest(0.5)
    screen.swap()
    told["by Fovea"] = len(overlay._of_region)
    return told | {"calm": (yield from calm())}


def changes(folder):
    """An object moves, undo, playback, a turned view; without the extension's handler."""
    scene = yield from scene_with_lines()
    space, told, pictures = screen.space(), {}, {}
    space.shading.type = "SOLID"
    space.overlay.show_overlays = False
    pictures["start"] = yield from refined()
    (box, *_) = (obj for obj in scene.objects if obj.type == "MESH")
    with screen.override():
        bpy.ops.ed.undo_push(message="start")
        box.location.z += 0.7
        bpy.ops.ed.undo_push(message="moved")
    pictures["moved"] = yield from refined()
    with screen.override():
        bpy.ops.ed.undo()
    pictures["undone"] = yield from refined()
    scene = bpy.context.scene
    turn(40)
    pictures["turned"] = yield from refined()
    turn(-40)
    pictures["back"] = yield from refined()
    box = next(obj for obj in scene.objects if obj.type == "MESH")
    for frame, up in ((1, 0.0), (5, 0.7)):
        box.location.z += up
        box.keyframe_insert("location", frame=frame)
    scene.frame_set(1)
    yield from refined()
    scene.frame_set(5)
    pictures["played"] = yield from refined()
    for name, picture in pictures.items():
        np.save(folder / f"{name}.npy", picture)
    first = red(pictures["start"])
    told["differ"] = {name: int((red(picture) != first).sum()) for name, picture in pictures.items()}
    told["lines"] = int(first.sum())
    told["played as moved"] = int((red(pictures["played"]) != red(pictures["moved"])).sum())
    overlay.unregister()
    told["gone"] = [int(red((yield from plain())).sum()), len(overlay._of_region)]
    overlay.register()
    told["again"] = int(red((yield from refined())).sum())
    return told | {"calm": (yield from calm())}
