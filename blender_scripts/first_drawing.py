# SPDX-License-Identifier: GPL-3.0-or-later
"""Performs the steps of addon/docs/first_drawing.md in Blender's window and saves the page's pictures. Runs inside that
window (window/inside.py)."""

from pathlib import Path

import bpy
import numpy as np
import sheet
from bl_ext.user_default.fovea.render import caretaker
from bpy_extras.view3d_utils import location_3d_to_region_2d
from command import pages
from mathutils import Vector
from window import screen

LAST = 48  # frame
CUBE = (0.95, -1.0, 0.6)  # a place on the cube that the camera sees: the first focus
DIGITS = {"-": "MINUS", "3": "THREE"}  # characters that are typed -> types of their events

_at = [0, 0]  # pixel of the window where the pointer is


def steps(folder, output):
    """Scenario: saves the pictures in the folder `output`."""
    names = iter(pages.STEPS)

    def shown():
        yield from settled()
        sheet.save(smaller(screen.whole()), Path(output) / f"{next(names)}.jpg", pages.JPEG_QUALITY)

    yield from opened()
    yield from followed(shown)


def smaller(picture):
    """(H, W, 3) picture at thirteen twentieths of its size, each pixel the mean of what it covers."""
    return _fewer(_fewer(picture[..., :3], 0), 1)


def _fewer(picture, axis):
    fine = np.moveaxis(np.repeat(picture, 13, axis=axis), axis, 0)
    count = len(fine) // 20
    means = fine[: 20 * count].reshape(count, 20, *fine.shape[1:]).mean(axis=1)
    return np.moveaxis(means, 0, axis)


def opened():
    """Blender as it starts, with the render tab shown."""
    bpy.ops.wm.read_homefile(app_template="")
    yield from screen.rest(0.3)
    areas = bpy.context.window_manager.windows[0].screen.areas
    beside = next(area for area in areas if area.type == "PROPERTIES")
    beside.spaces.active.context = "RENDER"


def followed(shown):
    """Performs the page's actions from the second to the eighth. `shown()`: generator to run at each picture. What has
    a key is done by it, and what is clicked in a panel by what the click calls."""
    scene = bpy.context.scene
    yield from pointer(middle())
    with screen.override():
        bpy.ops.mesh.primitive_monkey_add()
    yield from typed("g", "x", "-", "3")
    yield from pressed("RET")
    scene.render.engine = "FOVEA"
    with screen.override():
        bpy.ops.fovea.standard_view()
    yield from shown()
    yield from pressed("NUMPAD_0")
    # Until the view has turned to the camera, the next key frames the scene, which may then lie under the sidebar.
    yield from screen.until(lambda: screen.space().region_3d.view_perspective == "CAMERA")
    yield from pressed("HOME")
    yield from screen.rest(0.5)
    screen.space().shading.type = "RENDERED"
    yield from shown()
    bpy.context.window_manager.fovea_gallery = "watercolor"
    yield from shown()
    yield from sidebar()
    yield from pressed("F", alt=True)
    yield from pointer(seen(CUBE))
    yield from pressed("LEFTMOUSE")
    yield from shown()
    scene.frame_end = LAST
    yield from pointer(middle())
    with screen.override():
        bpy.ops.fovea.focus_pull("INVOKE_DEFAULT")
    yield from screen.rest(0.5)
    yield from pressed("RET")
    scene.frame_set(LAST)
    yield from shown()


def middle():
    """The middle of the 3D viewport, in pixels of the window."""
    where = screen.region()
    return where.x + where.width // 2, where.y + where.height // 2


def seen(place):
    """Where a place of the scene is seen in the 3D viewport, in pixels of the window."""
    where = screen.region()
    px = location_3d_to_region_2d(where, screen.space().region_3d, Vector(place))
    return round(where.x + px.x), round(where.y + px.y)


def pointer(px):
    """Moves the pointer to a pixel of the window."""
    window = bpy.context.window_manager.windows[0]
    _at[:] = px
    window.event_simulate(type="MOUSEMOVE", value="NOTHING", x=px[0], y=px[1])
    yield from screen.rest(0.3)


def typed(*characters):
    for character in characters:
        yield from pressed(DIGITS.get(character, character.upper()), unicode=character)


def pressed(kind, **told):
    """Presses and releases a key or button where the pointer is."""
    window = bpy.context.window_manager.windows[0]
    for value in ("PRESS", "RELEASE"):
        words = {key: word for key, word in told.items() if key != "unicode" or value == "PRESS"}
        window.event_simulate(type=kind, value=value, x=_at[0], y=_at[1], **words)
        yield from screen.rest(0.1)


def sidebar():
    """Opens the tab Fovea of the 3D view's sidebar."""
    screen.space().show_region_ui = True
    yield from screen.rest(0.3)
    next(region for region in screen.area().regions if region.type == "UI").active_panel_category = "Fovea"


def settled():
    """Waits until the viewport is fully refined and displayed."""
    yield from screen.rest(0.5)
    yield from screen.until(lambda: not bpy.app.timers.is_registered(caretaker.tick))
    for _ in range(2):
        screen.swap()
        yield from screen.rest(0.2)
