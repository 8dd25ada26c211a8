# SPDX-License-Identifier: GPL-3.0-or-later
"""The segment atlas on the GPU: tables of segments, and one texel per sample (native/fovea/visibility/layout.h)."""

import numpy as np

from .. import native
from .texture import Target, row_width, upload_row


class Atlas:
    """All atlas samples of a Frame, in batches that fit into textures; filled by one pass per depth tile."""

    def __init__(self, programs, frame, batch_samples):
        core, clipped = native.load(), frame.clipped
        self._programs, self._samples = programs, clipped.samples
        batches = core.AtlasBatch.of(clipped, batch_samples)
        sides = core.OwnSides(clipped, frame.scene, frame.view) if batches else None
        self.batches = [_Batch(clipped, sides, batch) for batch in batches]

    def add_table(self, name, values):
        """Adds a sampler `name` with one entry per segment. `values`: one per point of the paths; a segment has that of
        its first point."""
        for batch in self.batches:
            batch.samplers[name] = upload_row(values[batch.points])

    def run(self, program, layout, samplers, **constants):
        """Runs a program over all samples; it writes those inside the core of a DepthLayout."""
        for batch in self.batches:
            with batch.target.bind():
                self._programs.cover(
                    program,
                    {**batch.samplers, **samplers},
                    border=(layout.border_x, layout.border_y),
                    buffer_scale=float(layout.scale),
                    tile=layout.core,
                    sample_total=batch.count,
                    **constants,
                )

    def read(self):
        """Reads back the values of all samples, (samples,) float32."""
        result = np.zeros(self._samples, np.float32)
        for batch in self.batches:
            result[batch.begin : batch.begin + batch.count] = batch.target.read(1).reshape(-1)[: batch.count]
        return result


class _Batch:
    def __init__(self, clipped, sides, batch):
        self.begin, self.count = batch.sample_begin, batch.sample_end - batch.sample_begin
        tables = batch.tables(clipped, sides)
        self.samplers = {"segments": upload_row(tables.segments), "owners": upload_row(tables.owners)}
        start, end = clipped.sample_start, batch.sample_end
        self.points = np.flatnonzero((clipped.sample_count > 0) & (start >= self.begin) & (start < end))
        self.target = Target(row_width(), -(-self.count // row_width()), "R32F")
