# SPDX-License-Identifier: GPL-3.0-or-later
"""runner, a figure of limbs on an armature: one smooth mesh, subdivided, that its bones bend, in mid-stride."""

import math

import bpy
import numpy as np
from mathutils import Matrix, Vector

from . import shapes, stage


def limb_pair(limb, parent, head, tail, thick):
    """Bones of a left and a right limb, mirrored in x. `parent` may name {side}."""
    for side, x in (("L", 1), ("R", -1)):
        ends = tuple((x * end[0], *end[1:]) for end in (head, tail))
        yield f"{limb}.{side}", (parent.format(side=side), *ends, thick)


BONES = {  # name: (parent, head, tail, thickness at head and tail)
    "spine": (None, (0, 0, 1.0), (0, 0, 1.5), (0.15, 0.19)),
    "head": ("spine", (0, 0, 1.58), (0, -0.02, 1.82), (0.1, 0.1)),
    **dict(limb_pair("thigh", "spine", (0.1, 0, 0.98), (0.1, 0, 0.54), (0.1, 0.07))),
    **dict(limb_pair("shin", "thigh.{side}", (0.1, 0, 0.54), (0.1, 0, 0.1), (0.065, 0.045))),
    **dict(limb_pair("foot", "shin.{side}", (0.1, 0.04, 0.06), (0.1, -0.16, 0.04), (0.05, 0.04))),
    **dict(limb_pair("arm", "spine", (0.22, 0, 1.46), (1.25 * 0.22, 0, 1.18), (0.065, 0.05))),
    **dict(limb_pair("hand", "arm.{side}", (1.25 * 0.22, 0, 1.18), (1.3 * 0.22, 0, 0.86), (0.048, 0.035))),
}
POSE = {  # degrees forwards
    "spine": 12, "head": -8,
    "thigh.L": 48, "shin.L": -70, "foot.L": 10, "arm.L": -55, "hand.L": 75,
    "thigh.R": -32, "shin.R": -45, "foot.R": -15, "arm.R": 50, "hand.R": 85,
}  # fmt: skip


def build(argument, shared):
    stage.clear()
    stage.frame()
    rig = armature()
    limbs, of_bone = [], []
    for name, (_, head, tail, thick) in BONES.items():
        limb = shapes.sweep(name, spindle(head, tail), taper(*thick), 16)
        limbs.append(limb)
        of_bone += [name] * len(limb.vertices)
    body = stage.link("Body", shapes.joined("Body", limbs))
    body.data.materials.append(stage.material("Clay", (0.75, 0.55, 0.42)))
    body.data.shade_smooth()
    for name in BONES:
        body.vertex_groups.new(name=name).add([i for i, owner in enumerate(of_bone) if owner == name], 1.0, "REPLACE")
    bend = body.modifiers.new("Armature", "ARMATURE")
    bend.object = rig
    body.modifiers.new("Subdivision", "SUBSURF").render_levels = 2
    ground = shapes.sheet("Ground", [[(-3, -3, 0), (-3, 3, 0)], [(3, -3, 0), (3, 3, 0)]])
    stage.link("Ground", ground).data.materials.append(stage.material("Track", (0.6, 0.35, 0.25)))
    stage.camera((-4.6, -2.2, 1.5), (0, 0, 0.95))
    stage.sun(-120, 50)


def armature():
    rig = stage.link("Rig", bpy.data.armatures.new("Rig"))
    bpy.context.view_layer.objects.active = rig
    bpy.ops.object.mode_set(mode="EDIT")
    for name, (parent, head, tail, _) in BONES.items():
        bone = rig.data.edit_bones.new(name)
        bone.head, bone.tail, bone.roll = head, tail, 0.0
        bone.parent = rig.data.edit_bones[parent] if parent else None
    bpy.ops.object.mode_set(mode="OBJECT")
    for name, degrees in POSE.items():
        bend(rig.pose.bones[name], degrees)
    return rig


def bend(bone, degrees):
    """Turns a pose bone forwards, about the figure's left-right axis."""
    axis = bone.bone.matrix_local.to_3x3().inverted() @ Vector((1, 0, 0))
    bone.rotation_mode = "QUATERNION"
    bone.rotation_quaternion = Matrix.Rotation(math.radians(-degrees), 3, axis).to_quaternion()


def spindle(head, tail, steps: int = 9):
    """Points from a little before the head to a little behind the tail, so that limbs overlap at joints."""
    head, tail = np.array(head, float), np.array(tail, float)
    return head + (tail - head) * np.linspace(-0.12, 1.12, steps)[:, None]


def taper(first: float, last: float, steps: int = 9):
    t = np.linspace(0, 1, steps)
    return (first + (last - first) * t) * np.sqrt(np.clip(1 - (2 * t - 1) ** 8, 0.05, 1))
