# SPDX-License-Identifier: GPL-3.0-or-later
"""Backends: who decides what is hidden and who puts strokes on paper.

A backend is three verbs over a native Frame (native/fovea/draw/backend.h):

    visibility(frame) -> (samples,) float32 in [0, 1] per atlas sample, by the segment atlas or the item buffer
    elide(frame, elision) -> (D, 2) float32, how crowded each sample is that runs cover
    draw(frame) -> (height, width, 4) float32, strokes alone, premultiplied, bottom row first

`cpu` is the reference, and native; `gpu` needs a context of Blender's gpu module. What comes before and between is the
Frame's and the same for both.
"""
