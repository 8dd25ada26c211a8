# SPDX-License-Identifier: GPL-3.0-or-later
"""How it is decided what is hidden: the methods, each the same two verbs.

    runs(frame, backend, cancel) -> visible Runs, and the samples by which their ends fade, or None where they are sharp
    draw(frame, backend, strokes, pens, textures) -> (height, width, 4) float32, strokes alone, premultiplied

All but the spine test know the visible runs before they draw (`knows`), and draw just these; only of what is seen can
one say what crowds it.
"""

from .backend import cpu


class Exact:
    """Rays: the same answer on every machine."""

    name = "exact"
    knows = True
    counts = True  # how many surfaces hide a line; samples only say whether something does

    def told(self, frame):
        """The method and its quality in words."""
        return "exact"

    def runs(self, frame, backend, cancel):
        return cpu.exact(frame, cancel), None

    def draw(self, frame, backend, strokes, pens, textures):
        return backend.draw(strokes, pens, textures, frame.view)


class SegmentAtlas(Exact):
    """Looks into a depth buffer at every sample along the lines (Cole & Finkelstein 2010, algorithm 2)."""

    name = "atlas"
    counts = False

    def told(self, frame):
        return f"segment atlas, {frame.probes} probes x {frame.depth_scale}"

    def runs(self, frame, backend, cancel):
        samples = backend.visibility(frame)
        return cpu.runs(frame.clipped, samples), samples


class ItemBuffer(Exact):
    """Lines drawn by number against a depth buffer; seen where their number is found (Northrup & Markosian 2000), with
    several lines to a pixel and several pixels to one (Cole & Finkelstein 2008)."""

    name = "item_buffer"
    counts = False

    def told(self, frame):
        return f"item buffer, {frame.layers} layers x {frame.depth_scale}"

    def runs(self, frame, backend, cancel):
        # Where lines share texels, samples in part are not seen in part: nothing to fade by.
        return cpu.runs(frame.clipped, backend.item_visibility(frame)), None


class SpineTest(Exact):
    """Every pixel of a stroke looks into a depth buffer where the middle of the stroke is next to it (Cole &
    Finkelstein 2010, algorithm 1). What is hidden has no ends of its own: no caps, gaps or spurs there, and no pen."""

    name = "spine"
    knows = False
    counts = False

    def told(self, frame):
        return f"spine test, {frame.probes} probes x {frame.depth_scale}"

    def runs(self, frame, backend, cancel):
        return cpu.whole(frame.clipped), None

    def draw(self, frame, backend, strokes, pens, textures):
        return backend.draw_seen(frame, strokes, pens, textures)


METHODS = {method.name: method for method in (Exact(), SegmentAtlas(), SpineTest(), ItemBuffer())}
