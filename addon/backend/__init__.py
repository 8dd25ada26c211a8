# SPDX-License-Identifier: GPL-3.0-or-later
"""Backends: who decides what is hidden and who puts strokes on paper.

A backend is verbs over the same arrays:

    visibility(frame) -> (samples,) float32, one value in [0, 1] per atlas sample
    item_visibility(frame) -> the same by the item buffer
    draw(strokes, pens, textures, view) -> (height, width, 4) float32, strokes alone, premultiplied, bottom row first
    draw_seen(frame, strokes, pens, textures) -> the same of whole pieces, hidden by the spine test

`cpu` is the reference; `gpu` needs a context of Blender's gpu module. What comes before (lines, paths, projection) and
between (runs, shaping) is native and the same for both.
"""
