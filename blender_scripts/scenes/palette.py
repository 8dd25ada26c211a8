# SPDX-License-Identifier: GPL-3.0-or-later
"""The colors of the scenes by name, scene-linear. Line drawings use them where lines take their object's color."""

from . import stage

COLOURS = {
    "bark": (0.36, 0.28, 0.22),
    "beech": (0.45, 0.27, 0.15),
    "chalk": (0.95, 0.95, 0.93),
    "cherry": (0.6, 0.08, 0.1),
    "china": (0.93, 0.94, 0.95),
    "clay": (0.68, 0.36, 0.24),
    "cloth": (0.93, 0.9, 0.84),
    "crumb": (0.75, 0.56, 0.33),
    "door": (0.6, 0.46, 0.32),
    "enamel": (0.2, 0.42, 0.45),
    "far plaster": (0.85, 0.86, 0.87),
    "far roof": (0.7, 0.5, 0.42),
    "frame": (0.4, 0.43, 0.45),
    "gilt": (0.85, 0.66, 0.3),
    "glass": (0.62, 0.74, 0.78),
    "ground": (0.8, 0.79, 0.77),
    "icing": (0.9, 0.72, 0.7),
    "iron": (0.13, 0.14, 0.15),
    "joinery": (0.24, 0.33, 0.3),
    "laminate": (0.85, 0.84, 0.8),
    "leaf": (0.3, 0.46, 0.25),
    "leather": (0.4, 0.22, 0.12),
    "marble": (0.88, 0.87, 0.84),
    "oak": (0.62, 0.46, 0.3),
    "plaster": (0.87, 0.8, 0.66),
    "steel": (0.25, 0.26, 0.28),
    "stone": (0.78, 0.76, 0.72),
    "stripe": (0.72, 0.24, 0.2),
    "tea": (0.45, 0.2, 0.08),
    "tile": (0.66, 0.3, 0.2),
    "trim": (0.8, 0.78, 0.74),
    "upholstery": (0.36, 0.42, 0.5),
    "wall": (0.86, 0.85, 0.82),
    "wicker": (0.62, 0.45, 0.26),
}


def paint(name: str):
    """The material of that name."""
    return stage.material(name.capitalize(), COLOURS[name])
