# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of the focus tools with pointer events, in a window; see inside.py. Tests check what a scenario returns."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1] / "blender"))

import bpy
import numpy as np
from bpy_extras.view3d_utils import location_3d_to_region_2d
from mathutils import Vector
from the_addon import add_camera, box_mesh, new_object, part
from window import screen

places, operators = part("focus.focus_places"), part("focus.focus_operators")


def opened(engine="FOVEA"):
    """A box in a 3D viewport that fills the window, seen from above, in Solid shading."""
    scene = bpy.context.scene
    for obj in list(scene.objects):
        bpy.data.objects.remove(obj)
    scene.render.engine = engine
    new_object(box_mesh(), "Box")
    new_object(box_mesh(), "Far", (4, 0, 0))
    add_camera((0, 0, 20), (0, 0, 0))
    yield from filled()
    space = screen.space()
    space.shading.type, space.overlay.show_floor = "SOLID", False
    view = space.region_3d
    view.view_perspective, view.view_rotation, view.view_distance = "PERSP", (1, 0, 0, 0), 16
    view.view_location = (0, 0, 0)
    yield from screen.rest(0.3)
    with screen.override():
        bpy.ops.ed.undo_push(message="start")
    return scene


def filled():
    """A 3D viewport over the whole window, with overlays and gizmos."""
    yield from screen.fill()
    screen.space().overlay.show_overlays = screen.space().show_gizmo = True


def pixel(at):
    """Pixels of the region where a place in the scene is seen."""
    return location_3d_to_region_2d(screen.region(), screen.space().region_3d, Vector(at))


def look():
    with screen.override():
        return operators.look(bpy.context)


def move(px):
    """Moves the pointer to pixels of the region."""
    where = screen.region()
    event(type="MOUSEMOVE", value="NOTHING", x=round(where.x + px[0]), y=round(where.y + px[1]))


def event(**told):
    bpy.context.window_manager.windows[0].event_simulate(**told)


def click(px, **keys):
    move(px)
    yield from screen.rest(0.1)
    where = screen.region()
    x, y = round(where.x + px[0]), round(where.y + px[1])
    for value in ("PRESS", "RELEASE"):
        event(type="LEFTMOUSE", value=value, x=x, y=y, **keys)
        yield from screen.rest(0.1)


def drag(start, end):
    where = screen.region()
    a, b = ((round(where.x + px[0]), round(where.y + px[1])) for px in (start, end))
    for _ in range(2):
        move(start)
        yield from screen.rest(0.15)
    event(type="LEFTMOUSE", value="PRESS", x=a[0], y=a[1])
    yield from screen.rest(0.1)
    for step in np.linspace(0.1, 1, 10):
        move(Vector(start).lerp(Vector(end), step))
        yield from screen.rest(0.03)
    event(type="LEFTMOUSE", value="RELEASE", x=b[0], y=b[1])
    yield from screen.rest(0.2)


def invoke_pick():
    with screen.override():
        bpy.ops.fovea.pick_focus("INVOKE_DEFAULT")
    yield from screen.rest(0.1)


def state():
    """What the focus is."""
    settings = bpy.context.scene.fovea
    found = [list(places.location(place)) for place in places.places(settings)]
    radii = [settings.focus_near_distance, settings.focus_far_distance]
    return {"model": settings.focus_model, "places": found, "radii": radii, "objects": len(bpy.context.scene.objects)}


def picking(folder):
    """A click on a box, one beside it, Shift click on another box, Escape; then all is undone."""
    yield from opened()
    told = {"before": state()}
    yield from invoke_pick()
    yield from click((30, 30))
    told["missed"] = state()
    yield from click(pixel((0.5, 0.5, 1)))
    told["hit"] = state()
    yield from invoke_pick()
    yield from click(pixel((4, 0, 1)), shift=True)
    told["added"] = state()
    yield from invoke_pick()
    yield from key("ESC", 200, 200)
    told["left"] = state()
    yield from click((30, 30))
    with screen.override():
        bpy.ops.ed.undo()
    yield from screen.rest(0.2)
    with screen.override():
        bpy.ops.ed.undo()
    yield from screen.rest(0.2)
    told["undone"] = state()
    return told


def tool(folder):
    """The key chooses the tool of the toolbar; clicks and Shift clicks pick, without asking for another click."""
    yield from opened()
    where = screen.region()
    x, y = where.x + 200, where.y + 200
    move((200, 200))
    yield from screen.rest(0.2)
    event(type="F", value="PRESS", x=x, y=y, alt=True)
    yield from screen.rest(0.1)
    event(type="F", value="RELEASE", x=x, y=y, alt=True)
    yield from screen.rest(0.3)
    told = {"tool": bpy.context.workspace.tools.from_space_view3d_mode("OBJECT").idname}
    yield from click(pixel((0.5, 0.5, 1)))
    told["clicked"] = state()
    yield from click(pixel((4, 0, 1)), shift=True)
    told["added"] = state()
    yield from click((30, 30))
    told["missed"] = state()
    screen.space().show_region_toolbar = True
    yield from screen.rest(0.5)
    np.save(folder / "tool.npy", screen.whole())
    return told


def in_camera(folder):
    """A click and drags in camera view, where the place is one of the image."""
    scene = yield from opened()
    scene.fovea.focus_model = "IMAGE"
    screen.space().region_3d.view_perspective = "CAMERA"
    yield from screen.rest(0.3)
    left, lower, width, height = look().frame
    yield from invoke_pick()
    yield from click((left + 0.25 * width, lower + 0.5 * height))
    told = {"picked": list(scene.fovea.focus_place)}
    with screen.override():
        bpy.ops.ed.undo_push(message="picked")
    yield from drag((left + 0.25 * width, lower + 0.5 * height), (left + 0.5 * width, lower + 0.75 * height))
    told["moved"] = list(scene.fovea.focus_place)
    near = scene.fovea.focus_near * height
    middle = Vector((left + 0.5 * width, lower + 0.75 * height))
    yield from drag(middle + Vector((0, -near)), middle + Vector((0, -0.2 * height)))
    told["near"] = scene.fovea.focus_near
    np.save(folder / "camera.npy", screen.picture())
    with screen.override():
        bpy.ops.ed.undo()
    yield from screen.rest(0.2)
    told["undone"] = bpy.context.scene.fovea.focus_near
    return told


def rings(folder):
    """The rings of a place in the scene are seen and dragged, and hidden where they do not apply."""
    scene = yield from opened()
    scene.fovea.focus_model, scene.fovea.focus_location = "SCENE", (0, 0, 0)
    scene.fovea.focus_near_distance, scene.fovea.focus_far_distance = 2, 4
    yield from screen.rest(0.3)
    screen.swap()
    told, shown = {}, screen.picture()
    np.save(folder / "rings.npy", shown)
    kind = part("focus.focus_kinds").of(scene.fovea)
    middle, unit = look().center(scene.fovea, kind), look().unit(scene.fovea, kind)
    yield from drag(middle + Vector((0, 4 * unit)), middle + Vector((0, 5 * unit)))
    told["far"] = scene.fovea.focus_far_distance
    yield from drag(middle + Vector((0, -2 * unit)), middle + Vector((0, -unit)))
    told["near"] = scene.fovea.focus_near_distance
    yield from drag(middle, middle + Vector((unit, 0)))
    told["location"] = list(scene.fovea.focus_location)
    scene.fovea.focus_near_distance, scene.fovea.focus_far_distance = 2, 4
    scene.fovea.focus_location = (0, 0, 0)
    for name, act in (
        ("no overlays", lambda: setattr(screen.space().overlay, "show_overlays", False)),
        ("shown again", lambda: setattr(screen.space().overlay, "show_overlays", True)),
        ("other engine", lambda: setattr(scene.render, "engine", "BLENDER_WORKBENCH")),
    ):
        act()
        move((5, 5))
        yield from screen.rest(0.3)
        screen.swap()
        told[name] = int(orange(screen.picture()).sum())
    return told


def orange(picture):
    """Which pixels have the color of the near ring."""
    return (picture[..., 0] > 0.8) & (picture[..., 2] < 0.35) & (picture[..., 1] > 0.35) & (picture[..., 1] < 0.75)


def searched(folder):
    """What F3 finds: the pick, which then waits for a click; and the report's popup."""
    yield from opened()
    where = screen.region()
    x, y = where.x + 100, where.y + 100
    move((100, 100))
    yield from screen.rest(0.2)
    yield from key("F3", x, y)
    for letter in "pick focus":
        yield from key("SPACE" if letter == " " else letter.upper(), x, y, unicode=letter)
    yield from screen.rest(0.5)
    screen.swap()
    np.save(folder / "search.npy", screen.picture())
    yield from key("RET", x, y)
    yield from screen.rest(0.3)
    yield from click(pixel((0.5, 0.5, 1)))
    told = state()
    with screen.override():
        bpy.ops.fovea.report("INVOKE_DEFAULT")
    yield from screen.rest(0.5)
    screen.swap()
    np.save(folder / "report.npy", screen.picture())
    yield from key("ESC", x, y)
    return told | {"texts": bpy.data.texts.keys()}


def key(kind, x, y, **told):
    event(type=kind, value="PRESS", x=x, y=y, **told)
    yield from screen.rest(0.05)
    event(type=kind, value="RELEASE", x=x, y=y)
    yield from screen.rest(0.05)
