# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of switching engines and shadings, and of disabling the add-on. Tests check what a scenario returns."""

from pathlib import Path

import bpy
from showing import calm, caretaker, opened, threads, turn
from the_addon import fovea
from watch import Watch
from window import screen


def memory():
    """MB that this process has allocated. Pages of files are its own or not by what other processes do."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return sum(int(line.split()[1]) for line in lines if line.startswith(("RssAnon", "RssShmem"))) / 1024


def switching(folder):
    """Engines and shadings, back and forth, in part while they are refined; MB of memory after each of 20 rounds."""
    watch = yield from opened("suzanne:3")
    scene, told = bpy.context.scene, []
    for turn_number in range(20):
        scene.render.engine = "BLENDER_WORKBENCH"
        yield from screen.rest(0.1)
        scene.render.engine = "FOVEA"
        yield from watch.refined()
        screen.space().shading.type = "SOLID"
        yield from screen.rest(0.1)
        screen.space().shading.type = "RENDERED"
        turn(5)
        yield
        if turn_number % 2:
            yield from watch.refined()
        told.append(memory())
    return {"memory": told, "calm": (yield from calm())}


def leftovers():
    """What an add-on may leave behind in Blender."""
    kinds = (bpy.types.PropertyGroup, bpy.types.Panel, bpy.types.Operator, bpy.types.RenderEngine)
    classes = [cls for kind in kinds for cls in kind.__subclasses__() if getattr(cls, "is_registered", False)]
    handlers = {name: getattr(bpy.app.handlers, name) for name in dir(bpy.app.handlers)}
    owners = [getattr(bpy.types, kind) for kind in ("Scene", "Object", "Material")]
    return {
        "classes": sorted(cls.__name__ for cls in classes),
        "handlers": {name: len(found) for name, found in handlers.items() if isinstance(found, list)},
        "properties": sorted(name for owner in owners for name in dir(owner)),
        "timer": bpy.app.timers.is_registered(caretaker.tick),
        "threads": threads(),
    }


def disabling(folder):
    """Disabled while it draws; then registered and unregistered again and again."""
    watch = yield from opened("demo")
    name = fovea.__name__
    turn(30)
    screen.swap()
    watch.end()
    with screen.override():
        bpy.ops.preferences.addon_disable(module=name)
    off = leftovers()
    told = {"engine": bpy.context.scene.render.engine, "off": {key: off[key] for key in ("timer", "threads")}}
    # Blender goes on with EEVEE, which takes a minute to begin in software.
    bpy.context.scene.render.engine = "BLENDER_WORKBENCH"
    screen.space().shading.type = "SOLID"
    yield from screen.rest(0.5)
    for _ in range(20):
        fovea.register()
        fovea.unregister()
        yield
    told["left"] = {key: (value, off[key]) for key, value in leftovers().items() if value != off[key]}
    told["names"] = [cls for cls in leftovers()["classes"] if "ovea" in cls]
    with screen.override():
        bpy.ops.preferences.addon_enable(module=name)
    bpy.context.scene.render.engine = "FOVEA"
    screen.space().shading.type = "RENDERED"
    watch = Watch()
    yield from watch.refined()
    told["again"] = watch.draws
    return told
