"""The pictures of addon/docs/first_drawing.md: Blender's own window while the demo scene is drawn step by step. Runs
inside that window (window/inside.py)."""

from pathlib import Path

import bpy
import scenes
import sheet
from bl_ext.user_default.fovea.blender import caretaker
from command import pages
from window import screen

LAST = 48  # frame
DOOR = (0.475, 0.4)  # of the viewport: where one shall look first


def steps(_folder, output):
    """The pictures, in the folder `output`."""
    scene, names = bpy.context.scene, iter(pages.STEPS)

    def shown():
        yield from settled()
        sheet.save(screen.whole(), Path(output) / f"{next(names)}.jpg")

    yield from opened(scene)
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
    scene.frame_end = LAST
    scene.frame_set(LAST)
    yield from shown()


def opened(scene):
    """The demo scene in the camera's view, the render tab beside it."""
    for obj in list(scene.objects):
        bpy.data.objects.remove(obj)
    scenes.build("demo", None)
    scene.render.fps = 24
    view = screen.space().region_3d
    view.view_perspective = "CAMERA"
    view.view_camera_zoom = 29.0  # the frame fills the viewport
    areas = bpy.context.window_manager.windows[0].screen.areas
    beside = next(area for area in areas if area.type == "PROPERTIES")
    yield from screen.rest(0.3)
    beside.spaces.active.context = "RENDER"


def sidebar():
    """The tab Fovea of the 3D view's sidebar."""
    screen.space().show_region_ui = True
    yield from screen.rest(0.3)
    next(region for region in screen.area().regions if region.type == "UI").active_panel_category = "Fovea"


def settled():
    """Waits until the window shows all."""
    yield from screen.rest(0.5)
    yield from screen.until(lambda: not bpy.app.timers.is_registered(caretaker.tick))
    for _ in range(2):
        screen.swap()
        yield from screen.rest(0.2)
