# SPDX-License-Identifier: GPL-3.0-or-later
"""An open, smooth surface with features for every line definition: hills, hollows, a wall and a ditch."""

import numpy as np

COUNT = 80  # vertices along each side


def points():
    """(COUNT², 3), row by row; 4 units wide around the origin."""
    x, y = np.meshgrid(np.linspace(-2, 2, COUNT), np.linspace(-2, 2, COUNT), indexing="ij")
    z = 0.7 * np.exp(-2.5 * (x**2 + y**2)) + 0.18 * np.sin(3 * x + 1) * np.cos(2.5 * y)
    z += 0.4 * np.exp(-(((x + 0.3 * y + 1.3) / 0.15) ** 2)) - 0.4 * np.exp(-(((y - 0.3 * x + 1.1) / 0.15) ** 2))
    return np.stack([x, y, z], -1).reshape(-1, 3)


def quads():
    """Vertices of its faces."""
    corners = (i for i in range(COUNT * (COUNT - 1)) if i % COUNT < COUNT - 1)
    return [(i, i + COUNT, i + COUNT + 1, i + 1) for i in corners]
