"""What stands before a cafe: bentwood chairs, round tables, a tea set, a board with the menu."""

import math

import bpy
import numpy as np

from . import shapes, stage
from .shapes import combine, revolve, smooth, sweep
from .solid import Solid

BEECH = (0.45, 0.27, 0.15)
MARBLE = (0.88, 0.87, 0.84)
CHINA = (0.93, 0.94, 0.95)
IRON = (0.13, 0.14, 0.15)
SLATE = (0.2, 0.23, 0.24)


def rounded(radius: float, low: float, high: float, hollow: float = 0.0) -> list:
    """Profile of a disc with a half-round rim."""
    half = (high - low) / 2
    angle = np.linspace(-math.pi / 2, math.pi / 2, 9)
    return [(hollow, low), *zip(radius - half + half * np.cos(angle), low + half + half * np.sin(angle)), (hollow, high)]


def chair_parts():
    """A bentwood chair that looks to -y, as a collection to instance: meshes, and curves for what is bent."""
    wood = stage.material("Beech", BEECH)
    parts = [stage.put(revolve("Seat", rounded(0.205, 0.44, 0.475), 96), wood, name="Seat")]
    dish = smooth([(0.165, 0.476), (0.15, 0.479), (0.0, 0.479)], 2)
    parts.append(stage.put(revolve("Seat ring", dish, 96), wood))
    hoop = smooth([(-0.2, 0.24, 0), (-0.185, 0.2, 0.25), (-0.17, 0.175, 0.46), (-0.185, 0.225, 0.7), (-0.14, 0.265, 0.86), (0, 0.28, 0.92),
                   (0.14, 0.265, 0.86), (0.185, 0.225, 0.7), (0.17, 0.175, 0.46), (0.185, 0.2, 0.25), (0.2, 0.24, 0)], 10)
    parts.append(stage.pipe("Hoop", hoop, 0.014, wood))
    inner = smooth([(-0.11, 0.165, 0.48), (-0.115, 0.2, 0.62), (-0.075, 0.235, 0.76), (0, 0.243, 0.8), (0.075, 0.235, 0.76), (0.115, 0.2, 0.62), (0.11, 0.165, 0.48)], 10)
    parts.append(stage.pipe("Inner hoop", inner, 0.011, wood))
    for side in (-1, 1):
        leg = smooth([(side * 0.14, -0.12, 0.44), (side * 0.165, -0.15, 0.25), (side * 0.195, -0.2, 0)], 8)
        parts.append(stage.put(sweep("Leg", leg, np.linspace(0.016, 0.011, len(leg)), 24), wood))
    turn = np.linspace(0, 2 * math.pi, 73)[:-1]
    parts.append(stage.pipe("Stretcher", np.stack([0.155 * np.cos(turn), 0.155 * np.sin(turn), np.full_like(turn, 0.24)], axis=1), 0.009, wood, closed=True))
    kept = bpy.data.collections.new("Bentwood chair")
    for part in parts:
        bpy.context.scene.collection.objects.unlink(part)
        kept.objects.link(part)
    return kept


def chair(location, turn: float):
    kept = bpy.data.collections.get("Bentwood chair") or chair_parts()
    made = stage.link("Chair", None)
    made.instance_type, made.instance_collection = "COLLECTION", kept
    made.location, made.rotation_euler.z = location, math.radians(turn)


def table(location, radius: float = 0.38):
    foot = [(0, 0), (0.26, 0), (0.27, 0.015), *smooth([(0.25, 0.03), (0.14, 0.05), (0.06, 0.09), (0.032, 0.16)], 5), (0.032, 0.3)]
    column = [*smooth([(0.032, 0.3), (0.05, 0.33), (0.032, 0.36)], 5), (0.028, 0.62), *smooth([(0.028, 0.62), (0.05, 0.67), (0.13, 0.71)], 5), (0, 0.71)]
    stage.put(revolve("Pedestal", [*foot, *column], 64), stage.material("Iron", IRON), location)
    stage.put(revolve("Table top", rounded(radius, 0.711, 0.741), 128), stage.material("Marble", MARBLE), location)


def handle(points, radius):
    path = smooth(points, 10)
    return sweep("Handle", path, radius, 20)


def cup(location, turn: float, size: float = 1.0):
    wall = smooth([(0.024, 0.006), (0.034, 0.02), (0.042, 0.045), (0.045, 0.068)], 6)
    inside = smooth([(0.042, 0.068), (0.039, 0.045), (0.03, 0.02), (0.0, 0.012)], 6)
    body = revolve("Cup", [(0, 0), (0.024, 0), *wall, *inside], 72)
    ear = handle([(0.037, 0, 0.056), (0.058, 0, 0.058), (0.064, 0, 0.04), (0.052, 0, 0.022), (0.032, 0, 0.02)], 0.0042)
    hollow = shapes.joined("Hollow", [revolve("Hollow", [(0, 0.014), (0.029, 0.021), (0.0385, 0.046), (0.0415, 0.08), (0, 0.08)], 72)])
    made = combine("UNION", body, combine("DIFFERENCE", ear, hollow))
    saucer = [(0, 0), (0.035, 0), *smooth([(0.04, 0.004), (0.06, 0.008), (0.078, 0.018)], 5), *smooth([(0.077, 0.02), (0.058, 0.012), (0.035, 0.009)], 5), (0, 0.009)]
    china = stage.material("China", CHINA)
    stage.put(revolve("Saucer", saucer, 96), china, location, scale=size)
    stage.put(made, china, (*location[:2], location[2] + 0.0095 * size), turn, size)
    tea = stage.material("Tea", (0.45, 0.2, 0.08))
    stage.put(revolve("Tea", [(0, 0), (0.0412, 0)], 72), tea, (*location[:2], location[2] + 0.068 * size), scale=size)


def teapot(location, turn: float, size: float = 1.0):
    body = smooth([(0.045, 0.008), (0.075, 0.03), (0.088, 0.07), (0.072, 0.115), (0.05, 0.132)], 8)
    pot = revolve("Teapot", [(0, 0), (0.045, 0), *body, (0.05, 0.137), (0, 0.137)], 96)
    spout = smooth([(0.05, 0, 0.05), (0.085, 0, 0.055), (0.11, 0, 0.085), (0.125, 0, 0.12), (0.145, 0, 0.136)], 8)
    beak = sweep("Spout", spout, np.interp(np.linspace(0, 1, len(spout)), [0, 0.4, 1], [0.03, 0.02, 0.011]), 32)
    ear = handle([(-0.055, 0, 0.112), (-0.085, 0, 0.13), (-0.122, 0, 0.12), (-0.13, 0, 0.082), (-0.112, 0, 0.05), (-0.075, 0, 0.042)], 0.0085)
    china = stage.material("China", CHINA)
    stage.put(combine("UNION", pot, beak, ear), china, location, turn, size)
    lid = [(0, 0), *smooth([(0.052, 0), (0.053, 0.004), (0.035, 0.017), (0.01, 0.022)], 5), *smooth([(0.007, 0.024), (0.008, 0.03), (0.015, 0.038), (0.01, 0.049), (0, 0.051)], 5)]
    stage.put(revolve("Lid", lid, 96), china, (*location[:2], location[2] + 0.1375 * size), scale=size)


def cake(location, turn: float, size: float = 1.0):
    """A slice on a plate."""
    china, crumb, icing = stage.material("China", CHINA), stage.material("Crumb", (0.75, 0.56, 0.33)), stage.material("Icing", (0.9, 0.72, 0.7))
    plate = [(0, 0), (0.055, 0), *smooth([(0.06, 0.003), (0.085, 0.008), (0.1, 0.016)], 5), *smooth([(0.099, 0.018), (0.083, 0.011), (0.058, 0.008)], 5), (0, 0.008)]
    stage.put(revolve("Plate", plate, 96), china, location, scale=size)
    arc = np.linspace(-0.36, 0.36, 13)
    wedge = [(-0.05, 0), *zip(-0.05 + 0.11 * np.cos(arc), 0.11 * np.sin(arc))]
    for low, high, paint in ((0, 0.022, crumb), (0.022, 0.03, icing), (0.03, 0.052, crumb), (0.052, 0.06, icing)):
        stage.put(shapes.prism("Cake", wedge, low, high), paint, (*location[:2], location[2] + 0.0085 * size), turn, size)
    stage.put(shapes.moved(shapes.joined("Cherry", [revolve("Cherry", [(0.011 * math.cos(a), 0.011 * math.sin(a)) for a in np.linspace(-math.pi / 2, math.pi / 2, 13)], 32)]), (0.035, 0, 0.0705)),
              stage.material("Cherry", (0.6, 0.08, 0.1)), (*location[:2], location[2] + 0.0085 * size), turn, size)


def board(location, turn: float):
    """A folding board with the menu in chalk."""
    frame = stage.material("Beech", BEECH)
    lean = math.radians(14)
    for side in (-1, 1):
        leaf = Solid().add((-0.3, 0.3), (-0.02, 0.02), (0, 0.95)).cut((-0.24, 0.24), (-0.03, -0.008), (0.16, 0.89)).cut((-0.24, 0.24), (-0.03, 0.03), (0, 0.1))
        shape = shapes.moved(leaf.mesh("Menu board"), (0, side * 0.02, -0.95), (0, 0, 0 if side < 0 else math.pi))
        stage.put(shapes.moved(shape, (0, 0, 0.95 * math.cos(lean)), (lean * side, 0, 0)), frame, location, turn)
    chalk, angle = stage.material("Chalk", (0.95, 0.95, 0.93)), math.radians(turn)

    def written(down):
        """A place just before the slate, `down` from the board's ridge."""
        out, up = -0.031 * math.cos(lean) - down * math.sin(lean), 0.031 * math.sin(lean) + (0.95 - down) * math.cos(lean)
        return (location[0] - out * math.sin(angle), location[1] + out * math.cos(angle), location[2] + up)

    text = stage.lettering("Menu", "menu", 0.19, chalk, written(0.22), turn)
    text.rotation_euler.x = math.pi / 2 - lean
    for k in range(4):  # writing too small to read is drawn as a wave
        x = np.linspace(-0.17, 0.02 + 0.15 * math.cos(k * 2.1) ** 2, 40)
        wave = np.stack([x, np.zeros_like(x), 0.018 * np.sin(x * 110) * np.cos(x * 31 + k)], axis=1)
        line = stage.pipe("Writing", wave, 0.004, chalk, location=written(0.42 + 0.1 * k), turn=turn)
        line.rotation_euler.x = -lean
