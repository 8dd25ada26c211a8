"""The corner cafe: a round tower with the door, a cone of scales, a wing with a shop window under a curved awning."""

import math

import numpy as np

from . import shapes, stage
from .shapes import arch, combine, revolve, smooth, upright
from .solid import Solid, bars

RADIUS = 1.7  # of the tower, whose axis is the z axis
WALL = 0.3
DOOR = 251.0  # where the door looks, degrees from +x
SILL = 0.47  # of the door, a hand above three steps
FRONT = -0.95  # the wing's wall in y
EAVE = 3.5  # of the wing
PITCH = math.tan(math.radians(30))
RIDGE = 1.35  # in y
LENGTH = 18.0  # of the wing, out of the picture
SHOP = (4.1, 7.9, 0.75, 2.35)  # x from, to, z from, to

PLASTER = (0.87, 0.8, 0.66)
TRIM = (0.8, 0.78, 0.74)
WOOD = (0.24, 0.33, 0.3)
TILE = (0.66, 0.3, 0.2)
IRON = (0.13, 0.14, 0.15)
GLASS = (0.62, 0.74, 0.78)


def radial(shape, angle: float, radius: float = RADIUS):
    """Takes a mesh made around x = y = 0, looking to -y, to the tower's wall."""
    turn = math.radians(angle)
    return shapes.moved(shape, (radius * math.cos(turn), radius * math.sin(turn), 0), (0, 0, turn + math.pi / 2))


def walls():
    """Tower, steps and wing in one piece."""
    inner, moulding = RADIUS - WALL, RADIUS + 0.09
    cornice = smooth([(RADIUS + 0.02, 4.33), (RADIUS + 0.05, 4.42), (RADIUS + 0.16, 4.48), (RADIUS + 0.24, 4.55)], 4)
    profile = [(inner, 0), (moulding, 0), (moulding, 0.55), (RADIUS, 0.61), (RADIUS, 3.24), (moulding, 3.26), (moulding, 3.36),
               (RADIUS, 3.38), (RADIUS, 4.27), (RADIUS + 0.02, 4.27), *cornice, (RADIUS + 0.24, 4.63), (inner, 4.63), (inner, 0)]
    tower = revolve("Tower", profile, 128)
    block = Solid().add((1.3, LENGTH), (FRONT, 4), (0, EAVE - 0.16)).add((1.3, LENGTH), (FRONT - 0.07, 0), (0, 0.5))
    x0, x1, z0, z1 = SHOP
    block.cut((x0, x1), (-2, 1.2), (z0, z1)).add((x0 - 0.12, x1 + 0.12), (FRONT - 0.14, FRONT), (z0 - 0.09, z0))
    treads = [(0, 0)] + [(1.65 - 0.38 * k, 0.15 * (k + up)) for k in range(3) for up in (0, 1)] + [(0, 0.45)]
    made = combine("UNION", tower, block.mesh("Wing"), radial(revolve("Steps", treads, 96), DOOR, 1.55))
    holes = [radial(upright("Hole", arch(1.3, SILL, 2.1), -1, 0.6), DOOR)]
    holes += [radial(upright("Hole", arch(0.72, 1.3, 2.15), -1, 0.6), DOOR + side) for side in (-58, 56)]
    circle = revolve("Hole", [(0, -1), (0.27, -1), (0.27, 0.6), (0, 0.6)], 64)
    holes += [radial(shapes.moved(circle.copy(), (0, 0, 3.83), (-math.pi / 2, 0, 0)), DOOR + side) for side in (-44, 0, 44)]
    stage.put(combine("DIFFERENCE", made, *holes), stage.material("Plaster", PLASTER), name="Cafe")


def joinery():
    """Door and windows, each a hair smaller than its opening, so that its outline is its own."""
    wood, glass, iron = (stage.material(*paint) for paint in (("Joinery", WOOD), ("Glass", GLASS), ("Iron", IRON)))

    def ring(outline, scale, deep):
        """The outline as a frame `scale` wide."""
        middle = np.array([0, (outline[0, 1] + outline[:, 1].max()) / 2])
        half = np.abs(outline - middle).max(axis=0)
        return combine("DIFFERENCE", upright("Frame", outline, 0, deep), upright("Hole", (outline - middle) * (1 - scale / half) + middle, -1, 1))

    def head(name, width, base, spring, angle, bar):
        outline = arch(width - 0.006, base + 0.003, spring)
        parts = [ring(outline, bar, 0.08)]
        for turn in np.radians([45, 90, 135]):  # a fanlight
            spoke = shapes.box("Spoke", (0.03, 0.04, width / 2 - bar / 2), (0, 0.05, 0))
            parts.append(shapes.moved(spoke, (0, 0, spring), (0, 0, 0)) if turn == math.pi / 2 else
                         shapes.moved(spoke, (0, 0, spring), (0, math.pi / 2 - turn, 0)))
        parts.append(upright("Rail", [(-width / 2 + bar, spring - 0.05), (width / 2 - bar, spring - 0.05), (width / 2 - bar, spring + 0.03), (-width / 2 + bar, spring + 0.03)], 0.01, 0.07))
        stage.put(radial(shapes.joined(name, parts), angle, RADIUS - 0.16), wood)

    head("Door frame", 1.3, SILL, 2.1, DOOR, 0.07)
    for side, swing in ((-1, 0), (1, 0)):
        leaf = Solid().add((0, 0.565), (0.02, 0.07), (0, 1.58)).cut((0.09, 0.475), (0, 0.1), (0.62, 1.48))
        leaf.cut((0.1, 0.465), (0, 0.04), (0.12, 0.5)).add((0.15, 0.415), (0.03, 0.05), (0.17, 0.45))
        leaf.add((0.27, 0.295), (0.03, 0.06), (0.62, 1.48)).add((0.09, 0.475), (0.03, 0.06), (1.04, 1.065))
        shape = shapes.moved(leaf.mesh("Door leaf"), (0.005 if side > 0 else -0.57, 0, SILL + 0.01))
        knob = shapes.moved(revolve("Knob", [(0, 0), (0.012, 0), (0.012, 0.03), *smooth([(0.012, 0.03), (0.03, 0.045), (0.02, 0.07), (0, 0.075)], 4)], 24),
                            (side * 0.045, 0.02, SILL + 0.85), (math.pi / 2, 0, 0))
        stage.put(radial(shape, DOOR, RADIUS - 0.16), wood)
        stage.put(radial(knob, DOOR, RADIUS - 0.16), iron)
    for side in (-58, 56):
        head("Window", 0.72, 1.3, 2.15, DOOR + side, 0.05)
        casement = shapes.moved(bars(0.616, 0.79, 2, 2, 0.03, 0.05).mesh("Casement"), (-0.308, 0.035, 1.305))
        stage.put(radial(casement, DOOR + side, RADIUS - 0.16), wood)
        blind = Solid().add((-0.33, 0.33), (0.12, 0.13), (1.31, 2.46)).mesh("Blind")  # inside is nothing to see
        stage.put(radial(blind, DOOR + side, RADIUS - 0.16), stage.material("Cloth", (0.93, 0.9, 0.84)))
        sill = Solid().add((-0.41, 0.41), (-0.11, 0.05), (1.2, 1.297)).mesh("Sill")
        stage.put(radial(sill, DOOR + side), stage.material("Trim", TRIM))
    for side in (-44, 0, 44):
        rim = revolve("Oculus", [(0.3, 0), (0.37, 0), (0.37, 0.07), (0.3, 0.07), (0.3, 0)], 64)
        stage.put(radial(shapes.moved(rim, (0, 0.02, 3.83), (math.pi / 2, 0, 0)), DOOR + side), stage.material("Trim", TRIM))
        pane = revolve("Pane", [(0, 0), (0.266, 0), (0.266, 0.02), (0, 0.02)], 64)
        stage.put(radial(shapes.moved(pane, (0, 0.02, 3.83), (math.pi / 2, 0, 0)), DOOR + side, RADIUS - 0.12), glass)
        cross = Solid().add((-0.265, 0.265), (0, 0.02), (-0.014, 0.014)).add((-0.014, 0.014), (0, 0.02), (-0.265, 0.265)).mesh("Cross")
        stage.put(radial(shapes.moved(cross, (0, -0.02, 3.83)), DOOR + side, RADIUS - 0.12), wood)
    x0, x1, z0, z1 = SHOP
    frame = bars(x1 - x0 - 0.006, z1 - z0 - 0.006, 4, 1, 0.08, 0.1, 0.05)
    frame.add((0.05, x1 - x0 - 0.05), (-0.03, 0.03), (1.18, 1.23))
    stage.put(frame.mesh("Shop window"), wood, (x0 + 0.003, FRONT + 0.12, z0 + 0.003))


def scales(lower, upper, count: int, lobes: float, phase: float, thick: float):
    """A row of tiles with round lower ends: an open sheet between two functions u -> points, u in [0, 1]."""
    u = np.linspace(0, 1, count * 8 + 1)
    drop = np.abs(np.cos(math.pi * (u * count + phase)))[:, None]  # 0 between two tiles
    low, high = lower(u), upper(u)
    edge = high + (low - high) * (1 - lobes * (1 - np.sqrt(drop)))
    return np.stack([edge + thick, (edge + thick) * 0.5 + high * 0.5, high])


def roofs():
    tile, trim, iron = stage.material("Tile", TILE), stage.material("Trim", TRIM), stage.material("Iron", IRON)
    rim, base, top, rows = RADIUS + 0.38, 4.62, 6.5, 12

    def cone(t):  # the cone flares out at the eave
        radius, z = rim * (1 - t) ** 1.12, base + (top - base) * t
        return lambda u: np.stack([radius * np.cos(2 * math.pi * u), radius * np.sin(2 * math.pi * u), np.full_like(u, z)], axis=1)

    shapes_of_rows = []
    for row in range(rows):
        count = 44 if row < 6 else 22 if row < 11 else 11
        low, high = row / rows, min((row + 2) / rows, 0.985)
        shapes_of_rows.append(shapes.sheet("Row", scales(cone(low), cone(high), count, 0.26, row % 2 / 2, np.array([0, 0, 0.022]))))
    stage.put(shapes.joined("Cone", shapes_of_rows), tile)
    under = [(rim * (1 - t) ** 1.12 - 0.03, base + (top - base) * t - 0.01) for t in np.linspace(0, 0.95, 16)]
    stage.put(revolve("Cone boards", under), tile)
    stage.put(revolve("Soffit", [(RADIUS + 0.2, 4.59), (rim - 0.01, 4.59), (rim - 0.01, 4.65), (RADIUS + 0.2, 4.65)]), trim)
    finial = [(0.13, 0), (0.075, 0.12), (0.05, 0.2), (0.05, 0.22)], [(0.05, 0.22), (0.12, 0.29), (0.14, 0.38), (0.1, 0.47), (0.03, 0.51)], [(0.03, 0.51), (0.025, 0.6), (0.005, 0.78), (0, 0.79)]
    finial = np.concatenate([smooth(part, 5) for part in finial])
    stage.put(revolve("Finial", finial, 64), iron, (0, 0, top - 0.16))

    def slope(y):
        return lambda u: np.stack([LENGTH * u, np.full_like(u, y), np.full_like(u, EAVE + (y - FRONT + 0.3) * PITCH)], axis=1)

    edge, rows = FRONT - 0.3, 8
    lines = edge + np.arange(rows + 1) * (RIDGE - edge) / rows
    sheets = [shapes.sheet("Row", scales(slope(low), slope(low + 2 * (RIDGE - edge) / rows), 52, 0.26, row % 2 / 2, np.array([0, -0.015, 0.025])))
              for row, low in enumerate(lines[:-1])]
    stage.put(shapes.joined("Roof", sheets), tile)
    height = EAVE + (RIDGE - edge) * PITCH
    stage.put(Solid().add((1.3, LENGTH), (edge + 0.02, FRONT), (EAVE - 0.16, EAVE - 0.02)).mesh("Eave"), trim)
    boards = shapes.prism("Roof boards", [(edge + 0.03, EAVE - 0.02), (RIDGE, height - 0.04), (2 * RIDGE - edge, EAVE)], 0.8, LENGTH)
    stage.put(shapes.moved(boards, turn=(math.pi / 2, 0, math.pi / 2)), tile)
    stage.pipe("Ridge", [(x, RIDGE, height + 0.03) for x in (0.8, LENGTH)], 0.09, tile)
    y = np.linspace(edge + 0.32, RIDGE, 40)
    stage.pipe("Flashing", [(math.sqrt(RADIUS ** 2 - v * v) + 0.01, v, EAVE + (v - edge) * PITCH + 0.05) for v in y], 0.05, trim)
    stage.pipe("Gutter", [(1.42, edge - 0.06, EAVE - 0.05), (LENGTH, edge - 0.06, EAVE - 0.05)], 0.06, iron)


def awning():
    """A quarter round of striped cloth with a scalloped edge."""
    x0, x1, stripes = SHOP[0] - 0.3, SHOP[1] + 0.3, 18
    top, out, fall = 2.75, 1.15, 0.5
    u = np.linspace(0, 1, stripes * 12 + 1)
    x = x0 + (x1 - x0) * u
    rows = [np.stack([x, np.full_like(x, FRONT - 0.02 - out * math.sin(t)), np.full_like(x, top - fall * (1 - math.cos(t)))], axis=1)
            for t in np.linspace(0, math.pi / 2, 14)]
    for hang in (0.5, 1):
        scallop = rows[13].copy()
        scallop[:, 2] -= hang * (0.1 + 0.1 * np.sqrt(np.abs(np.sin(math.pi * u * stripes))))
        rows.append(scallop)
    cloth = shapes.sheet("Awning", rows)
    cloth.materials.append(stage.material("Stripe", (0.72, 0.24, 0.2)))
    cloth.materials.append(stage.material("Cloth", (0.93, 0.9, 0.84)))
    columns = len(u) - 1
    cloth.polygons.foreach_set("material_index", np.tile(np.arange(columns) // 12 % 2, len(rows) - 1).astype(np.int32))
    stage.put(cloth, None)
    stage.put(Solid().add((x0, x1), (FRONT - 0.07, FRONT), (top, top + 0.07)).mesh("Awning box"), stage.material("Joinery", WOOD))


def signs():
    """The name over the awning, and a round board on a bracket at the tower's side."""
    wood, gilt, iron = stage.material("Joinery", WOOD), stage.material("Gilt", (0.85, 0.66, 0.3)), stage.material("Iron", IRON)
    stage.lettering("Sign", "Café Fovea", 0.5, gilt, ((SHOP[0] + SHOP[1]) / 2, FRONT - 0.005, 3.07))
    angle = DOOR - 82
    out = np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle))])

    def at(radius, z):
        return (*(radius * out), z)

    stage.pipe("Bracket", [at(RADIUS, 3.1), at(RADIUS + 1.0, 3.1)], 0.016, iron)
    turn = np.linspace(0, 3.5 * math.pi, 60)
    curl = 0.11 * np.exp(-turn / 6)
    scroll = [at(RADIUS + 0.02, 2.72), at(RADIUS + 0.06, 2.8), *(at(RADIUS + 0.2 + c * math.sin(t + 2.6), 2.95 + c * math.cos(t + 2.6)) for c, t in zip(curl[::-1], turn[::-1]))][::-1]
    stage.pipe("Scroll", smooth(scroll[:-2:3] + scroll[-2:], 6), 0.011, iron)
    for side in (-0.18, 0.18):
        stage.pipe("Hook", [at(RADIUS + 0.66 + side, 3.085), at(RADIUS + 0.66 + side, 2.93)], 0.007, iron)
    rim = [(0, -0.03), (0.33, -0.03), *smooth([(0.34, -0.03), (0.36, 0), (0.34, 0.03)], 4), (0.3, 0.03), (0.3, 0.018), (0, 0.018)]
    disc = shapes.moved(revolve("Sign board", rim, 96), (0, 0, 2.63), (math.pi / 2, 0, math.radians(angle + 180)))
    x, y, _ = at(RADIUS + 0.66, 0)
    stage.put(shapes.moved(disc, (x, y, 0)), wood)
    face = math.radians(angle + 90)
    stage.lettering("Tea", "Thé", 0.32, gilt, (x + 0.023 * math.cos(face), y + 0.023 * math.sin(face), 2.63), angle + 180)


def inside():
    """What one sees through the shop window: lamps, a counter, jars on a shelf."""
    x0, x1, z0, z1 = SHOP
    iron, wood, china = stage.material("Iron", IRON), stage.material("Joinery", WOOD), stage.material("China", (0.93, 0.94, 0.95))
    shade = smooth([(0.02, 0.24), (0.05, 0.2), (0.14, 0.12), (0.2, 0.02), (0.2, 0)], 6)
    for k in range(3):
        x = x0 + (x1 - x0) * (k + 0.8) / 3.2
        stage.put(revolve("Shade", np.concatenate([[(0, 0.24)], shade, [(0.185, 0), (0, 0.15)]]), 64), china, (x, 0.1, 1.82))
        stage.pipe("Flex", [(x, 0.1, 2.06), (x, 0.1, z1)], 0.008, iron)
    counter = Solid().add((x0 + 0.5, x1), (0.5, 0.95), (z0, z0 + 0.32)).add((x0 + 0.45, x1), (0.45, 1.0), (z0 + 0.32, z0 + 0.37))
    stage.put(counter.mesh("Counter"), wood)
    stand = [(0, 0), (0.07, 0), *smooth([(0.07, 0.01), (0.02, 0.04), (0.02, 0.1)], 5), (0.15, 0.11), (0.15, 0.125), (0, 0.125)]
    angle = np.linspace(0, math.pi / 2, 17)
    dome = [(0.13, 0), *zip(0.13 * np.cos(angle), 0.05 + 0.12 * np.sin(angle)), *smooth([(0.012, 0.171), (0.02, 0.185), (0.012, 0.2), (0, 0.203)], 4)]
    for x in (x0 + 1.15, x0 + 2.5):
        stage.put(revolve("Cake stand", stand, 64), china, (x, 0.7, z0 + 0.371))
        stage.put(revolve("Dome", [(0, 0), *dome], 64), stage.material("Glass", GLASS), (x, 0.7, z0 + 0.497))


def build():
    walls()
    joinery()
    roofs()
    awning()
    signs()
    inside()
