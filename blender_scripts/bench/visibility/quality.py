# SPDX-License-Identifier: GPL-3.0-or-later
"""Correctness of a method per sample, and its temporal coherence, relative to exact visibility.

Samples of two frames are at different positions. So fixed points on whole mesh edges, at the fractions PLACES, are
followed over frames; a point has the visibility of the sample that contains it."""

import numpy as np

PLACES = (np.arange(4) + 0.5) / 4
UNSET = 0xFFFFFFFF


class Judge:
    """Compares methods with the exact method, which must be passed first."""

    def __init__(self):
        self.exact = None

    def compare(self, name, frames):
        """(disagree, flicker): the share of samples that differ from the exact method; the share of followed points
        whose visibility changes between two frames while it does not in the exact method. None for a method without
        samples, flicker also None for a single frame."""
        if frames[0].visibility is None:
            return None, None
        samples = [frame.visibility >= 0.5 for frame in frames]
        followed = [follow(frame) for frame in frames]
        if name == "exact":
            self.exact = samples, followed
        disagree = np.mean([np.mean(mine != right) for mine, right in zip(samples, self.exact[0], strict=True)])
        changes = [flickers(followed[k : k + 2], self.exact[1][k : k + 2]) for k in range(len(frames) - 1)]
        return round(float(disagree), 5), round(float(np.mean(changes)), 6) if changes else None


def follow(frame):
    """(keys, visible) of the followed points in a frame, sorted by key."""
    clipped, paths = frame.clipped, frame.paths
    first = np.flatnonzero(clipped.sample_count > 0)
    point = clipped.source[first]
    after = clipped.source[first + 1]
    # Segments that are not clipped and cover a whole edge.
    whole = (clipped.source_t[first] == 0) & (after == point + 1) & (clipped.source_t[first + 1] == 0)
    reversed_ = paths.edge_t[point] == 1
    whole &= (paths.place[point] < frame.edge_counts[frame.placement_of(point)]) & (
        reversed_ | (paths.edge_t[point] == 0)
    )
    first, point, reversed_ = first[whole], point[whole], reversed_[whole]
    along = np.where(reversed_[:, None], 1 - PLACES, PLACES)
    depth = -clipped.position_view[:, 2].astype(np.float64)
    near, far = depth[first][:, None], depth[first + 1][:, None]
    on_screen = along if frame.orthographic else along * far / (near + along * (far - near))
    count = clipped.sample_count[first][:, None]
    sample = clipped.sample_start[first][:, None] + np.minimum((on_screen * count).astype(np.int64), count - 1)
    edge = frame.placement_of(point).astype(np.int64) << 32 | paths.place[point]
    keys = (edge[:, None] * len(PLACES) + np.arange(len(PLACES))).ravel()
    order = np.argsort(keys, kind="stable")
    return keys[order], (frame.visibility >= 0.5)[sample.ravel()[order]]


def flickers(mine, right):
    """Share of the points in both frames that change while they do not in the exact method."""
    (keys0, mine0), (keys1, mine1) = mine
    _, in0, in1 = np.intersect1d(keys0, keys1, return_indices=True)
    (_, right0), (_, right1) = right
    same = right0[in0] == right1[in1]
    return np.mean((mine0[in0] != mine1[in1]) & same) if len(in0) else 0.0
