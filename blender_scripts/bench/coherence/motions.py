# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes with motion, keyed at every frame from 1 on. Runs inside Blender."""

import math

import bpy
import scenes
from mathutils import Matrix, Vector
from scenes import runner, stage

from ..visibility.worker import middle

ORBIT = math.radians(0.25)  # a frame
TURN = math.radians(1)
DOLLY = 0.05  # scene units a frame
PASS = 0.15  # scene units a frame
ZOOM = 4 ** (1 / 96)  # four times as large in 96 frames
STRIDE = 24  # frames of a walk cycle


def build(name, frames, shared):
    """Builds a scene with its motion over `frames` frames. `shared`: folder of models, or None."""
    by_name[name](frames, shared)
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, frames


def orbit(frames, shared):
    """The camera turns by a quarter of a degree a frame around a monkey of 63,000 triangles."""
    scenes.build("suzanne:3")
    bpy.context.view_layer.update()
    camera, center = bpy.context.scene.camera, Vector(middle(bpy.context.scene))
    start = camera.matrix_world.copy()
    around = Matrix.Translation(center), Matrix.Translation(-center)

    def pose(k):
        camera.matrix_world = around[0] @ Matrix.Rotation(k * ORBIT, 4, "Z") @ around[1] @ start

    key(camera, ("location", "rotation_euler"), frames, pose)


def turntable(frames, shared):
    """The crank arm turns by a degree a frame; without its model a bracket of a few parts."""
    stage.clear()
    stage.frame()
    model = shared / "models" / "cad" / "crank-arm.obj" if shared else None
    if model and model.is_file():
        bpy.ops.wm.obj_import(filepath=str(model))
        part = bpy.context.selected_objects[0]
    else:
        part = stage.link("Bracket", bracket())
    bpy.context.view_layer.update()
    center = Vector(middle(bpy.context.scene))
    size = max(part.dimensions)
    start, upright = part.matrix_world.copy(), Matrix.Translation(-center)
    stage.camera((0, -2.4 * size, 1.2 * size), (0, 0, 0))
    bpy.context.scene.camera.data.clip_end = 10 * size
    stage.sun(-60, 50)

    def pose(k):
        part.matrix_world = Matrix.Rotation(k * TURN, 4, "Z") @ upright @ start

    key(part, ("location", "rotation_euler"), frames, pose)


def bracket():
    from scenes import shapes

    arm = shapes.box("Bracket", (3.0, 0.8, 0.4))
    for x in (-1.1, 1.1):
        arm = shapes.combine("UNION", arm, shapes.moved(shapes.prism("Eye", ring(0.7), 0, 0.9), (x, 0, 0)))
        arm = shapes.combine("DIFFERENCE", arm, shapes.moved(shapes.prism("Bore", ring(0.35), -1, 2), (x, 0, 0)))
    return arm


def ring(radius, steps=48):
    turns = [2 * math.pi * k / steps for k in range(steps)]
    return [(radius * math.cos(a), radius * math.sin(a)) for a in turns]


def dolly(frames, shared):
    """The camera moves towards the office."""
    scenes.build("office", shared)
    camera = bpy.context.scene.camera
    start, ahead = camera.location.copy(), camera.rotation_euler.to_matrix() @ Vector((0, 0, -1))

    def pose(k):
        camera.location = start + k * DOLLY * ahead

    key(camera, ("location",), frames, pose)


def zoom(frames, shared):
    """The lens makes a machine four times as large in 96 frames."""
    scenes.build("parts")
    lens = bpy.context.scene.camera.data
    start = lens.lens

    def pose(k):
        lens.lens = start * ZOOM**k

    key(lens, ("lens",), frames, pose)


def walk(frames, shared):
    """A rigged figure walks on the spot."""
    scenes.build("runner")
    bones = bpy.data.objects["Rig"].pose.bones

    for name, (left, right) in swings().items():
        bone = bones[name]

        def pose(k, bone=bone, ends=(left, right)):
            share = 0.5 - 0.5 * math.cos(2 * math.pi * k / STRIDE)
            runner.bend(bone, ends[0] + share * (ends[1] - ends[0]))

        key(bone, ("rotation_quaternion",), frames, pose)


def swings():
    """{bone: its angles in degrees at the two ends of a stride}: a limb's other end is its pair's pose."""
    other = {".L": ".R", ".R": ".L"}
    return {
        name: (angle, runner.POSE[name[:-2] + other.get(name[-2:], name[-2:])]) for name, angle in runner.POSE.items()
    }


def passing(frames, shared):
    """A pole passes before a rack."""
    from scenes import shapes

    stage.clear()
    stage.frame()
    for k in range(6):
        stage.link("Shelf", shapes.box("Shelf", (7.0, 0.6, 0.12), (0, 0, 0.6 * k)))
    pole = stage.link("Pole", shapes.box("Pole", (0.5, 0.5, 6.0), (0, -2.0, -1.5)))
    stage.camera((0, -9, 3.2), (0, 0, 1.4))
    stage.sun(-60, 50)

    def pose(k):
        pole.location.x = PASS * (k + 0.5 - 0.5 * frames)

    key(pole, ("location",), frames, pose)


def key(owner, paths, frames, pose):
    """Keys properties at each frame, as pose(k) leaves them k frames after the first."""
    for k in range(frames):
        pose(k)
        for path in paths:
            owner.keyframe_insert(path, frame=k + 1)


by_name = {"orbit": orbit, "turntable": turntable, "dolly": dolly, "zoom": zoom, "walk": walk, "passing": passing}
