# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of saving, loading and recovering files in Rendered shading. Tests check what a scenario returns."""

import bpy
import numpy as np
from showing import calm, caretaker, opened, threads, turn
from slow import held
from the_addon import add_camera, box_mesh, new_object, part
from window import screen

style_data, style_read = part("style.style_data"), part("style.style_read")
focus_settings = part("focus.focus_settings")


def styled():
    """Gives the scene a style that is no other, and looks at a place."""
    scene = bpy.context.scene
    held_style = style_data.use(scene, "charcoal")
    for line_set in held_style.line_sets:
        line_set.pen.width = 7.5
        line_set.pen.color = (0.1, 0.2, 0.6)
    held_style.paper.color = (0.9, 0.8, 0.7)
    with screen.override():
        bpy.ops.fovea.pick_focus(location=(1, -1, 0))
    scene.fovea_viewport.budget_ms = 77
    scene.fovea.visibility = "EXACT"


def state():
    """What is saved with a file, but for the picture."""
    scene = bpy.context.scene
    tree = style_data.of(scene)
    return {
        "style": part("style").dump(style_read.read(tree)) if tree else None,
        "focus": repr(focus_settings.focus_of(scene.fovea)),
        "settings": [scene.fovea_viewport.budget_ms, scene.fovea.visibility, scene.render.engine],
    }


class Gallery:
    """Pictures and states of files, by name."""

    def __init__(self, watch):
        self.watch, self.kept = watch, {}

    def keep(self, name):
        yield from self.watch.refined()
        # Blender opens files with its own bars over the upper edge.
        self.kept[name] = state(), screen.picture()[16:-40]

    def same(self, first, second):
        """[whether the states are the same, how far the pictures are apart]."""
        (told, picture), (other, beside) = self.kept[first], self.kept[second]
        return [told == other, float(np.abs(picture - beside).mean())]


def saved(folder, name):
    path = str(folder / f"{name}.blend")
    with screen.override():
        bpy.ops.wm.save_as_mainfile(filepath=path)
    return path


def loaded(operator, **words):
    """Lets an operator load a file, and presses Rendered: Blender opens what was saved so in Solid."""
    operator(**words)
    yield from screen.rest(0.3)
    screen.space().shading.type = "RENDERED"


def loading(folder):
    """Two files with styles of their own, loaded in turn, also while a picture of the other is on its way."""
    watch = yield from opened("boxes:2")
    gallery, told = Gallery(watch), {}
    styled()
    yield from gallery.keep("first")
    first = saved(folder, "first")
    yield from gallery.keep("saved")
    new_object(box_mesh(0.7), "More", (1, 1, 1))
    style_data.use(bpy.context.scene, "plain")
    bpy.context.scene.fovea.focus_model = "NONE"
    yield from gallery.keep("second")
    second = saved(folder, "second")
    for name, path in (("first again", first), ("second again", second)):
        yield from loaded(bpy.ops.wm.open_mainfile, filepath=path)
        yield from gallery.keep(name)
    bpy.ops.wm.open_mainfile(filepath=first, load_ui=False)
    told["stays"] = screen.space().shading.type
    yield from gallery.keep("without its screens")
    with held() as drawing:
        turn(10)
        screen.swap()
        turn(-10)
        screen.swap()
        told["under way"] = [drawing.begun, len(threads())]
        bpy.ops.wm.open_mainfile(filepath=second, load_ui=False)
        told["stopped"] = [threads(), bpy.app.timers.is_registered(caretaker.tick)]
    yield from gallery.keep("second in the middle")
    pairs = "first, saved; first, first again; second, second again; first, without its screens"
    pairs += "; second, second in the middle"
    told["same"] = {pair: gallery.same(*pair.split(", ")) for pair in pairs.split("; ")}
    told["other"] = gallery.same("first", "second")
    return told | {"calm": (yield from calm())}


def coming_back(folder):
    """A file saved, changed and reverted; saved as another, and recovered; left for the start-up file."""
    watch = yield from opened("boxes:2")
    gallery = Gallery(watch)
    styled()
    yield from gallery.keep("start")
    saved(folder, "start")
    bpy.context.scene.objects["Boxes"].location.x += 1
    style_data.of(bpy.context.scene).fovea.paper.color = (0.2, 0.2, 0.2)
    yield from gallery.keep("changed")
    yield from loaded(bpy.ops.wm.revert_mainfile)
    yield from gallery.keep("reverted")
    bpy.context.scene.objects["Boxes"].rotation_euler.z += 0.5
    yield from gallery.keep("turned")
    other = saved(folder, "other")
    bpy.ops.wm.read_homefile(use_factory_startup=True)
    yield from screen.rest(0.3)
    yield from screen.fill()
    bpy.context.scene.render.engine = "FOVEA"
    told = {"left for": [screen.space().shading.type, style_data.of(bpy.context.scene) is None]}
    screen.space().shading.type = "RENDERED"
    yield from gallery.keep("start-up")
    yield from loaded(bpy.ops.wm.recover_auto_save, filepath=other)
    yield from gallery.keep("recovered")
    bpy.ops.wm.read_homefile(use_empty=True)
    yield from screen.rest(0.3)
    bpy.context.scene.render.engine = "FOVEA"
    new_object(box_mesh(), "Box")
    add_camera()
    style_data.use(bpy.context.scene, "blueprint")
    yield from screen.fill()
    screen.space().shading.type = "RENDERED"
    yield from gallery.keep("new")
    same, other = ("start, reverted", "turned, recovered"), ("start, changed", "start, turned", "start-up, new")
    told["same"] = {pair: gallery.same(*pair.split(", ")) for pair in same}
    told["other"] = {pair: gallery.same(*pair.split(", "))[1] for pair in other}
    return told | {"calm": (yield from calm())}
