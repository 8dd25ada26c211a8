# SPDX-License-Identifier: GPL-3.0-or-later
"""The gpu backend: visibility, elision and strokes with Blender's gpu module, which only this package imports.

A backend implements three methods over a native Frame (native/fovea/draw/backend.h):

    visibility(frame) -> (samples,) float32 in [0, 1] per atlas sample, by the segment atlas or the item buffer
    elide(frame, elision) -> (D, 2) float32, occupancy of the band of each of the D samples that runs cover
    draw(frame, image) -> image, (height, width, 4) float32: strokes alone, premultiplied, bottom row first

The cpu backend is native and the reference; this one needs a context of Blender's gpu module. All other stages are the
Frame's and the same for both.
"""
