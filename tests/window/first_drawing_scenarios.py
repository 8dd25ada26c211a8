# SPDX-License-Identifier: GPL-3.0-or-later
"""The steps of the page on the first drawing, in order. Tests check what a scenario returns."""

import bpy
import first_drawing
import numpy as np
from bpy_extras.object_utils import world_to_camera_view
from command import pages
from showing import still
from the_addon import part
from window import screen

places = part("focus.focus_places")
REACH = 0.06  # of the frame's width: half the side of what is looked at around a place


def follow(folder):
    """From Blender's start-up to the last frame; how far the pictures of the viewport differ on the way, how the pull
    is played, and how much contrast there is around each of its ends, in frames that are in focus at either."""
    pictures, where = [], {}

    def shown():
        yield from first_drawing.settled()
        pictures.append(screen.picture())

    yield from first_drawing.opened()
    began = sorted(obj.name for obj in bpy.context.scene.objects)
    yield from first_drawing.followed(shown)
    scene = bpy.context.scene
    told = {"began": began, "place": list(scene.objects["Suzanne"].location)}
    told |= {"pictures": len(pictures) == len(pages.STEPS), "range": [scene.frame_start, scene.frame_end]}
    told["changes"] = [float(np.abs(a - b).mean()) for a, b in zip(pictures[1:], pictures[2:])]
    told["played"] = yield from played(scene)
    scene.render.resolution_percentage = 30
    drawn = {}
    for name, frame in (("cube", 1), ("monkey", first_drawing.LAST)):
        scene.frame_set(frame)
        place = places.location(scene.fovea)
        where[name] = world_to_camera_view(scene, scene.camera, place)
        drawn[name] = still(folder, name)
    told["led"] = (place - scene.objects["Suzanne"].matrix_world.translation).length
    told["contrast"] = {at: {name: contrast(drawn[name], where[at]) for name in drawn} for at in where}
    return told


def played(scene):
    """Frames that the playback shows in a while."""
    frames = set()
    scene.frame_set(1)
    with screen.override():
        bpy.ops.screen.animation_play()
    for _ in range(30):
        yield from screen.rest(0.1)
        frames.add(scene.frame_current)
    with screen.override():
        bpy.ops.screen.animation_cancel(restore_frame=False)
    return sorted(frames)


def contrast(picture, place):
    """Of the picture around a place in the camera's frame."""
    height, width = picture.shape[:2]
    x, y, reach = round(place.x * width), round(place.y * height), round(REACH * width)
    return float(picture[y - reach : y + reach, x - reach : x + reach].std())
