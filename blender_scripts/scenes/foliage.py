# SPDX-License-Identifier: GPL-3.0-or-later
"""foliage:N, a tree of N cards, each with the picture of a twig whose alpha cuts its leaves out."""

import math
import random

import bpy
import numpy as np

from . import shapes, stage

PIXELS = 128  # of the picture of a twig
LEAVES = 7


def build(argument: int, shared):
    stage.clear()
    stage.frame()
    trunk = shapes.smooth([(0, 0, 0), (0.06, 0, 0.9), (-0.05, 0.05, 1.7), (0, 0, 2.6)], 8)
    wood = stage.link("Trunk", shapes.sweep("Trunk", trunk, np.linspace(0.2, 0.05, len(trunk)), 20))
    wood.data.materials.append(stage.material("Bark", (0.25, 0.17, 0.11)))
    crown = stage.link("Crown", cards(argument))
    crown.location = (0, 0, 2.4)
    crown.data.materials.append(cut_out("Twig", twig()))
    ground = stage.link("Ground", shapes.sheet("Ground", [[(-4, -4, 0), (-4, 4, 0)], [(4, -4, 0), (4, 4, 0)]]))
    ground.data.materials.append(stage.material("Meadow", (0.5, 0.55, 0.3)))
    stage.camera((1.5, -10.0, 2.8), (0, 0, 1.75))
    stage.sun(-60, 50)


def cards(count: int):
    """Squares on a ball of radius 1, turned at random, with UV coordinates."""
    draw = random.Random(3)
    corners, faces = [], np.arange(4 * count).reshape(-1, 4)
    for i in range(count):
        z = 1 - 2 * (i + 0.5) / count
        turn = i * math.pi * (3 - math.sqrt(5))
        out = np.array([math.sqrt(1 - z * z) * math.cos(turn), math.sqrt(1 - z * z) * math.sin(turn), 0.85 * z])
        along = np.array([draw.gauss(0, 1) for _ in range(3)]) + 0.8 * out
        along /= np.linalg.norm(along)
        side = np.cross(along, [draw.gauss(0, 1) for _ in range(3)])
        side /= np.linalg.norm(side)
        middle, half = out * draw.uniform(0.55, 1.0), draw.uniform(0.18, 0.26)
        corners += [middle + half * (x * side + y * along) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    made = shapes.mesh("Crown", corners, faces)
    uv = made.uv_layers.new(name="UVMap").data
    uv.foreach_set("uv", np.tile(np.array([0, 0, 1, 0, 1, 1, 0, 1], np.float32), count))
    return made


def twig():
    """An image of leaves on a stem; what is not leaf is transparent."""
    y, x = np.mgrid[:PIXELS, :PIXELS] / (PIXELS - 1.0)
    inside = (np.abs(x - 0.5) < 0.012) & (y < 0.9)
    for i in range(LEAVES):
        side = 0 if i == LEAVES - 1 else (-1) ** i
        angle = side * math.radians(52)
        base_x, base_y = 0.5, 0.12 + 0.78 * i / LEAVES if side else 0.62
        u = (x - base_x) * math.sin(angle) + (y - base_y) * math.cos(angle)
        v = (x - base_x) * math.cos(angle) - (y - base_y) * math.sin(angle)
        length = 0.36
        t = np.clip(u / length, 0, 1)
        inside |= (u > 0) & (u < length) & (np.abs(v) < 0.1 * np.sin(math.pi * t**0.8))
    image = bpy.data.images.new("Twig", PIXELS, PIXELS, alpha=True)
    pixels = np.empty((PIXELS, PIXELS, 4), np.float32)
    pixels[..., :3], pixels[..., 3] = (0.25, 0.42, 0.12), inside
    image.pixels.foreach_set(pixels.ravel())
    image.pack()
    return image


def cut_out(name: str, image):
    """A material with the color and the alpha of an image."""
    made = stage.material(name, (0.3, 0.45, 0.15))
    nodes, links = made.node_tree.nodes, made.node_tree.links
    shader, texture = nodes["Principled BSDF"], nodes.new("ShaderNodeTexImage")
    texture.image = image
    links.new(texture.outputs["Color"], shader.inputs["Base Color"])
    links.new(texture.outputs["Alpha"], shader.inputs["Alpha"])
    return made
