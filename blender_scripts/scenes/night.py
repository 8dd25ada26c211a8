# SPDX-License-Identifier: GPL-3.0-or-later
"""night, a bench under a street lamp: one spot light in a dark world."""

import math

import bpy

from . import plants, shapes, stage
from .shapes import smooth


def build(argument, shared):
    stage.clear()
    stage.frame()
    bpy.context.scene.world.color = (0.02, 0.03, 0.06)
    iron, wood = stage.material("Iron", (0.12, 0.13, 0.15)), stage.material("Wood", (0.4, 0.24, 0.12))
    post = smooth([(0, 0, 0), (0, 0, 1.5), (0, 0, 2.8), (0.2, 0, 3.15), (0.55, 0, 3.1)], 10)
    add(shapes.sweep("Post", post, 0.05, 16), iron)
    shade = [(0, 0.18), (0.06, 0.18), (0.3, 0), (0.28, 0), (0.05, 0.15), (0, 0.15)]
    add(shapes.revolve("Shade", shade, 48), iron, (0.55, 0, 2.9))
    add(shapes.ball("Bulb", 0.09, 24), stage.material("Glass", (1.0, 0.9, 0.6)), (0.55, 0, 2.92))
    for i in range(4):
        add(shapes.box("Slat", (1.6, 0.1, 0.04), rounding=0.01), wood, (0.9, -0.15 + 0.14 * i, 0.45))
    for i in range(3):
        add(shapes.box("Back", (1.6, 0.04, 0.1), rounding=0.01), wood, (0.9, 0.42 + 0.03 * i, 0.6 + 0.14 * i))
    for x in (0.25, 1.55):
        add(shapes.box("Leg", (0.06, 0.6, 0.45)), iron, (x, 0.1, 0))
    add(shapes.box("Wall", (9, 0.3, 1.4)), stage.material("Stone", (0.5, 0.48, 0.45)), (0, 2.2, 0))
    plants.tree((-1.9, 1.2, 0), 1.3, 0.9, 4, 20)
    floor = shapes.sheet("Pavement", [[(-6, -4, 0), (-6, 6, 0)], [(6, -4, 0), (6, 6, 0)]])
    add(floor, stage.material("Pavement", (0.5, 0.5, 0.5)))
    light = bpy.data.lights.new("Lamp", "SPOT")
    light.energy, light.spot_size, light.spot_blend, light.color = 900, math.radians(95), 0.6, (1.0, 0.82, 0.5)
    made = stage.link("Lamp", light)
    made.location = (0.55, 0, 2.85)
    stage.camera((2.8, -8.6, 1.7), (0.0, 0.2, 1.55))


def add(shape, material, at=(0, 0, 0)):
    shape.materials.append(material)
    stage.link(shape.name, shape).location = at
