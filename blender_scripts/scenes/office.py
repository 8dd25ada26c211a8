"""office: a cutaway of five furnished floors, some 300,000 triangles of placed geometry."""

import math

import numpy as np

from . import plants, shapes, stage
from .furniture import Furniture
from .office_plan import DEPTH, FLOORS, HEIGHT, INNER, OUTER, PLINTH, SLAB, WIDTH, front
from .shapes import revolve
from .solid import Solid, bars

WALLS = ("Wall", (0.86, 0.85, 0.82))
STONE = ("Stone", (0.74, 0.73, 0.7))
FRAME = ("Frame", (0.4, 0.43, 0.45))
DOOR = ("Door", (0.6, 0.46, 0.32))
IRON = ("Iron", (0.2, 0.21, 0.22))

WINDOW = (1.3, 1.4, 0.95)  # width, height, sill
DOORWAY = (0.9, 2.1)
RISERS, GOING = 17, 0.225


def level(floor: int) -> float:
    """Top of a floor's slab."""
    return PLINTH + HEIGHT * floor


def window_places():
    """(x, y of the middle, whether the wall runs along x) and floor of every window."""
    for floor in range(len(FLOORS)):
        for x in np.arange(1.55, WIDTH - 1, 2.32):
            yield x, DEPTH - OUTER / 2, True, floor
        for y in np.arange(DEPTH - 1.6, front(floor) + 1.0, -1.9):
            if not (floor == 0 and y < 2.6):  # the entrance is there
                yield OUTER / 2, y, False, floor
            yield WIDTH - OUTER / 2, y, False, floor


def house():
    """Slabs, outer walls, partitions, with their openings: one solid."""
    made = Solid().add((-0.1, WIDTH + 0.1), (-0.4, DEPTH + 0.1), (0, PLINTH))
    for k, floor in enumerate(FLOORS):
        y, low, high = front(k), level(k), level(k + 1) - SLAB
        if k:
            made.add((0, WIDTH), (y, DEPTH), (low - SLAB, low))
        made.add((0, WIDTH), (DEPTH - OUTER, DEPTH), (low, high))
        for x in (0, WIDTH - OUTER):
            made.add((x, x + OUTER), (y, DEPTH), (low, high))
        for x, y0, y1, door, _ in floor.walls:
            made.add((x - INNER / 2, x + INNER / 2), (max(y0, y), y1), (low, high))
            if door is not None:
                made.cut((x - INNER / 2, x + INNER / 2), (door - DOORWAY[0] / 2, door + DOORWAY[0] / 2), (low, low + DOORWAY[1]))
    for k, floor in enumerate(FLOORS):  # after the walls below, whose tops the slabs would close again
        for x0, x1, y0, y1 in floor.openings:
            made.cut((x0, x1), (y0, y1), (level(k) - SLAB, level(k)))
    top = level(len(FLOORS))
    made.add((-0.15, WIDTH + 0.15), (DEPTH - 2.4, DEPTH + 0.15), (top - SLAB, top))
    made.add((-0.15, WIDTH + 0.15), (DEPTH - 0.05, DEPTH + 0.15), (top, top + 0.3))
    wide, tall, sill = WINDOW
    for x, y, along, k in window_places():
        z = (level(k) + sill, level(k) + sill + tall)
        across, deep = ((x - wide / 2, x + wide / 2), (y - 1, y + 1)) if along else ((x - OUTER / 2, x + OUTER / 2), (y - wide / 2, y + wide / 2))
        made.cut(across, (y - OUTER / 2, y + OUTER / 2) if along else deep, z)
    made.cut((0, OUTER), (0.6, 2.2), (PLINTH, PLINTH + 2.3))
    stage.put(made.mesh("House"), stage.material(*WALLS))


def joinery():
    """Windows and doors: linked copies, each a hair smaller than its opening."""
    wide, tall, sill = WINDOW
    frame, board = bars(wide - 0.006, tall - 0.006, 2, 2, 0.06, 0.07, 0.035), Solid().add((-wide / 2 - 0.08, wide / 2 + 0.08), (-0.14, 0), (-0.05, 0)).mesh("Sill")
    frame = shapes.moved(frame.mesh("Window"), (-wide / 2 + 0.003, 0, 0.003))
    for x, y, along, k in window_places():
        turn = 0 if along else 90 if x > WIDTH / 2 else -90
        stage.put(frame, stage.material(*FRAME), (x, y, level(k) + sill), turn)
        if x < 1 and not along:  # outside, where one sees the facade
            stage.put(board, stage.material(*STONE), (-0.001, y, level(k) + sill), turn)
    width, height = DOORWAY
    leaf = Solid().add((0, width - 0.02), (-0.02, 0.02), (0.01, height - 0.01))
    for z0, z1 in ((0.25, 0.95), (1.1, 1.9)):
        leaf.cut((0.14, width - 0.16), (-0.03, -0.01), (z0, z1)).cut((0.14, width - 0.16), (0.01, 0.03), (z0, z1))
    knob = Solid().add((width - 0.11, width - 0.08), (-0.06, 0.06), (1.0, 1.03)).add((width - 0.2, width - 0.08), (-0.07, -0.05), (1.0, 1.025)).add((width - 0.2, width - 0.08), (0.05, 0.07), (1.0, 1.025))
    leaf = shapes.joined("Door", [leaf.mesh("Leaf"), knob.mesh("Handle")])
    for k, floor in enumerate(FLOORS):
        for x, _, _, door, swing in floor.walls:
            if door is not None:
                stage.put(leaf, stage.material(*DOOR), (x - INNER / 2 - 0.025, door + width / 2 - 0.01, level(k)), -90 - swing)
    entrance = shapes.moved(bars(1.594, 2.294, 2, 1, 0.08, 0.08, 0.07).mesh("Entrance"), (-0.797, 0, 0.001))
    stage.put(entrance, stage.material(*FRAME), (OUTER / 2, 1.4, PLINTH), -90)
    canopy = Solid().add((-1.5, -0.001), (0.3, 2.5), (PLINTH + 2.55, PLINTH + 2.7)).mesh("Canopy")
    stage.put(canopy, stage.material(*STONE))
    stage.put(Solid().add((-1.1, -0.101), (0.3, 2.5), (0, PLINTH - 0.02)).mesh("Step"), stage.material(*STONE))


def stairs():
    iron, stone = stage.material(*IRON), stage.material(*STONE)
    rise = HEIGHT / RISERS
    for k, floor in enumerate(FLOORS):
        z = level(k)
        for x, y0, y1 in floor.flights:
            flight = Solid()
            for step in range(RISERS - 1):
                flight.add((x - GOING * (step + 1), x - GOING * step), (y0 + 0.03, y1 - 0.03), (z + max(0, rise * (step - 1)), z + rise * (step + 1)))
            stage.put(flight.mesh("Stairs"), stone)
            foot, head = (x - GOING / 2, y0 + 0.06, z + rise), (x - GOING * (RISERS - 1.5), y0 + 0.06, z + rise * (RISERS - 1))
            rail(iron, [foot, head], 0.92, 6)
        for x0, x1, y0, y1 in floor.openings:
            gap = 0.06
            corners = [(x0 - gap, y1 + gap, z), (x1 + gap, y1 + gap, z), (x1 + gap, y0 - gap, z), (x0 - gap, y0 - gap, z)]
            for a, b in zip(corners[:-1], corners[1:]):
                rail(iron, [a, b], 0.95, max(2, round(math.dist(a, b) / 0.5)))


def rail(paint, ends, height: float, posts: int):
    """A handrail on posts between two points."""
    a, b = (np.array(end) for end in ends)
    up = np.array([0, 0, height])
    stage.pipe("Handrail", [a + up, b + up], 0.022, paint)
    stage.pipe("Rail", [a + up / 2, b + up / 2], 0.012, paint)
    for t in np.linspace(0, 1, posts):
        foot = a + (b - a) * t
        stage.pipe("Post", [foot, foot + up - (0, 0, 0.022)], 0.014, paint)


def furnish(shared):
    """Linked copies, each turned a little off the plan, as people leave things."""
    furniture, draw = Furniture(shared), np.random.default_rng(1)
    for k, floor in enumerate(FLOORS):
        for name, x, y, turn, *more in floor.pieces:
            up, scale = (*more, 0.0, 1.0)[:2] if len(more) < 2 else more
            loose = "hair" in name or name in ("stool", "thonet", "dustbin", "littlePlant")
            stage.put(furniture.mesh(name), None, (x, y, level(k) + up), turn + (draw.uniform(-8, 8) if loose else 0), scale)


def surroundings():
    """A base like a model's, trees, what stands on a roof."""
    stone = stage.material(*STONE)
    stage.put(Solid().add((-5, WIDTH + 3.5), (-2.6, DEPTH + 2.5), (-0.35, -0.001)).mesh("Base"), stone)
    for x, y, height, radius, seed in ((-3.2, 6.6, 2.3, 1.5, 2), (-3.4, -1.0, 1.6, 1.0, 5), (19.0, 2.4, 2.1, 1.2, 9)):
        plants.tree((x, y, 0), height, radius, seed, segments=20)
    top = level(len(FLOORS))
    unit = Solid().add((0, 1.6), (0, 0.9), (0, 0.9)).cut((0.1, 1.5), (-0.1, 0.05), (0.15, 0.8))
    for slat in np.arange(0.2, 0.78, 0.1):
        unit.add((0.1, 1.5), (0, 0.05), (slat, slat + 0.05))
    unit = unit.mesh("Ventilation")
    for x in (2.4, 4.4):
        stage.put(unit, stage.material(*FRAME), (x, DEPTH - 1.6, top))
    pipe = revolve("Chimney", [(0, 0), (0.16, 0), (0.16, 0.9), (0.24, 0.9), (0.24, 0.97), (0.05, 1.15), (0, 1.15)], 64)
    for x in (10.2, 11.0, 13.6):
        stage.put(pipe, stage.material(*IRON), (x, DEPTH - 0.9, top))


def build(argument, shared):
    stage.clear()
    stage.frame()
    house()
    joinery()
    stairs()
    furnish(shared)
    surroundings()
    stage.camera((-11.5, -31, 15), (7.6, 3.2, 7.1), lens=41)
    stage.sun(-130, 45)
