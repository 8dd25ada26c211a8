# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of frame changes, keyframes, renders and operators on lines in Rendered shading. Tests check what a
scenario returns."""

import sys

import bpy
import numpy as np
from showing import Steps, calm, of_file, opened, still, turn
from slow import busy, slower
from the_addon import part, use_style
from window import screen

style_data = part("style.style_data")
LAST = 20


def keyed(folder):
    """The place to look at, the mix of two styles and numbers of a style are keyed: frames back and forth, playback."""
    watch = yield from opened("boxes:2")
    scene, steps = bpy.context.scene, Steps(watch)
    screen.space().region_3d.view_distance = 10
    scene.frame_start, scene.frame_end = 1, LAST
    held = use_style(scene, "pencil")
    scene.fovea.mixed_style = style_data.new("Other", part("style").load("charcoal"))
    with screen.override():
        bpy.ops.fovea.pick_focus(location=(1, -1, 0))
        bpy.ops.fovea.focus_pull(target="LOCATION", location=(-1, 1, 0), frame_start=1, frame_end=LAST)
    keys = (scene.fovea, "mix", 0.0, 0.8), (held.line_sets[-1].pen, "width", 2.0, 8.0)
    for owner, name, first, last in keys:
        for frame, value in ((1, first), (LAST, last)):
            setattr(owner, name, value)
            owner.keyframe_insert(name, frame=frame)
    for name, frame in (("first", 1), ("middle", LAST // 2), ("last", LAST), ("first again", 1)):
        yield from steps.step(name, scene.frame_set, frame)
    told = {"reads": watch.read}
    for frame in range(1, 6):
        scene.frame_set(frame)
        screen.swap()
        yield
    told["reads"] = watch.read - told["reads"]
    with screen.override():
        bpy.ops.screen.animation_play()
    yield from screen.rest(0.3)
    watch.reset()
    frames = set()
    while len(frames) < 5 or watch.draws < 5:
        frames.add(scene.frame_current)
        yield
    with screen.override():
        bpy.ops.screen.animation_cancel(restore_frame=False)
    yield from screen.until(lambda: not watch.of(screen.area()).playing)
    yield from steps.step("last again", scene.frame_set, LAST)
    same, other = ("first, first again", "last, last again"), ("first, middle", "middle, last")
    told["same"] = {pair: steps.differ(*pair.split(", ")) for pair in same}
    told["other"] = {pair: steps.differ(*pair.split(", ")) for pair in other}
    return told | {"calm": (yield from calm())}


def rendering(folder):
    """F12 and an animation as jobs beside the interface while the view turns; then lines as an image and as objects,
    and both undone."""
    watch = yield from opened("boxes:3")
    scene, steps, told = bpy.context.scene, Steps(watch), {}
    bpy.context.preferences.view.render_display_type = "NONE"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 640, 360, 100
    use_style(scene, "technical")
    with screen.override():
        bpy.ops.ed.undo_push(message="start")
    yield from steps.step("start", bool)
    alone = still(folder, "alone")
    yield from steps.step("rendered", bool)
    scene.render.filepath = str(folder / "beside_")
    scene.frame_start, scene.frame_end = 1, 3
    for number, words in enumerate(({"write_still": True}, {"animation": True})):
        with screen.override():
            bpy.ops.render.render("INVOKE_DEFAULT", **words)
        running = 0
        while bpy.app.is_job_running("RENDER"):
            running += 1
            turn(3)
            yield
        turn(-3 * running)
        told[f"job {number}"] = running
        yield from steps.step(f"after job {number}", bool)
    told["files"] = sorted(path.name for path in folder.glob("beside_*"))
    told["beside"] = float(np.abs(of_file(folder / "beside_.png") - alone).max())
    ops = bpy.ops.fovea
    for name, operator, words in (
        ("image", ops.render_lines, {}),
        ("strokes", ops.bake_strokes, {"kind": "GREASE_PENCIL"}),
        ("mesh", ops.bake_strokes, {"kind": "MESH"}),
    ):
        before = len(bpy.data.images), len(bpy.data.objects)
        yield from steps.step(name, operator, "EXEC_DEFAULT", True, **words)
        told[name] = [len(bpy.data.images) - before[0], len(bpy.data.objects) > before[1]]
        yield from steps.step(f"{name} undone", bpy.ops.ed.undo)
    names = [name for name in steps.pictures if name != "start"]
    told["same"] = {name: steps.differ("start", name) for name in names}
    return told | {"calm": (yield from calm())}


def animation(folder):
    """An animation is rendered beside a viewport that draws all the time; data is written meanwhile, and after it. Then
    one into a movie that cannot be written: threads take turns as before."""
    yield from opened("boxes:3")
    scene = bpy.context.scene
    bpy.context.preferences.view.render_display_type = "NONE"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 640, 360, 100
    scene.frame_start, scene.frame_end = 1, 12
    scene.render.filepath = str(folder / "frame_")
    use_style(scene, "technical")
    interval = sys.getswitchinterval()
    with slower(viewport=0.1, render=0.2), busy(0.05):
        with screen.override():
            bpy.ops.render.render("INVOKE_DEFAULT", animation=True)
        while bpy.app.is_job_running("RENDER"):
            turn(3)
            yield
            scene.unit_settings.scale_length += 1
    scene.unit_settings.scale_length = 1
    told = {"files": len(list(folder.glob("frame_*")))}
    settings = scene.render.image_settings
    if hasattr(settings, "media_type"):
        settings.media_type = "VIDEO"
    settings.file_format = "FFMPEG"
    scene.render.filepath = str(next(folder.glob("frame_*")) / "movie")  # in a folder that is a file
    with screen.override():
        bpy.ops.render.render("INVOKE_DEFAULT", animation=True)
    yield from screen.until(lambda: not bpy.app.is_job_running("RENDER"))
    yield from screen.until(lambda: sys.getswitchinterval() == interval)
    return told | {"calm": (yield from calm())}
