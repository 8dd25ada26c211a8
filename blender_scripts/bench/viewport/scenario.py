# SPDX-License-Identifier: GPL-3.0-or-later
"""The scenario of `fovea bench viewport`; see ../../window/inside.py."""

import math
import statistics
import time
from pathlib import Path

import bpy
import scenes
from bl_ext.user_default.fovea.render import session, viewport
from bl_ext.user_default.fovea.style import style_data
from mathutils import Quaternion
from window import screen

STEP = math.radians(2)
TURNS = 3  # alternations of Solid and Rendered


def measure(_folder, spec, shared, frames, style, rest):
    turn = math.ceil(int(frames) / TURNS)
    scenes.build(spec, Path(shared) if shared else None)
    bpy.context.scene.render.engine = "FOVEA"
    if style:
        style_data.use(bpy.context.scene, style)
    yield from screen.fill()
    space, view, clock = screen.space(), screen.space().region_3d, Clock()
    view.view_perspective = "PERSP"
    view.view_rotation = bpy.context.scene.camera.matrix_world.to_quaternion()
    for obj in bpy.context.scene.objects:
        obj.select_set(obj.type == "MESH")
    with screen.override():
        bpy.ops.view3d.view_selected()
    yield from screen.rest(1.0)
    told = {"scene": spec, "triangles": triangles(), "idle_solid": (yield from idle(rest))}
    orbit(view, 5)

    start = time.perf_counter()
    space.shading.type = "RENDERED"
    while not (clock.viewport and clock.viewport.shown):
        clock.held(screen.swap)
    told["first_ms"] = 1000 * (time.perf_counter() - start)
    yield from refined(clock)
    told["refined_ms"] = 1000 * (time.perf_counter() - start)

    times, pictures = {"SOLID": [], "RENDERED": []}, 0
    for _ in range(TURNS):
        for shading in times:
            space.shading.type = shading
            orbit(view, 2)  # warm-up
            clock.pictures = set()
            times[shading] += orbit(view, turn)
        pictures += len(clock.pictures)
    stages, clock.block = session.last_statistics()["stages"], max(clock.block, *times["RENDERED"])
    space.shading.type = "RENDERED"
    orbit(view, 5)
    yield from refined(clock)
    solid, fovea = (statistics.median(times[shading]) for shading in ("SOLID", "RENDERED"))
    told |= {"solid_ms": solid, "fovea_ms": fovea, "ratio": fovea / solid}
    told |= {"new": pictures / len(times["RENDERED"])}
    told |= {"drawing_ms": clock.drawing, "block_ms": clock.block}
    clock.draws = 0
    yield from screen.rest(0.5)
    told |= {"idle": (yield from idle(rest)), "idle_draws": clock.draws}
    rounded = {name: round(value, 2) if isinstance(value, float) else value for name, value in told.items()}
    return rounded | {"stages": stages}


def orbit(view, frames):
    """Orbits the view; list of the ms of each frame."""
    times = []
    for _ in range(frames):
        view.view_rotation = Quaternion((0, 0, 1), STEP) @ view.view_rotation
        start = time.perf_counter()
        screen.swap()
        times.append(1000 * (time.perf_counter() - start))
    return times


def idle(seconds):
    """CPU time of this process over so many idle seconds, as a share of one core."""
    start, used = time.perf_counter(), time.process_time()
    yield float(seconds)
    return (time.process_time() - used) / (time.perf_counter() - start)


def triangles():
    depsgraph = bpy.context.evaluated_depsgraph_get()
    meshes = (instance.object.data for instance in depsgraph.object_instances if instance.object.type == "MESH")
    return sum(len(mesh.loop_triangles) for mesh in meshes)


def refined(clock):
    """Waits for the final picture while Blender's main loop runs."""
    while not clock.viewport.is_final():
        start = time.perf_counter()
        yield
        clock.block = max(clock.block, 1000 * (time.perf_counter() - start))
    screen.swap()


class Clock:
    """Longest blocking of the interface, in ms: `drawing`, by Fovea's draw function; `block`, by anything."""

    def __init__(self):
        self.viewport, self.draws, self.drawing, self.block = None, 0, 0.0, 0.0
        self.pictures = set()  # keys of the pictures shown
        self._old, viewport.draw = viewport.draw, self._draw

    def _draw(self, engine, context, depsgraph):
        self.drawing = max(self.drawing, self._time(self._old, engine, context, depsgraph))
        self.viewport, self.draws = engine.viewport, self.draws + 1
        if self.viewport.shown:
            self.pictures.add(self.viewport.shown.wanted.key)

    def held(self, act):
        self.block = max(self.block, self._time(act))

    @staticmethod
    def _time(act, *arguments):
        start = time.perf_counter()
        act(*arguments)
        return 1000 * (time.perf_counter() - start)
