# SPDX-License-Identifier: GPL-3.0-or-later
"""parts, a machine put together from parts that stick into each other: none of them knows where it meets the next."""

import math

import numpy as np

from . import shapes, stage


def build(argument, shared):
    stage.clear()
    stage.frame()
    steel, brass = stage.material("Steel", (0.55, 0.58, 0.62)), stage.material("Brass", (0.7, 0.5, 0.2))
    made = [
        (shapes.box("Base", (3.2, 2.0, 0.4), rounding=0.08), steel, (0, 0, 0)),
        (shapes.revolve("Boiler", capsule(0.7, 2.4), 64), steel, (-0.2, 0, 1.0)),
        (shapes.revolve("Dome", capsule(0.35, 0.9), 48), brass, (-0.7, 0, 1.6)),
        (shapes.box("Cab", (0.9, 1.5, 1.5), rounding=0.05), steel, (1.1, 0, 0.3)),
        (shapes.sweep("Pipe", bend(), 0.11, 24), brass, (0.1, -0.55, 1.1)),
        (
            shapes.prism("Fin", [(-0.9, -0.06), (0.9, -0.06), (0.9, 0.06), (-0.9, 0.06)], 0, 1.0),
            steel,
            (-0.2, 0.0, 1.0),
        ),
    ]
    for shape, material, at in made:
        shape.materials.append(material)
        link = stage.link(shape.name, shape)
        link.location = at
    made[1][0].transform(turned(math.pi / 2))
    for x in (-1.1, -0.3, 0.9):
        for y in (-0.95, 0.95):
            wheel = shapes.revolve("Wheel", [(0, -0.1), (0.42, -0.1), (0.42, 0.1), (0, 0.1)], 48)
            wheel.materials.append(brass)
            wheel.transform(turned(0, math.pi / 2))
            stage.link("Wheel", wheel).location = (x, y, 0.1)
    stage.camera((3.4, -6.4, 4.0), (0, 0, 0.7))
    stage.sun(-60, 50)


def capsule(radius: float, length: float):
    """Profile of a cylinder with round ends, around z."""
    angle = np.linspace(-math.pi / 2, math.pi / 2, 25)
    z = radius * np.sin(angle) + np.where(angle < 0, -1, 1) * (length / 2 - radius)
    return np.stack([radius * np.cos(angle).clip(0), z], axis=1)


def bend():
    return shapes.smooth([(0, 0, 0), (0, -0.35, 0.1), (0.1, -0.45, 0.5), (0.6, -0.3, 0.9), (1.0, 0.1, 0.8)], 8)


def turned(about_y: float, about_x: float = 0.0):
    from mathutils import Matrix

    return Matrix.Rotation(about_x, 4, "X") @ Matrix.Rotation(about_y, 4, "Y")
