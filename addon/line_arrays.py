# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines as polylines in NumPy arrays, for research and scripts: whole paths, or their runs for a camera.

Polyline i has the points offsets[i] to offsets[i + 1] - 1; M points, R polylines.
"""

import numpy as np

from . import native


def whole(paths, view_to_world):
    """A dict of all paths, visible or not. points: (M, 3) float64, in object space; image-space lines, which have no
    object, are mapped from view space by `view_to_world` (4, 4). strength: (M,) float32 in [0, 1]; offsets: (R + 1,)
    int64; closed: (R,) bool, the last point repeats the first; path_id: (R,) uint64, for lines of the mesh independent
    of the view; path: (R,) index into the native Paths."""
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
    """A dict of the runs of a native Frame, before haloes and overshoot. points: (M, 3) float64 in the target space of
    `view_to_world` (4, 4); px: (M, 2) float32 pixels from the lower left corner; arc_px: (M,) float64 arc length, 0 at
    the path's middle; strength: (M,) float32; kinds: (M,) uint32 of the segment that starts at the point, bit i: the
    registry's definition i; offsets, closed, path_id, path: as in `whole`; invisibility: (R,) uint8 quantitative
    invisibility, the number of surfaces that hide the run; shown: (R,) float32 in [0, 1], opacity factor of elision."""
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


def strong(lines, least):
    """(px, offsets) of the parts of `seen` lines that have at least that strength; they begin and end at points."""
    if not least:
        return lines["px"], lines["offsets"]
    kept, line = lines["strength"] >= least, np.repeat(np.arange(len(lines["offsets"]) - 1), np.diff(lines["offsets"]))
    begins = kept.copy()
    begins[1:] &= (line[1:] != line[:-1]) | ~kept[:-1]
    return lines["px"][kept], np.append(np.flatnonzero(begins[kept]), kept.sum()).astype(np.int64)


def placed(points, matrix):
    """(M, 3) points transformed by one affine (4, 4) matrix, or each by its own of (M, 4, 4)."""
    return (matrix[..., :3, :3] @ points[..., None])[..., 0] + matrix[..., :3, 3]
