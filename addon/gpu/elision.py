# SPDX-License-Identifier: GPL-3.0-or-later
"""Line elision on the GPU (native/fovea/elision): draws the priority buffer, then measures the occupancy per sample."""

import math

import gpu
import numpy as np

from .program import triangles
from .texture import Target, row_width, upload_row

_BEYOND = 1e30  # px; farther than any sample


def border_of(elision):
    """Pixels around a sample of a native Elision that the test may read of the priority buffer: an upper bound."""
    return math.ceil(elision.band[:, 0].max(initial=0.0) * elision.END_REACH + elision.WINDOW_LENGTH_PX)


class ElisionPass:
    """Bands and samples of a native Elision, uploaded once; each image tile fills in the samples inside it."""

    def __init__(self, programs, elision, batch_samples):
        self._programs, self._border = programs, border_of(elision)
        self._window = {
            "window_columns": elision.WINDOW_COLUMNS,
            "most_rows": elision.MOST_WINDOW_ROWS,
            "window_length": elision.WINDOW_LENGTH_PX,
            "end_reach": elision.END_REACH,
            "reach": elision.reach_px,
        }
        owners = elision.owner
        self._most_rank = float(owners[:, 2].max(initial=0.0))
        self._bands = None
        if len(elision.triangles):
            attributes = {"px": elision.px, "across": elision.across, "owner": owners}
            self._bands = triangles(attributes, elision.triangles)
        rows = max(1, batch_samples // row_width()) * row_width()
        tables = {"places": elision.place, "bands": elision.band, "ends": elision.ends, "figures": elision.figure}
        self._figure_of_rank = upload_row(elision.figure_of_rank)
        starts = range(0, len(elision.place), rows)
        self._batches = [_Batch({name: table[i : i + rows] for name, table in tables.items()}) for i in starts]

    def look(self, box, view, clock):
        """Fills in the samples inside a box (left, lower, right, upper) in pixels of a View's image; a box at the image
        border includes the samples beyond it."""
        if self._bands is None:
            return
        whole = (0, 0, view.width, view.height)
        drawn = [max(e - self._border, w) for e, w in zip(box[:2], whole[:2], strict=True)]
        drawn += [min(e + self._border, w) for e, w in zip(box[2:], whole[2:], strict=True)]
        layers = self._draw(drawn)
        clock.mark("priority buffer", layers[1])
        decided = [_BEYOND * (1 if w else -1) if e == w else e for e, w in zip(box, whole, strict=True)]
        for batch in self._batches:
            with batch.target.bind():
                self._programs.cover(
                    "elision",
                    {
                        **batch.samplers,
                        "figure_of_rank": self._figure_of_rank,
                        "layer0": layers[0].color,
                        "layer1": layers[1].color,
                    },
                    tile=decided,
                    buffer_origin=drawn[:2],
                    sample_total=batch.count,
                    **self._window,
                )
        clock.mark("samples", self._batches[-1].target)

    def _draw(self, box):
        """Draws the two layers of the priority buffer for a box, by depth peeling on rank; returns their Targets."""
        left, lower, right, upper = box
        size = (right - left, upper - lower)
        layers = []
        for number in range(2):
            target = Target(*size, "RG32UI", depth=layers[0].depth if layers else True)
            target.color.clear(format="UINT", value=(0, 0))
            # The sampler must be bound even for the first layer; a texture must not be read while it is the target.
            front = layers[0].color if layers else gpu.types.GPUTexture((1, 1), format="RG32UI")
            with target.bind("GREATER") as framebuffer:
                framebuffer.clear(depth=0.0)
                program = self._programs.bind(
                    "priority",
                    {"layer0": front},
                    buffer_origin=(left, lower),
                    buffer_size=size,
                    most_rank=self._most_rank,
                    layers_in_front=number,
                )
                self._bands.draw(program)
            layers.append(target)
        return layers

    def read(self):
        """(D, 2) float32 per sample: pixels of its band in the window that are lost, and all pixels of it there."""
        parts = [batch.target.read(2).reshape(-1, 2)[: batch.count] for batch in self._batches]
        return np.concatenate(parts) if parts else np.zeros((0, 2), np.float32)


class _Batch:
    def __init__(self, tables):
        self.count = len(tables["places"])
        self.samplers = {name: upload_row(table) for name, table in tables.items()}
        self.target = Target(row_width(), -(-self.count // row_width()), "RG32F")
        with self.target.bind() as framebuffer:
            framebuffer.clear(color=(0.0, 0.0, 0.0, 0.0))
