# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios that compare the viewport's picture with others of the same scene. Tests check what a scenario returns."""

import bpy
import numpy as np
from mathutils import Matrix
from showing import calm, opened, still, turn
from the_addon import part
from window import screen

camera = part("scene.camera")


def frame():
    """Left, lower, width and height of the camera's frame in the viewport, in pixels."""
    with screen.override():
        depsgraph = bpy.context.evaluated_depsgraph_get()
        screen.space().region_3d.update()
        return camera.of_region(bpy.context, depsgraph).frame


def align(width):
    """Zooms and shifts the camera view until its frame is so many pixels wide and starts at whole ones."""
    view = screen.space().region_3d
    view.view_perspective = "CAMERA"
    view.view_camera_offset = (0, 0)
    low, high = -30.0, 300.0
    for _ in range(40):
        view.view_camera_zoom = (low + high) / 2
        low, high = (view.view_camera_zoom, high) if frame()[2] < width else (low, view.view_camera_zoom)
    for axis in (0, 1):
        start, offset = frame()[axis], list(view.view_camera_offset)
        offset[axis] += 1e-3
        view.view_camera_offset = offset
        offset[axis] += 1e-3 * ((round(start) - start) / (frame()[axis] - start) - 1)
        view.view_camera_offset = offset
    return frame()


def camera_view(folder):
    """The viewport's picture inside the camera's frame beside the final render, for several cameras; once with pens
    that are a quarter wider, which must not pass for the same."""
    watch = yield from opened("suzanne:3")
    scene, found = bpy.context.scene, {}
    obj = scene.camera
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 640, 360, 100
    place = obj.matrix_world.copy()

    align(640)
    yield from watch.refined()
    found["coarse"] = yield from coarse(watch, obj)
    obj.matrix_world = place

    def beside(name):
        left, lower, width, height = (round(number) for number in align(640))
        exact = frame()
        yield from watch.refined()
        seen = screen.picture()[lower : lower + height, left : left + width]
        np.save(folder / f"{name}.npy", seen)
        found[name] = {"frame": exact, **likeness(seen, still(folder, name))}

    yield from beside("perspective")
    obj.data.shift_x, obj.data.shift_y = 0.15, -0.1
    yield from beside("shift")
    obj.data.show_passepartout, obj.data.passepartout_alpha = True, 1.0
    screen.space().lock_camera = True
    passepartout(screen.space().overlay)
    yield from beside("passepartout")
    found["outside"] = float(screen.picture()[:100].mean())
    screen.space().overlay.show_overlays = False
    obj.data.shift_x = obj.data.shift_y = 0
    obj.data.type, obj.data.ortho_scale = "ORTHO", 3.0
    yield from beside("orthographic")
    scene.render.film_transparent = False
    obj.matrix_world = Matrix.Rotation(0.5, 4, "Z") @ place
    yield from beside("moved")
    left, lower, width, height = (round(number) for number in frame())
    before = still(folder, "before")
    for line_set in part("style.style_data").own(scene).line_sets:
        line_set.pen.width *= 1.25
    yield from watch.refined()
    wider = screen.picture()[lower : lower + height, left : left + width]
    found["wider"] = likeness(wider, before)
    return found


def coarse(watch, obj):
    """A draft of half the size beside the refined picture: how far apart they are where blurred, how much ink each has,
    and the same when the draft is shifted by two pixels of it."""
    budget = part("budget")
    old, budget.Budget.choose = budget.Budget.choose, lambda *_, **__: 4
    obj.matrix_world = Matrix.Rotation(0.1, 4, "Z") @ obj.matrix_world
    screen.swap()
    chosen = watch.of(screen.area()).shown.quality
    draft = screen.picture()
    budget.Budget.choose = old
    yield from watch.refined()
    final = screen.picture()
    shifted = (np.roll(draft, by, axis) for by, axis in ((0, 0), (4, 0), (4, 1)))
    apart = [float(np.abs(blurred(image) - blurred(final)).mean()) for image in shifted]
    return {"quality": chosen, "apart": apart, "ink": [float((1 - image).mean()) for image in (draft, final)]}


def blurred(image):
    """Means of squares of 4 pixels."""
    height, width = (size // 4 * 4 for size in image.shape[:2])
    return image[:height, :width].reshape(height // 4, 4, width // 4, 4, 3).mean(axis=(1, 3))


def passepartout(overlay):
    """Of all overlays only what darkens what the camera does not see."""
    overlay.show_overlays = True
    others = "floor axis_x axis_y cursor relationship_lines outline_selected object_origins text"
    for name in others.split():
        setattr(overlay, f"show_{name}", False)
    for obj in bpy.context.scene.objects:
        obj.select_set(False)
        obj.hide_set(obj.type == "LIGHT")


def likeness(seen, final):
    """Mean of the differences, share of pixels that differ by more than 16 of 255, and how much ink there is."""
    inside = np.s_[2:-2, 2:-2]  # Blender draws the frame's border
    difference = np.abs(seen - final)[inside].max(axis=2)
    ink = (float((1 - image[inside]).mean()) for image in (seen, final))
    return {"mean": float(difference.mean()), "apart": float((difference > 16 / 255).mean()), "ink": list(ink)}


def on_gpu(folder):
    """Drawn by OpenGL, in the viewport's own context: beside what the CPU draws, while it turns, and at rest."""
    watch = yield from opened("boxes:3")
    settings, by_cpu = bpy.context.scene.fovea, screen.picture()
    settings.backend = "GPU"
    yield from watch.refined()
    told = {"apart": float(np.abs(screen.picture() - by_cpu)[16:].mean()), "ink": float((1 - by_cpu[16:]).mean())}
    settings.visibility = "ATLAS"
    yield from watch.refined()
    told["atlas apart"] = float(np.abs(screen.picture() - by_cpu)[16:].mean())
    for _ in range(5):
        turn(3)
        screen.swap()
        yield
    yield from watch.refined()
    told["drawn by"] = part("render.session").last_statistics()["backend"]
    settings.backend, settings.visibility = "CPU", "AUTO"
    turn(-15)
    yield from watch.refined()
    told["back"] = float(np.abs(screen.picture() - by_cpu)[16:].mean())
    told["calm"] = yield from calm()
    return told
