# SPDX-License-Identifier: GPL-3.0-or-later
"""The gpu backend: Blender's gpu module decides what is hidden and puts strokes on paper. Only here it is imported.

A backend is three verbs over a native Frame (native/fovea/draw/backend.h):

    visibility(frame) -> (samples,) float32 in [0, 1] per atlas sample, by the segment atlas or the item buffer
    elide(frame, elision) -> (D, 2) float32, how crowded each sample is that runs cover
    draw(frame) -> (height, width, 4) float32, strokes alone, premultiplied, bottom row first

The cpu backend is the reference, and native; this one needs a context of Blender's gpu module. What comes before and
between is the Frame's and the same for both.
"""
