# SPDX-License-Identifier: GPL-3.0-or-later
"""Agreement of sampled with exact visibility per sample: shares that agree, over all samples and over subsets without
those near a true change of visibility, which a depth buffer of finite resolution cannot resolve."""

import numpy as np

AGREES = 0.25  # largest difference of visibility in [0, 1] that counts as agreement
NEAR_PX = 2.0  # distance to a change of visibility, along the path or across it, that counts as near


class Truth:
    """Exact visibility of the atlas samples of a Frame, and masks `far` of the samples far from a change of visibility:
    `all`: no restriction; `path`: along their path; `image`: also across it: the sample displaced perpendicular to its
    line by up to 2 px, at its own depth, has the same visibility."""

    def __init__(self, frame):
        self.samples = Samples(frame.clipped)
        self.exact = frame.visible.samples(frame.clipped)[self.samples.index]
        path = self.samples.distance_to_ends(frame.visible) > NEAR_PX
        image = path.copy()
        for offset in (-NEAR_PX, -NEAR_PX / 2, NEAR_PX / 2, NEAR_PX):
            beside = frame.seen_beside(offset)[self.samples.index] > 0
            image &= beside == (self.exact >= 0.5)
        self.far = {"all": np.ones_like(path), "path": path, "image": image}

    def compare(self, visibility):
        """{"samples": number, mask: shares} for each mask of `far`: the share of samples in it, and among these the
        shares that agree, are falsely hidden, and are falsely visible."""
        more = visibility[self.samples.index] - self.exact
        result = {"samples": len(more)}
        for name, far in self.far.items():
            count = max(int(far.sum()), 1)
            result[name] = {
                "share": far.sum() / max(len(more), 1),
                "agree": 1 - (far & (np.abs(more) > AGREES)).sum() / count,
                "falsely_hidden": (far & (more < -AGREES)).sum() / count,
                "falsely_visible": (far & (more > AGREES)).sum() / count,
            }
        return result


class Samples:
    """Atlas samples except padding, in order: index in the atlas, segment, piece, t on the segment, and arc length
    [px]."""

    def __init__(self, clipped):
        counts = clipped.sample_count.astype(np.int64)
        self.segment = np.repeat(np.arange(len(counts)), counts)
        number = np.arange(len(self.segment)) - np.repeat(np.cumsum(counts) - counts, counts)
        self.index = clipped.sample_start[self.segment] + number
        self.piece = np.searchsorted(clipped.offsets, self.segment, side="right") - 1
        self.t = (number + 0.5) / counts[self.segment]
        arc = clipped.arc_px
        self.arc_px = (1 - self.t) * arc[self.segment] + self.t * arc[self.segment + 1] if len(number) else self.t
        self._clipped = clipped

    def distance_to_ends(self, runs):
        """Pixels along the piece to the nearest start or end of a run, ignoring those at the piece's own ends."""
        arc, offsets = self._clipped.arc_px, self._clipped.offsets.astype(np.int64)
        first, last = arc[offsets[:-1]], arc[offsets[1:] - 1]
        # Lay all pieces out on one axis, with gaps between them.
        start = np.cumsum(last - first + 1e3) - (last - first) - first
        piece, ends = np.tile(runs.piece, 2), np.concatenate([runs.start_px, runs.end_px])
        inside = (ends > first[piece] + 1e-6) & (ends < last[piece] - 1e-6)
        changes = np.sort((start[piece] + ends)[inside])
        changes = np.concatenate([[-np.inf], changes, [np.inf]])
        at = start[self.piece] + self.arc_px
        after = np.searchsorted(changes, at)
        return np.minimum(at - changes[after - 1], changes[after] - at)
