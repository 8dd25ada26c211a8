# SPDX-License-Identifier: GPL-3.0-or-later
"""The plan of the office: five floors, each cut back further than the one below, so that the camera sees into all.

x runs along the front, y into the house, z up; metres. Furniture: (name, x, y, turn in degrees, height above the floor,
scale); the last two may be left out."""

from dataclasses import dataclass, field
from math import cos, radians, sin

WIDTH, DEPTH, HEIGHT = 17.0, 8.5, 3.1  # of the house; HEIGHT from floor to floor
SLAB, OUTER, INNER = 0.28, 0.3, 0.12  # thicknesses
PLINTH = 0.15
DESK, SIDEBOARD = 0.724, 0.82  # heights to stand things on
WINDOW = (1.3, 1.4, 0.95)  # width, height, sill
DOORWAY = (0.9, 2.1)
ENTRANCE = (0.6, 2.2)  # y from, to, in the left wall
RISERS, GOING = 17, 0.225  # of the straight stairs


@dataclass
class Floor:
    walls: list  # partitions across the house: (x, y from, y to, y of the door, how far it stands open in degrees)
    pieces: list
    openings: list = field(default_factory=list)  # in the slab: (x from, x to, y from, y to), with a railing around
    flights: list = field(
        default_factory=list
    )  # straight stairs up from here, rising to -x: (x of the first step, y from, y to)


def level(floor: int) -> float:
    """Top of a floor's slab."""
    return PLINTH + HEIGHT * floor


def front(floor: int) -> float:
    """y at which a floor is cut open."""
    return 1.2 * floor


def workstation(x: float, y: float):
    """A desk seen from its user's side, the chair pushed back a little."""
    desk = [("lbDesk", x, y, 0), ("desklamp", x - 0.55, y + 0.15, 30, DESK)]
    return [*desk, ("designChair", x + 0.15, y - 0.75, 170), ("drawersCabinet", x + 1.15, y + 0.05, 0)]


def meeting(x: float, y: float, seat: str, seats):
    """Chairs around a round table; `seats` in degrees, 0 is +x."""
    around = [
        (seat, x + 0.95 * cos(radians(a)), y + 0.95 * sin(radians(a)), a - 90 + jitter)
        for a, jitter in zip(seats, (6, -9, 4))
    ]
    return [("oakTable", x, y, 20), *around]


def row(name: str, x: float, y: float, count: int, step: float, turn: float = 0):
    return [(name, x + step * k, y, turn) for k in range(count)]


def plant(x: float, y: float, size: float = 3.2, up: float = 0.0):
    return ("littlePlant", x, y, x * 97 % 360, up, size)


FLOORS = [
    Floor(  # entrance and lounge
        walls=[(5.6, 4.2, 8.2, 5.6, 60), (12.2, 5.0, 8.2, 6.6, 25)],
        pieces=[
            ("lbDesk", 3.2, 2.5, 180),
            ("designChair", 3.3, 3.4, -12),
            ("desklamp", 2.7, 2.5, 0, DESK),
            plant(4.9, 0.9),
            plant(0.8, 5.0, 3.6),
            *row("bookcase", 1.4, 8.0, 2, 0.95),
            ("spiralStaircase", 9.6, 3.7, 150, 0, 1.08),
            ("sofa2", 6.9, 3.3, 12),
            plant(8.1, 3.0, 2.4),
            ("shelves", 10.2, 7.98, 0),
            plant(10.2, 7.95, 1.2, SIDEBOARD),
            ("pianoAQueue", 14.0, 2.0, 35),
            ("sofa2", 15.6, 4.6, -75),
            plant(16.2, 6.0, 4.0),
            plant(12.3, 4.4, 2.6),
        ],
    ),
    Floor(  # workplaces, the stairs up
        walls=[(5.6, 1.2, 8.2, 4.6, 70), (12.0, 2.6, 8.2, 6.2, 40)],
        openings=[(8.6, 10.6, 2.7, 4.7)],
        flights=[(16.5, 3.5, 4.6)],
        pieces=[
            *workstation(2.2, 2.9),
            ("desk", 2.0, 5.6, 0),
            ("thonet", 2.1, 4.8, 190),
            ("bookcase", 0.95, 8.0, 0),
            plant(4.9, 7.9),
            ("whiteBoard", 7.0, 4.6, 8),
            ("dustbin", 6.2, 5.2, 0),
            *row("verticalShelves", 8.6, 7.95, 3, 0.48),
            *row("drawersCabinet", 10.4, 7.85, 2, 0.62),
            ("desk", 14.0, 7.3, 0),
            plant(15.9, 7.8, 3.4),
            plant(11.4, 2.0, 2.8),
            plant(12.7, 3.0, 2.2),
        ],
    ),
    Floor(  # two meeting rooms
        walls=[(4.4, 2.4, 8.2, 6.6, 35), (10.6, 2.4, 8.2, 6.2, 80)],
        openings=[(12.75, 15.9, 3.5, 4.6)],
        flights=[(16.5, 4.7, 5.8)],
        pieces=[
            *meeting(2.3, 4.2, "thonet", (35, 270)),
            ("whiteBoard", 1.5, 6.9, 0),
            plant(3.8, 7.9),
            *meeting(7.2, 4.3, "chair", (20, 215)),
            *row("shelves", 5.4, 7.98, 2, 0.85),
            plant(6.3, 7.95, 1.3, SIDEBOARD),
            *row("verticalShelves", 8.9, 7.95, 2, 0.48),
            *row("bookcase", 12.0, 8.0, 2, 0.95),
            plant(11.4, 3.2, 2.6),
            plant(16.3, 7.7, 3.8),
        ],
    ),
    Floor(  # library
        walls=[(7.2, 3.6, 8.2, 5.0, 55)],
        openings=[(12.75, 15.9, 4.7, 5.8)],
        pieces=[
            *row("verticalShelves", 0.75, 7.95, 4, 0.48),
            ("bookcase", 3.1, 8.0, 0),
            ("desk", 2.0, 5.2, 180),
            ("thonet", 2.0, 6.1, -15),
            ("sofa2", 5.3, 6.0, -25),
            plant(6.6, 4.6, 2.8),
            ("spiralStaircase", 9.6, 6.5, 150, 0, 1.08),
            *row("drawersCabinet", 11.3, 7.85, 3, 0.62),
            plant(11.3, 7.85, 1.3, 0.885),
            ("desk", 14.9, 7.6, 0),
            plant(16.3, 7.7, 3.0),
        ],
    ),
    Floor(  # kitchen and a quiet room
        walls=[(5.2, 4.8, 8.2, 6.4, 75)],
        openings=[(8.6, 10.6, 5.5, 7.5)],
        pieces=[
            ("largeFridge", 0.9, 7.6, 0),
            *row("drawersCabinet", 1.75, 7.85, 3, 0.62),
            ("oakTable", 3.2, 6.1, 20),
            ("stool", 2.2, 6.0, 100),
            ("radiator1", 6.9, 8.1, 0, 0.12),
            plant(8.0, 6.0, 3.0),
            ("desk", 13.0, 6.6, 0),
            ("chair", 13.1, 5.8, 170),
            ("shelves", 15.7, 7.98, 0),
            plant(15.7, 7.95, 1.2, SIDEBOARD),
            plant(11.4, 7.8, 3.6),
        ],
    ),
]
