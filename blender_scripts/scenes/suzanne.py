# SPDX-License-Identifier: GPL-3.0-or-later
"""suzanne:L, the smooth case: the monkey with L levels of subdivision applied (5 levels: a million triangles)."""

import bpy

from . import stage


def build(argument: int, shared):
    stage.clear()
    stage.frame()
    bpy.ops.mesh.primitive_monkey_add()
    monkey = bpy.context.object
    if argument:
        subdivide = monkey.modifiers.new("Subdivision", "SUBSURF")
        subdivide.levels = subdivide.render_levels = argument
        bpy.ops.object.modifier_apply(modifier=subdivide.name)
    monkey.data.shade_smooth()
    monkey.data.materials.append(stage.material("Clay", (0.75, 0.55, 0.42)))
    stage.camera((3.2, -4.2, 2), (0, 0, 0))
    stage.sun(-60, 50)
