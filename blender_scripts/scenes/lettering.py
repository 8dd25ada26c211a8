# SPDX-License-Identifier: GPL-3.0-or-later
"""lettering, text as Blender has it: flat, extruded, bevelled, on a curve, small, and on a plate it is cut into."""

import math

import bpy
import numpy as np

from . import shapes, stage


def build(argument, shared):
    stage.clear()
    stage.frame()
    paint = stage.material("Paint", (0.7, 0.2, 0.12))
    plate = shapes.box("Plate", (4.2, 0.16, 1.5), rounding=0.05)
    plate.materials.append(stage.material("Enamel", (0.85, 0.85, 0.8)))
    stage.link("Plate", plate).location = (0, 0.1, 0)
    bevelled = text("Bevelled", "FOVEA", 0.9, (0, 0.03, 0.65), paint, extrude=0.08, bevel=0.025)
    bevelled.data.space_character = 1.1  # the bevels of its letters would overlap
    text("Flat", "lines · light · letters", 0.3, (0, 0.018, 0.29), paint)
    text("Small", "A line is a dot that went for a walk.", 0.11, (0, 0.018, 0.09), paint)
    bow = bpy.data.curves.new("Bow", "CURVE")
    bow.dimensions = "3D"
    angle = np.linspace(math.radians(150), math.radians(30), 40)
    points = np.stack([2.2 * np.cos(angle), 2.2 * np.sin(angle) + 0.65, 0 * angle, 1 + 0 * angle], axis=1)
    spline = bow.splines.new("POLY")
    spline.points.add(len(points) - 1)
    spline.points.foreach_set("co", points.ravel())
    bent = text("Bent", "drawn by hand and by rule", 0.38, (0, 0, 0), paint, extrude=0.03)
    bent.data.follow_curve = stage.link("Bow", bow)
    bent.data.follow_curve.rotation_euler = bent.rotation_euler
    bent.data.align_x = "LEFT"
    floor = shapes.sheet("Floor", [[(-4, -3, 0), (-4, 3, 0)], [(4, -3, 0), (4, 3, 0)]])
    stage.link("Floor", floor)
    stage.camera((2.0, -9.3, 2.7), (0, 0, 1.5))
    stage.sun(-60, 50)


def text(name: str, body: str, size: float, at, material, extrude: float = 0.0, bevel: float = 0.0):
    data = bpy.data.curves.new(name, "FONT")
    data.body, data.size, data.extrude, data.bevel_depth, data.align_x = body, size, extrude, bevel, "CENTER"
    data.materials.append(material)
    made = stage.link(name, data)
    made.location, made.rotation_euler = at, (math.pi / 2, 0, 0)
    return made
