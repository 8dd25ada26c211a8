# SPDX-License-Identifier: GPL-3.0-or-later
"""Where an earlier picture of a scene is seen after the camera has moved: as if it were painted on a plane across the
view. So it stays below what Blender draws over it until the next one is done."""

import numpy as np

AROUND = 1.0  # how far the plane reaches beyond the picture on each side, in pictures; its border goes on there

# Places on the plane, in pictures from the lower left corner of the picture, of two triangles.
PLACES = np.array([(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)], np.float32) * (1 + 2 * AROUND) - AROUND


def on_plane(before, now, depth):
    """(6, 4) float32 clip coordinates in the View `now` of PLACES on a picture of the View `before`. `depth`: distance
    of the plane from the eye of `before`; what lies at that depth is where the scene has it, and if only the direction
    of the view has changed, so is everything else."""
    to_clip = before.view_to_clip
    w = -to_clip[3, 2] * depth + to_clip[3, 3]
    ndc = 2 * PLACES.astype(np.float64) - 1
    plane = np.column_stack([np.zeros((len(ndc), 2)), np.full(len(ndc), -depth), np.ones(len(ndc))])
    plane[:, :2] = np.linalg.solve(to_clip[:2, :2], (w * ndc - (plane @ to_clip.T)[:, :2]).T).T
    clip = plane @ (now.view_to_clip @ now.world_to_view @ np.linalg.inv(before.world_to_view)).T
    clip[:, 2] = 0.0  # between the planes that clip
    return clip.astype(np.float32)


def depth_of(view, place):
    """Distance along a View of a place in the scene that it looks at; 1 for one behind the eye."""
    depth = -(view.world_to_view @ (*place, 1.0))[2]
    return float(depth) if depth > 1e-6 else 1.0
