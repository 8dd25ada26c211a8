# SPDX-License-Identifier: GPL-3.0-or-later
"""scan:L, a monkey as a scanner sees it: L levels of subdivision, each vertex a little off, faces shaded flat."""

import bpy
import numpy as np

from . import stage

NOISE = 0.02  # standard deviation, in edges of the mesh


def build(argument: int, shared):
    stage.clear()
    stage.frame()
    bpy.ops.mesh.primitive_monkey_add()
    monkey = bpy.context.object
    subdivision = monkey.modifiers.new("Subdivision", "SUBSURF")
    subdivision.levels = subdivision.render_levels = argument
    mesh = bpy.data.meshes.new_from_object(monkey.evaluated_get(bpy.context.evaluated_depsgraph_get()))
    bpy.data.objects.remove(monkey)
    points = np.empty((len(mesh.vertices), 3), np.float32)
    mesh.vertices.foreach_get("co", points.ravel())
    edge = 0.25 / 2**argument  # about the mean length
    points += np.random.RandomState(1).normal(0, NOISE * edge, points.shape).astype(np.float32)
    mesh.vertices.foreach_set("co", points.ravel())
    mesh.shade_flat()
    mesh.materials.clear()
    mesh.materials.append(stage.material("Plaster", (0.75, 0.72, 0.68)))
    stage.link("Scan", mesh)
    stage.camera((3.0, -5.8, 1.1), (0, 0, -0.05))
    stage.sun(-60, 50)
