# SPDX-License-Identifier: GPL-3.0-or-later
"""Helpers of scenarios: a scene drawn in a viewport, changes to it, and access to the picture."""

import contextlib
import math
import sys
import threading
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1] / "blender"))

import bpy
import numpy as np
import scenes
from mathutils import Quaternion
from the_addon import part
from watch import Watch
from window import screen

SHARED = Path(__file__).parents[3] / "shared"
caretaker = part("render.caretaker")


def opened(spec=None):
    """A scene in a 3D viewport that fills the window, in Rendered shading, refined; gives the Watch."""
    if spec:
        scenes.build(spec, SHARED if SHARED.is_dir() else None)
    scene = bpy.context.scene
    scene.render.engine = "FOVEA"
    scene.view_settings.view_transform = "Standard"
    scene.render.dither_intensity = 0
    yield from screen.fill()
    watch = Watch()
    screen.space().shading.type = "RENDERED"
    yield from watch.refined()
    return watch


def side_by_side():
    """Two viewports of the window as it was before one filled it, in Rendered shading; gives their areas: `yield from`
    it."""
    with screen.override():
        bpy.ops.screen.back_to_previous()
    yield from screen.rest(0.3)
    with screen.override():
        bpy.ops.screen.area_split(direction="VERTICAL", factor=0.5)
    yield from screen.rest(0.3)
    both = [screen.area(0), screen.area(1)]
    for area in both:
        area.spaces.active.shading.type = "RENDERED"
    return both


def turn(degrees):
    """Orbits the view."""
    view = screen.space().region_3d
    view.view_rotation = Quaternion((0, 0, 1), math.radians(degrees)) @ view.view_rotation


def still(folder, name):
    """(H, W, 3) float32: the final render."""
    path, scene = folder / f"{name}.png", bpy.context.scene
    scene.render.filepath = str(path)
    scene.render.image_settings.file_format = "PNG"
    bpy.ops.render.render(write_still=True)
    return of_file(path)


def of_file(path):
    """(H, W, 3) float32: a picture on the disk."""
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    width, height = image.size
    pixels = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(height, width, 4)[:, :, :3]


def threads():
    return [thread.name for thread in threading.enumerate() if thread.name.startswith("Fovea")]


def is_calm():
    """Whether nothing is under way."""
    return not threads() and not bpy.app.timers.is_registered(caretaker.tick)


def calm():
    """Whether nothing is under way before long; a busy machine needs a while to come to its rest. `yield from` it."""
    with contextlib.suppress(TimeoutError):
        yield from screen.until(is_calm, seconds=20)
    return is_calm()


class Steps:
    """Does things to a scene, one after the other, each seen refined; keeps what went wrong."""

    def __init__(self, watch):
        self.watch, self.pictures = watch, {}

    def step(self, name, act, *arguments, **options):
        """Does something and keeps what is seen then, as 'name'."""
        with screen.override():
            act(*arguments, **options)
        yield from self.watch.refined()
        self.pictures[name] = screen.picture()[16:]

    def differ(self, first, second, rows=np.s_[:]):
        return float(np.abs(self.pictures[first] - self.pictures[second])[rows].mean())
