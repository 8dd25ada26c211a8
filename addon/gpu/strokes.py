# SPDX-License-Identifier: GPL-3.0-or-later
"""Strokes on the GPU: uploaded once, then drawn into one target per image tile."""

import numpy as np

from .. import native
from .program import triangles
from .texture import Target, upload_row


class StrokePass:
    """Strokes with their pens. `spine_ranges`: (V, 2) per vertex, the first and last entry of its piece in the segment
    table of the spine test; None without it."""

    def __init__(self, programs, strokes, pens, textures, spine_ranges=None):
        table = native.load().PenTable(pens, textures)
        self._programs = programs
        self._samplers = {"pens": upload_row(table.pens), "ink": upload_row(table.ink)}
        attributes = {
            "px": strokes.px,
            "arc": strokes.arc,
            "width_opacity": np.stack((strokes.half_width, strokes.opacity), axis=1),
            "mixes": strokes.mix,
            "anchor": strokes.anchor,
            "pen": strokes.pen,
        }
        if spine_ranges is not None:
            attributes["spine_range"] = spine_ranges
        self._variant = "painted_" if len(strokes.color) else ""
        if self._variant:
            attributes["painted_color"] = strokes.color
        self._batch = triangles(attributes, np.ascontiguousarray(strokes.triangles, np.uint32))

    def draw(self, box, program="stroke", samplers=None, **constants):
        """Draws the strokes inside a box (left, lower, right, upper) of the image, in pixels; returns its Target."""
        left, lower, right, upper = box
        target = Target(right - left, upper - lower, "RGBA32F")
        with target.bind(blend="ALPHA_PREMULT") as framebuffer:
            framebuffer.clear(color=(0.0, 0.0, 0.0, 0.0))
            program = self._programs.bind(
                self._variant + program,
                {**self._samplers, **(samplers or {})},
                image_origin=(left, lower),
                image_size=(target.width, target.height),
                **constants,
            )
            self._batch.draw(program)
        return target


def boxes(width, height, side):
    """Boxes (left, lower, right, upper) of at most `side` pixels along each axis that tile an image."""
    corners = [(x, y) for y in range(0, height, side) for x in range(0, width, side)]
    return [(x, y, min(x + side, width), min(y + side, height)) for x, y in corners]


def box_of(layout, view):
    """Box (left, lower, right, upper) in pixels: a DepthLayout's core, clipped to the image; may be empty."""
    left, lower, right, upper = layout.core
    return max(int(left), 0), max(int(lower), 0), min(int(right), view.width), min(int(upper), view.height)
