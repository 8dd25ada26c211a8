# SPDX-License-Identifier: GPL-3.0-or-later
"""Performs the steps of addon/docs/first_drawing.md in Blender's window and saves the page's pictures. Runs inside that
window (window/inside.py)."""

import subprocess
from pathlib import Path

import bpy
import sheet
from bl_ext.user_default.fovea.render import caretaker
from command import pages
from window import screen

LAST = 48  # frame
DOOR = (0.475, 0.4)  # first focus, as fractions of the viewport's width and height


def steps(folder, output):
    """Scenario: saves the pictures in the folder `output`."""
    names = iter(pages.STEPS)

    def shown():
        yield from settled()
        sheet.save(screen.whole(), Path(output) / f"{next(names)}.jpg")

    yield from opened(folder)
    yield from followed(shown)


def opened(folder):
    """Opens the demo scene, written by `fovea scene`, in Blender's default window, with the render tab shown."""
    path, script = str(folder / "demo.blend"), Path(__file__).with_name("save_scene.py")
    subprocess.run([bpy.app.binary_path, "-b", "-P", str(script), "--", "demo", "-o", path], check=True)
    bpy.ops.wm.open_mainfile(filepath=path, load_ui=False)
    yield from screen.rest(0.3)
    areas = bpy.context.window_manager.windows[0].screen.areas
    beside = next(area for area in areas if area.type == "PROPERTIES")
    beside.spaces.active.context = "RENDER"


def followed(shown):
    """Performs the page's actions from the second to the eighth. `shown()`: generator to run at each picture."""
    scene = bpy.context.scene
    with screen.override():
        bpy.ops.view3d.view_camera()
    screen.space().region_3d.view_camera_zoom = 29.0  # the frame fills the viewport
    scene.render.engine = "FOVEA"
    yield from shown()
    screen.space().shading.type = "RENDERED"
    yield from shown()
    with screen.override():
        bpy.ops.fovea.style_apply(style="watercolor")
    yield from shown()
    yield from sidebar()
    where = screen.region()
    with screen.override():
        bpy.ops.fovea.pick_focus("EXEC_DEFAULT", x=round(DOOR[0] * where.width), y=round(DOOR[1] * where.height))
    yield from shown()
    with screen.override():
        bpy.ops.fovea.focus_pull("EXEC_DEFAULT", target="OBJECT", object="Bicycle", frame_start=1, frame_end=LAST)
    scene.frame_set(LAST)
    yield from shown()


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
