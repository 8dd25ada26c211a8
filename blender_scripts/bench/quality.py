# SPDX-License-Identifier: GPL-3.0-or-later
"""How near sampled visibility comes to exact visibility, sample by sample: shares that agree, with ever more of those
left out that lie at a true change of visibility, where no depth buffer of pixels can know better."""

import numpy as np

AGREES = 0.25  # visibility in [0, 1] may differ by so much
NEAR_PX = 2.0  # of a change: on the path, or beside it in the image


class Truth:
    """Visibility of the atlas samples of a Frame that has seen by rays, and which of them are `far` from a change: `all`; on their `path`;
    or also in the `image`, where the sample moved across its line by up to 2 px, at its own depth, is seen or hidden
    alike."""

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
        """The number of samples and, for each way to be far from a change, shares of the samples that are: of those
        that agree, of those seen too little, of those seen too much."""
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
    """Atlas samples that are not padding, in order: their index in the atlas, segment, piece, and arc length."""

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
        """Pixels along the piece to where the nearest run starts or ends, without runs that reach its ends."""
        arc, offsets = self._clipped.arc_px, self._clipped.offsets.astype(np.int64)
        first, last = arc[offsets[:-1]], arc[offsets[1:] - 1]
        # Pieces one after the other on one axis, far enough apart.
        start = np.cumsum(last - first + 1e3) - (last - first) - first
        piece, ends = np.tile(runs.piece, 2), np.concatenate([runs.start_px, runs.end_px])
        inside = (ends > first[piece] + 1e-6) & (ends < last[piece] - 1e-6)
        changes = np.sort((start[piece] + ends)[inside])
        changes = np.concatenate([[-np.inf], changes, [np.inf]])
        at = start[self.piece] + self.arc_px
        after = np.searchsorted(changes, at)
        return np.minimum(at - changes[after - 1], changes[after] - at)
