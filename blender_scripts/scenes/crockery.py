# SPDX-License-Identifier: GPL-3.0-or-later
"""A tea set and cake as surfaces of revolution; handles and spouts are united with the body, so that the seam is an
edge."""

import numpy as np

from . import shapes
from .place import put
from .shapes import combine, revolve, smooth, sweep


def above(location, up: float):
    return (location[0], location[1], location[2] + up)


def dish(name: str, foot: float, out, back, location, size: float):
    """A saucer or plate: the profile from its foot out to the rim and back inside."""
    inside = back[-1][1]
    profile = [(0, 0), (foot, 0), *smooth(out, 5), *smooth(back, 5), (0, inside)]
    put(revolve(name, profile, 96), "china", location, scale=size)


def cup(location, turn: float, size: float = 1.0):
    """Adds a cup of tea on its saucer."""
    dish("Saucer", 0.035, [(0.04, 0.004), (0.06, 0.008), (0.078, 0.018)],
         [(0.077, 0.02), (0.058, 0.012), (0.035, 0.009)], location, size)  # fmt: skip
    wall = smooth([(0.024, 0.006), (0.034, 0.02), (0.042, 0.045), (0.045, 0.068)], 6)
    inside = smooth([(0.042, 0.068), (0.039, 0.045), (0.03, 0.02), (0, 0.012)], 6)
    body = revolve("Cup", [(0, 0), (0.024, 0), *wall, *inside], 72)
    path = [(0.037, 0.056), (0.058, 0.058), (0.064, 0.04), (0.052, 0.022), (0.032, 0.02)]
    hollow = revolve("Hollow", [(0, 0.014), (0.029, 0.021), (0.0385, 0.046), (0.0415, 0.08), (0, 0.08)], 72)
    ear = combine("DIFFERENCE", handle(path, 0.0042), hollow)  # remove the part inside the cup
    put(combine("UNION", body, ear), "china", above(location, 0.0095 * size), turn, size)
    put(revolve("Tea", [(0, 0), (0.0412, 0)], 72), "tea", above(location, 0.068 * size), scale=size)


def handle(path, radius: float):
    """A round bow in the x, z plane."""
    return sweep("Handle", smooth([(x, 0, z) for x, z in path], 10), radius, 20)


def teapot(location, turn: float, size: float = 1.0):
    belly = smooth([(0.045, 0.008), (0.075, 0.03), (0.088, 0.07), (0.072, 0.115), (0.05, 0.132)], 8)
    body = revolve("Teapot", [(0, 0), (0.045, 0), *belly, (0.05, 0.137), (0, 0.137)], 96)
    spout = smooth([(0.05, 0, 0.05), (0.085, 0, 0.055), (0.11, 0, 0.085), (0.125, 0, 0.12), (0.145, 0, 0.136)], 8)
    thick = np.interp(np.linspace(0, 1, len(spout)), [0, 0.4, 1], [0.03, 0.02, 0.011])
    path = [(-0.055, 0.112), (-0.085, 0.13), (-0.122, 0.12), (-0.13, 0.082), (-0.112, 0.05), (-0.075, 0.042)]
    whole = combine("UNION", body, sweep("Spout", spout, thick, 32), handle(path, 0.0085))
    put(whole, "china", location, turn, size)
    lid = smooth([(0.052, 0), (0.053, 0.004), (0.035, 0.017), (0.01, 0.022)], 5)
    knob = smooth([(0.007, 0.024), (0.008, 0.03), (0.015, 0.038), (0.01, 0.049), (0, 0.051)], 5)
    put(revolve("Lid", [(0, 0), *lid, *knob], 96), "china", above(location, 0.1375 * size), scale=size)


def cake(location, turn: float, size: float = 1.0):
    """A slice on a plate."""
    dish("Plate", 0.055, [(0.06, 0.003), (0.085, 0.008), (0.1, 0.016)],
         [(0.099, 0.018), (0.083, 0.011), (0.058, 0.008)], location, size)  # fmt: skip
    arc = np.linspace(-0.36, 0.36, 13)
    wedge = [(-0.05, 0), *zip(-0.05 + 0.11 * np.cos(arc), 0.11 * np.sin(arc))]
    for low, high, paint in (
        (0, 0.022, "crumb"),
        (0.022, 0.03, "icing"),
        (0.03, 0.052, "crumb"),
        (0.052, 0.06, "icing"),
    ):
        put(shapes.prism("Cake", wedge, low, high), paint, above(location, 0.0085 * size), turn, size)
    cherry = shapes.moved(shapes.ball("Cherry", 0.011, 32), (0.035, 0, 0.0705))
    put(cherry, "cherry", above(location, 0.0085 * size), turn, size)
