# SPDX-License-Identifier: GPL-3.0-or-later
"""The README's picture: a cafe at a street corner. Foreground, middle and far are placed as the camera sees them."""

import math

from . import bicycle, cafe, crockery, plants, skyline, stage, street, terrace
from .cafe.plan import DOOR

EYE = (-5.3, -11.7, 1.75)
LOOK = math.radians(27)  # from +y towards +x


def seen(right: float, ahead: float, up: float = 0.0):
    """World coordinates of a point given relative to the camera: to the right and ahead of it; `up`: world z."""
    return (
        EYE[0] + right * math.cos(LOOK) + ahead * math.sin(LOOK),
        EYE[1] - right * math.sin(LOOK) + ahead * math.cos(LOOK),
        up,
    )


def foreground():
    x, y, _ = place = seen(-1.8, 6.1)
    terrace.table(place, 0.42)
    top = terrace.TABLE
    crockery.teapot((x + 0.03, y + 0.1, top), 200, 1.4)
    crockery.cup((x - 0.25, y + 0.02, top), 150, 1.4)
    crockery.cup((x + 0.24, y - 0.1, top), -40, 1.4)
    crockery.cake((x - 0.06, y - 0.24, top), 160, 1.1)
    terrace.chair(seen(-2.55, 6.3), 100)
    terrace.chair(seen(-1.0, 6.55), -70)
    plants.potted(seen(3.0, 4.75), 0.62, 3, leaves=30, length=1.35, width=0.26)


def middle():
    cafe.build()
    terrace.board(seen(3.3, 8.2), -4)
    bicycle.bicycle((3.05, -1.42, 0), 0, 6)
    for side, seed in ((-1, 5), (1, 8)):
        angle = math.radians(DOOR + side * 66)
        plants.clipped((2.35 * math.cos(angle), 2.35 * math.sin(angle), 0), 0.52, seed)
    street.lamp(seen(-4.2, 7.6))
    street.garden_wall((-1.3, 1.0, 0), 162, 12)
    street.ground()
    street.manhole(seen(1.9, 7.3))
    street.cobbles(seen(0.3, 6.35), -27, 6, 11, 1)
    street.cobbles(seen(-3.3, 6.3), -20, 5, 8, 2)
    street.cobbles(seen(3.9, 7.2), -35, 4, 9, 4)
    around = [math.radians(a) for a in range(160, 271, 3)]
    street.edging([(4.1 * math.cos(a), 4.1 * math.sin(a)) for a in around] + [(16, -4.1)], 6)


def far():
    plants.tree((-5.4, 5.0, 0), 2.9, 1.9, 11)
    skyline.house((-4.2, 17, 0), -8, 6.5, 4.2, 1.9)
    skyline.house((-12.5, 19, 0), 4, 6.5, 4.6, 3.0)
    skyline.church(seen(-13.6, 50))


def build(argument, shared):
    stage.clear()
    stage.frame()
    foreground()
    middle()
    far()
    stage.camera(EYE, seen(0, 1, EYE[2]), lens=28, shift=(0, 0.05))
    stage.sun(-100, 50)
