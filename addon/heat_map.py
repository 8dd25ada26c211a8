# SPDX-License-Identifier: GPL-3.0-or-later
"""Colors of heat maps. Without Blender."""

import numpy as np

# From warm to cool, for values from 0 to 1, in display space.
STOPS = np.array([(0.95, 0.25, 0.1), (1.0, 0.8, 0.2), (0.3, 0.75, 0.6), (0.15, 0.3, 0.8)], np.float32)


def colors(values):
    """(H, W, 3) float32 in display space, from (H, W) in [0, 1]."""
    at = np.clip(values, 0, 1) * (len(STOPS) - 1)
    below = np.minimum(at.astype(np.intp), len(STOPS) - 2)
    share = (at - below)[..., None].astype(np.float32)
    return STOPS[below] * (1 - share) + STOPS[below + 1] * share
