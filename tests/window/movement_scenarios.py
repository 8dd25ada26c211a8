# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of changes of the view, of shapes and of time. Tests check what a scenario returns."""

import bpy
import numpy as np
from bpy_extras.view3d_utils import location_3d_to_region_2d
from mathutils import Matrix, Vector
from showing import SHARED, Steps, calm, caretaker, is_calm, opened, side_by_side, threads, turn
from slow import held
from the_addon import box_mesh, new_object, part
from window import screen

LITTLE, PLENTY = 1, 10000  # ms for a draw: no machine keeps the one, every machine the other


def orbit(folder):
    """30 steps around the office, or a smaller scene where its models are missing: in a budget that nothing keeps, so
    that it does not matter how fast the machine is; then a few in one that everything keeps."""
    watch = yield from opened("office" if SHARED.is_dir() else "demo")
    first = {"read": watch.read, "draws": watch.draws}
    screen.space().region_3d.view_perspective = "PERSP"
    yield from watch.refined()
    at_rest = screen.picture()
    settings = bpy.context.scene.fovea_viewport
    settings.budget_ms = LITTLE
    watch.reset()
    pictures = []
    for _ in range(30):
        turn(3)
        screen.swap()
        pictures.append(screen.picture()[::8, ::8].copy())
        yield
    moving = {"read": watch.read, "drafts": watch.drafts, "draws": watch.draws}
    moving["changed"] = sum(bool((a != b).any()) for a, b in zip(pictures, pictures[1:]))
    yield from watch.refined()
    refined = watch.of(screen.area()).shown.quality
    watch.reset()
    yield 2.0
    idle = {"draws": watch.draws, "timer": bpy.app.timers.is_registered(caretaker.tick), "threads": threads()}
    turn(-90)
    yield from watch.refined()
    back = float(np.abs(screen.picture() - at_rest)[16:].mean())
    settings.budget_ms = PLENTY
    watch.reset()
    for _ in range(4):
        turn(3)
        screen.swap()
        yield
    yield from watch.refined()
    return {"first": first, "moving": moving, "refined": refined, "idle": idle, "back": back, "plenty": watch.drafts}


def held_up(folder):
    """What is seen before the first picture is there; then what is seen of it while the view has moved and the next
    one is not there yet, where the box is seen then, and where the last picture has it."""
    with held() as drawings:
        opening = opened("boxes:1")
        for pause in opening:
            yield pause
            if drawings.begun:
                break
        yield from screen.rest(0.5)
        screen.swap()
        told = {"at first": bright(screen.picture(), screen.region().width // 2, screen.region().height // 2, 40)}
        np.save(folder / "first.npy", screen.picture())
        drawings.go.set()
        yield from opening
    space = screen.space()
    space.region_3d.view_perspective, space.region_3d.view_location = "PERSP", (0, 0, 0)
    space.region_3d.view_distance = 14
    yield from screen.rest(0.5)
    yield from screen.until(lambda: is_calm())
    screen.swap()
    before, was = screen.picture(), corner()
    with held():
        space.region_3d.view_location = (0, 0, 1)
        yield from screen.rest(0.8)
        screen.swap()
        stale, now = screen.picture(), corner()
        np.save(folder / "stale.npy", stale)
    yield from screen.until(lambda: is_calm())
    screen.swap()
    told["moved"] = float((now - was).length)
    found = {
        "before": (before, was),
        "there": (stale, now),
        "not there": (stale, was),
        "after": (screen.picture(), now),
    }
    told["ink"] = {name: dark(*words) for name, words in found.items()}
    return told


def left_behind(folder):
    """How bright the paper is while the next picture is not there yet, by what was done; then when it is there."""
    yield from opened("boxes:1")
    space = screen.space()
    box = next(obj for obj in bpy.context.scene.objects if obj.type == "MESH")
    light = new_object(bpy.data.lights.new("Light", "SUN"), "Light", (50, 50, 50))
    pen = part("style.style_data").own(bpy.context.scene).line_sets[-1].pen
    done = {
        "nothing": lambda: None,
        "view": lambda: turn(5),
        "pen": lambda: setattr(pen, "width", pen.width + 1),
        "light": lambda: setattr(light.location, "x", light.location.x + 1),
        "object": lambda: setattr(box.location, "z", box.location.z + 1),
        "mesh": lambda: reshape(box.data),
        "hidden": lambda: box.hide_set(True),
    }
    told = {}
    for overlays in (True, False):
        space.overlay.show_overlays = overlays
        for name, act in done.items():
            box.hide_set(False)
            yield from at_rest()
            with held():
                act()
                yield from screen.rest(0.8)
                screen.swap()
                told[f"{name} {overlays}"] = float(np.median(screen.picture()))
            yield from at_rest()
            told[f"{name} {overlays} after"] = float(np.median(screen.picture()))
    return told


def reshape(mesh):
    mesh.transform(Matrix.Scale(1.1, 4))
    mesh.update()


def at_rest():
    yield from screen.rest(0.5)
    yield from screen.until(lambda: is_calm())
    screen.swap()


def corner():
    """Where the upper corner of the box is seen that is in front, in pixels of the region."""
    box = next(obj for obj in bpy.context.scene.objects if obj.type == "MESH")
    region, view = screen.region(), screen.space().region_3d
    eye = view.view_matrix.inverted().translation
    near = min((box.matrix_world @ Vector(c) for c in box.bound_box), key=lambda place: (place - eye).length)
    return location_3d_to_region_2d(region, view, near)


def dark(picture, at, reach=6):
    """How dark the darkest pixel around a place of a picture is."""
    x, y = round(at.x), round(at.y)
    return float(1 - picture[y - reach : y + reach + 1, x - reach : x + reach + 1].min())


def bright(picture, x, y, reach):
    """How many pixels around a place are bright."""
    return int((picture[y - reach : y + reach, x - reach : x + reach].min(axis=2) > 0.9).sum())


def shapes(folder):
    """Shape keys, an armature, playback, a style, several viewports, orthographic views."""
    watch = yield from opened("boxes:2")
    steps, layer, held = Steps(watch), bpy.context.view_layer, part("style.style_data").own(bpy.context.scene)
    obj = new_object(box_mesh(1.5), "Shaped", (0, 0, 5))
    obj.shape_key_add(name="Basis")
    key = obj.shape_key_add(name="Wide")
    for point in key.data:
        point.co.x *= 2
    yield from steps.step("shape", setattr, key, "value", 0.0)
    yield from steps.step("wide", setattr, key, "value", 1.0)
    bones = new_object(bpy.data.armatures.new("Bones"), "Bones")
    layer.objects.active = bones
    with screen.override():
        bpy.ops.object.mode_set(mode="EDIT")
        bone = bones.data.edit_bones.new("Bone")
        bone.head, bone.tail = (0, 0, 5), (0, 0, 7)
        bpy.ops.object.mode_set(mode="OBJECT")
    obj.vertex_groups.new(name="Bone").add(range(8), 1.0, "ADD")
    obj.modifiers.new("Armature", "ARMATURE").object = bones
    yield from steps.step("boned", setattr, bones.pose.bones["Bone"], "location", (0, 0, 0))
    yield from steps.step("posed", setattr, bones.pose.bones["Bone"], "location", (2, 0, 0))
    reads = watch.read
    yield from steps.step("paper", setattr, held.paper, "color", (0.5, 0.5, 0.5))
    told = {"read of a style": watch.read - reads}
    yield from steps.step("top", bpy.ops.view3d.view_axis, type="TOP")
    told["played"] = yield from play(watch, obj)
    yield from screen.until(lambda: not watch.of(screen.area()).playing)
    yield from watch.refined()
    told["after playing"] = watch.of(screen.area()).shown.quality
    told["two"] = yield from two_viewports(watch)
    pairs = ("shape", "wide"), ("boned", "posed"), ("posed", "paper"), ("paper", "top")
    told["differences"] = {f"{a}, {b}": steps.differ(a, b) for a, b in pairs}
    told["calm"] = yield from calm()
    return told


def play(watch, obj):
    """Animation playback: pictures come, none is refined; when it ends, the last one is."""
    for number, place in ((1, 0.0), (20, 4.0)):
        obj.location.x = place
        obj.keyframe_insert("location", frame=number)
    with screen.override():
        bpy.ops.screen.animation_play()
    yield from screen.rest(0.5)
    watch.reset()
    yield from screen.rest(2.0)
    told = {"draws": watch.draws, "read": watch.read}
    with screen.override():
        bpy.ops.screen.animation_cancel(restore_frame=False)
    return told


def two_viewports(watch):
    """Both refined, also when the scene changes; and alike where they look from the same place."""
    both = yield from side_by_side()
    yield from watch.refined(*both)
    bpy.data.objects["Shaped"].location.z += 1
    turn(20)
    yield from watch.refined(*both)
    return [watch.of(one).shown.quality for one in both]
