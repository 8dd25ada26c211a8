# SPDX-License-Identifier: GPL-3.0-or-later
"""The terrace of a cafe: bentwood chairs, round tables, a board with the menu."""

import math

import bpy
import numpy as np

from . import shapes
from .place import lettering, pipe, put
from .shapes import revolve, smooth, sweep
from .solid import Solid
from .stage import link

TABLE = 0.742  # height to put things on


def rounded(radius: float, low: float, high: float) -> list:
    """Profile of a disc with a half-round rim."""
    half = (high - low) / 2
    angle = np.linspace(-math.pi / 2, math.pi / 2, 9)
    return [(0, low), *zip(radius - half + half * np.cos(angle), low + half + half * np.sin(angle)), (0, high)]


def chair(location, turn: float):
    """Adds an instance of the chair's collection; it faces -y if `turn` (degrees about z) is 0."""
    made = link("Chair", None)
    made.instance_type = "COLLECTION"
    made.instance_collection = bpy.data.collections.get("Bentwood chair") or bentwood()
    made.location, made.rotation_euler.z = location, math.radians(turn)


def bentwood():
    """The chair as a collection outside the scene: meshes, and curves for the bent rods."""
    kept = bpy.data.collections.new("Bentwood chair")
    for part in chair_parts():
        bpy.context.scene.collection.objects.unlink(part)
        kept.objects.link(part)
    return kept


def chair_parts():
    yield put(revolve("Seat", rounded(0.205, 0.44, 0.475), 96), "beech")
    yield put(revolve("Seat ring", smooth([(0.165, 0.476), (0.15, 0.479), (0, 0.479)], 2), 96), "beech")
    back = [(-0.2, 0.24, 0), (-0.185, 0.2, 0.25), (-0.17, 0.175, 0.46), (-0.185, 0.225, 0.7), (-0.14, 0.265, 0.86)]
    yield pipe("Hoop", bent(back, (0, 0.28, 0.92)), 0.014, "beech")
    inner = [(-0.11, 0.165, 0.48), (-0.115, 0.2, 0.62), (-0.075, 0.235, 0.76)]
    yield pipe("Inner hoop", bent(inner, (0, 0.243, 0.8)), 0.011, "beech")
    for side in (-1, 1):
        leg = smooth([(side * 0.14, -0.12, 0.44), (side * 0.165, -0.15, 0.25), (side * 0.195, -0.2, 0)], 8)
        yield put(sweep("Leg", leg, np.linspace(0.016, 0.011, len(leg)), 24), "beech")
    turn = np.linspace(0, 2 * math.pi, 72, endpoint=False)
    ring = np.stack([0.155 * np.cos(turn), 0.155 * np.sin(turn), np.full_like(turn, 0.24)], axis=1)
    yield pipe("Stretcher", ring, 0.009, "beech", closed=True)


def bent(half, top):
    """A rod up one side, over the top, and down the other side."""
    return smooth([*half, top, *((-x, y, z) for x, y, z in half[::-1])], 10)


def table(location, radius: float):
    foot = [(0, 0), (0.26, 0), (0.27, 0.015), *smooth([(0.25, 0.03), (0.14, 0.05), (0.06, 0.09), (0.032, 0.16)], 5)]
    knot = smooth([(0.032, 0.3), (0.05, 0.33), (0.032, 0.36)], 5)
    head = smooth([(0.028, 0.62), (0.05, 0.67), (0.13, 0.71)], 5)
    put(revolve("Pedestal", [*foot, *knot, *head, (0, 0.71)], 64), "iron", location)
    put(revolve("Table top", rounded(radius, 0.711, 0.741), 128), "marble", location)


def board(location, turn: float):
    """A folding board with the menu in chalk."""
    lean, length, angle = math.radians(14), 0.95, math.radians(turn)
    for side in (-1, 1):
        leaf = Solid().add((-0.3, 0.3), (-0.02, 0.02), (0, length)).cut((-0.24, 0.24), (-0.03, -0.008), (0.16, 0.89))
        leaf.cut((-0.24, 0.24), (-0.03, 0.03), (0, 0.1))
        shape = shapes.moved(leaf.mesh("Menu board"), (0, side * 0.02, -length), (0, 0, 0 if side < 0 else math.pi))
        shape = shapes.moved(shape, (0, 0, length * math.cos(lean)), (lean * side, 0, 0))
        put(shape, "beech", location, turn)

    def written(down):
        """A point just in front of the slate, `down` from the board's ridge."""
        out = -0.031 * math.cos(lean) - down * math.sin(lean)
        up = 0.031 * math.sin(lean) + (length - down) * math.cos(lean)
        return (location[0] - out * math.sin(angle), location[1] + out * math.cos(angle), location[2] + up)

    lettering("Menu", "menu", 0.19, "chalk", written(0.22), turn).rotation_euler.x = math.pi / 2 - lean
    for k in range(4):  # small writing is drawn as waves
        x = np.linspace(-0.17, 0.02 + 0.15 * math.cos(k * 2.1) ** 2, 40)
        wave = np.stack([x, np.zeros_like(x), 0.018 * np.sin(x * 110) * np.cos(x * 31 + k)], axis=1)
        line = pipe("Writing", wave, 0.003, "chalk", location=written(0.42 + 0.1 * k), turn=turn)
        line.rotation_euler.x = -lean
