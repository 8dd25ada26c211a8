# SPDX-License-Identifier: GPL-3.0-or-later
"""The item buffer on the GPU (native/fovea/visibility/item_buffer.h): ids of lines per texel, in layers by depth."""

import numpy as np

from .. import native
from .program import triangles
from .texture import Target


def item_of_point(clipped):
    """(M,) float32: id of the segment that starts at each point, index of its piece + 1."""
    return np.repeat(np.arange(1, len(clipped) + 1, dtype=np.float32), np.diff(clipped.offsets))


class ItemPass:
    """Draws the segments from an Atlas's tables on the GPU; holds only a batch of numbered quad corners."""

    def __init__(self, programs):
        self._programs = programs
        self._room, self._quads = 0, None

    def draw(self, atlas, depth, layout, count):
        """Draws `count` layers by depth peeling: Targets with the id of the nearest line at each texel of a depth
        Target, of the next behind it, and so on."""
        layers = []
        for number in range(count):
            target = Target(layout.width, layout.height, "R32F", depth=layers[0].depth if layers else True)
            # Both samplers must be bound even without two layers in front; `depth` fills in, as it is not the target.
            front = [*(layer.color for layer in layers), depth.color, depth.color]
            samplers = {"depth_buffer": depth.color, "layer0": front[0], "layer1": front[1]}
            with target.bind("GREATER_EQUAL") as framebuffer:
                framebuffer.clear(color=(0.0, 0.0, 0.0, 0.0), depth=0.0)
                for batch in atlas.batches:
                    self._lines(batch, layout, samplers, number)
            layers.append(target)
        return layers

    def _lines(self, batch, layout, samplers, layers_in_front):
        options = native.load().ItemOptions()
        program = self._programs.bind(
            "item",
            {"segments": batch.samplers["segments"], "items": batch.samplers["items"], **samplers},
            border=(layout.border_x, layout.border_y),
            buffer_size=(layout.width, layout.height),
            buffer_scale=float(layout.scale),
            slope_factor=options.slope_factor,
            bias=options.bias,
            layers_in_front=layers_in_front,
        )
        self._keep_room(len(batch.points))
        self._quads.draw_range(program, elem_start=0, elem_count=6 * len(batch.points))

    def _keep_room(self, segments):
        """Grows the quads to at least so many segments: two triangles over vertices 4 i .. 4 i + 3 of segment i."""
        if segments <= self._room:
            return
        self._room = segments + segments // 4
        corners = np.arange(4 * self._room, dtype=np.uint32)
        halves = corners.reshape(-1, 4)[:, (0, 1, 2, 2, 1, 3)].reshape(-1, 3)
        self._quads = triangles({"corner": corners}, np.ascontiguousarray(halves))
