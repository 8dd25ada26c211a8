# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions that add objects to the scene. `paint`: a name in the palette."""

import math

import bpy

from .palette import paint as material
from .stage import link


def put(shape, paint: str | None, location=(0, 0, 0), turn: float = 0.0, scale: float = 1.0):
    """Adds an object with a mesh, which other objects may share; `turn`: degrees about z. `paint` applies only if the
    mesh has no material."""
    if paint and not shape.materials:
        shape.materials.append(material(paint))
    made = link(shape.name, shape)
    made.location = location
    made.rotation_euler.z = math.radians(turn)
    made.scale = (scale,) * 3
    return made


def pipe(name: str, points, radius: float, paint: str, closed: bool = False, location=(0, 0, 0), turn: float = 0.0):
    """Adds a curve object: a round bar through the points."""
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "3D"
    data.bevel_depth, data.use_fill_caps = radius, not closed
    data.bevel_resolution = 8  # 20 sides: angles of 18 degrees, below the crease angle
    line = data.splines.new("POLY")
    line.points.add(len(points) - 1)
    line.points.foreach_set("co", [x for point in points for x in (*point, 1.0)])
    line.use_cyclic_u = closed
    data.materials.append(material(paint))
    made = link(name, data)
    made.location, made.rotation_euler.z = location, math.radians(turn)
    return made


def lettering(name: str, body: str, height: float, paint: str, location, turn: float = 0.0):
    """Adds a flat, upright, centered text object, readable from -y if `turn` (degrees about z) is 0."""
    data = bpy.data.curves.new(name, "FONT")
    data.body, data.size = body, height
    data.align_x, data.align_y = "CENTER", "CENTER"
    data.materials.append(material(paint))
    made = link(name, data)
    made.location, made.rotation_euler = location, (math.pi / 2, 0, math.radians(turn))
    return made
