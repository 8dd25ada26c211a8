# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines as polylines in NumPy arrays, for research and scripts: whole paths, or the runs of them that a camera sees.

Polyline i has the points offsets[i] to offsets[i + 1]; M points, R polylines.
"""

import numpy as np

from . import native


def whole(paths, view_to_world):
    """A dict of paths, visible or not. points: (M, 3) float64, in the space of the surface, but for lines of the image
    in that which `view_to_world` (4, 4) leads to; strength: (M,) float32 in [0, 1]; offsets: (R + 1,) int64; closed:
    (R,) bool, the last point is the first again; path_id: (R,) uint64, the same from every view for lines of the mesh;
    path: (R,) of native Paths."""
    points = paths.points_obj.astype(np.float64)
    in_image = np.repeat(paths.placement == native.UNSET, np.diff(paths.offsets))
    points[in_image] = placed(points[in_image], view_to_world)
    return {
        "points": points,
        "offsets": paths.offsets.astype(np.int64),
        "closed": paths.closed.astype(bool),
        "path_id": paths.ids,
        "strength": paths.strength,
        "path": np.arange(len(paths.ids)),
    }


def seen(frame, view_to_world):
    """A dict of the runs of a native Frame, as pens draw them before haloes and overshoot. points: (M, 3) float64 in the
    space that `view_to_world` leads to; px: (M, 2) float32 pixels from the lower left corner; arc_px: (M,) float64, 0 at
    the path's middle; strength: (M,) float32; kinds: (M,) uint32, bit i: the registry's definition i, of the segment
    from the point; offsets, closed, path_id, path: as of `whole`; invisibility: (R,) uint8 surfaces that hide the run;
    shown: (R,) float32 in [0, 1], what elision leaves of it."""
    found = frame.polylines()
    return {
        "points": placed(found.position_view.astype(np.float64), view_to_world),
        "px": found.px,
        "offsets": found.offsets.astype(np.int64),
        "closed": found.closed.astype(bool),
        "path_id": found.path_id,
        "path": found.path,
        "invisibility": found.invisibility,
        "shown": found.shown,
        "arc_px": found.arc_px,
        "strength": found.strength,
        "kinds": found.kinds,
    }


def placed(points, matrix):
    """(M, 3) points moved by an affine (4, 4) matrix, or by one of (M, 4, 4)."""
    return (matrix[..., :3, :3] @ points[..., None])[..., 0] + matrix[..., :3, 3]
