# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of the focus overlay in a window; see inside.py. Tests check what a scenario returns."""

from pathlib import Path

import bpy
import numpy as np
import scenes
from focus_scenarios import filled, opened, pixel, state
from mathutils import Quaternion
from the_addon import part
from window import screen

overlay, camera, reading = part("ui.focus_overlay"), part("scene.camera"), part("render.reading")
SHARED = Path(__file__).parents[3] / "shared"


def heat(folder):
    """Focus as colors: warm at the place, cool beside it, follows the view and the place; nothing is done at rest."""
    scene = yield from opened()
    manager = bpy.context.window_manager
    scene.fovea.focus_model, scene.fovea.focus_location = "SCENE", (0, 0, 1)
    scene.fovea.focus_near_distance, scene.fovea.focus_far_distance = 1.2, 2.0
    screen.space().show_gizmo = False
    yield from screen.rest(0.3)
    screen.swap()
    plain = screen.picture()
    manager.fovea_show_focus = True
    yield from screen.rest(0.3)
    screen.swap()
    shown = screen.picture()
    np.save(folder / "heat.npy", shown)

    def warmth(picture, at):
        x, y = (round(v) for v in pixel(at))
        return float((picture[y - 3 : y + 4, x - 3 : x + 4, 0] - picture[y - 3 : y + 4, x - 3 : x + 4, 2]).mean())

    told = {"here": warmth(shown, (0.4, 0.4, 1)), "there": warmth(shown, (4, 0, 1)), "plain": warmth(plain, (4, 0, 1))}
    calls, old = [], camera.of_region
    camera.of_region = lambda *words: calls.append(1) or old(*words)
    for _ in range(10):  # Blender draws a few times by itself after it has started
        calls.clear()
        yield from screen.rest(1.0)
        if not calls:
            break
    told["idle"] = len(calls)
    camera.of_region = old
    scene.fovea.focus_location = (4, 0, 1)
    yield from screen.rest(0.3)
    screen.swap()
    told["moved"] = [warmth(screen.picture(), (0.4, 0.4, 1)), warmth(screen.picture(), (4.4, 0.4, 1))]
    bpy.data.objects["Far"].location.z = -8
    yield from screen.rest(0.3)
    screen.swap()
    told["sunk"] = warmth(screen.picture(), (4.4, 0.4, -7))
    manager.fovea_show_focus = False
    yield from screen.rest(0.3)
    screen.swap()
    told["off"] = float(np.abs(screen.picture()[50:200, 50:200] - plain[50:200, 50:200]).mean())
    told["kept"] = len(overlay.in_regions) + len(overlay.readers)
    return told


def rendered(folder, spec="office"):
    """Focus as colors over Fovea's own picture of a scene; while the view turns, how coarse it is and how much
    bluer than red the ground is, which is out of focus."""
    scenes.build(spec, SHARED if SHARED.is_dir() else None)
    scene = bpy.context.scene
    scene.render.engine = "FOVEA"
    yield from filled()
    space = screen.space()
    space.region_3d.view_perspective, space.shading.type = "CAMERA", "RENDERED"
    yield from screen.rest(0.5)
    with screen.override():
        bpy.ops.fovea.pick_focus(x=screen.region().width // 2, y=screen.region().height // 2)
    bpy.context.window_manager.fovea_show_focus = True
    old, scales, cool = overlay._Shown.update, [], []

    def update(self, context):
        key = self.key
        old(self, context)
        scales.append((self.scale / overlay.SCALE, self.key != key))

    reads, read = [], reading.Reader.read

    def counted(reader, *words):
        reads.extend(own for own in overlay.readers if own is reader)  # others read what the engine draws
        return read(reader, *words)

    overlay._Shown.update, reading.Reader.read = update, counted
    yield from screen.rest(4)
    yield from screen.until(lambda: scales and scales[-1][0] == 1)  # on however slow a machine
    screen.swap()
    np.save(folder / "rendered.npy", screen.picture())
    (finest, _), scales[:] = scales[-1], []
    space.region_3d.view_perspective, affordable = "PERSP", overlay.affordable
    overlay.affordable = lambda scale, _, budget: affordable(scale, 1e3 * budget, budget)  # on however fast a machine
    for _ in range(5):
        space.region_3d.view_rotation = Quaternion((0, 0, 1), 0.03) @ space.region_3d.view_rotation
        screen.swap()
        cool.append(coolness(screen.picture()))
        yield
    np.save(folder / "turning.npy", screen.picture())
    coarse = {scale for scale, changed in scales if changed}
    yield from screen.until(lambda: scales[-1][0] == finest)
    screen.swap()  # where all rests already, nothing else draws it again
    yield from screen.until(lambda: scales[-1] == (finest, False))
    overlay._Shown.update, overlay.affordable = old, affordable
    told = {"rendered": len(reads)}
    space.shading.type = "SOLID"
    yield from screen.rest(0.5)
    screen.swap()
    np.save(folder / "solid.npy", screen.picture())
    told["solid"] = len(reads)
    reading.Reader.read = read
    return {"reads": told, "finest": finest, "coarse": sorted(coarse), "cool": cool, **state()}


def coolness(picture):
    """How much bluer than red the lower left corner is."""
    corner = picture[40:80, 40:80].mean(axis=(0, 1))
    return float(corner[2] - corner[0])
