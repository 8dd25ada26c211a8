# SPDX-License-Identifier: GPL-3.0-or-later
"""Keyframes and strokes of layers of Grease Pencil: room for strokes that replace earlier ones, and adding them.

Strokes of a program carry an id in an attribute of curves, two integers; it is 0 for those drawn by hand. Adding a
keyframe may move the others in memory, so they are looked up by their numbers."""

import numpy as np

from ..scene import pencils

FIELDS = {"FLOAT_VECTOR": ("vector", 3), "FLOAT_COLOR": ("color", 4), "INT32_2D": ("value", 2)}  # of an attribute


def clear(layer, mark, keys, span, *, always, ends):
    """Gives a layer keyframes at the frames `keys`, ascending, with what it shows there, and takes out the strokes that
    carry an id from all frames of `span` (first, last). Keyframes that nothing is left of go, except `keys`. `ends`:
    what the layer shows after `span` stays, by a keyframe. `always`: also where no stroke carries an id."""
    first, last = span
    inside = {number for number in _numbers(layer) if first <= number <= last}
    held = layer.get_frame_at(first)
    shown = inside | ({held.frame_number} if held else set())
    if not always and not any(_marked(layer.get_frame_at(number).drawing, mark).any() for number in shown):
        return
    if ends:
        _key(layer, last + 1)
    _key(layer, first)
    for number in sorted(inside | {first}):
        drawing = layer.get_frame_at(number).drawing
        marked = np.flatnonzero(_marked(drawing, mark))
        if len(marked):
            drawing.remove_strokes(indices=marked.tolist())
        if len(marked) and number not in keys and not _count(drawing):
            layer.frames.remove(number)
    for number in keys:
        _key(layer, number)


def _numbers(layer):
    return [frame.frame_number for frame in layer.frames]


def _key(layer, number):
    """Gives a layer a keyframe, with a copy of what it shows there."""
    shown = layer.get_frame_at(number)
    if shown is None:
        layer.frames.new(number)
    elif shown.frame_number != number:
        layer.frames.copy(shown.frame_number, number)


def _count(drawing):
    return drawing.attributes.domain_size("CURVE")


def _marked(drawing, mark):
    """(strokes,) bool."""
    attribute = drawing.attributes.get(mark)
    if attribute is None:
        return np.zeros(_count(drawing), bool)
    ids = np.empty((len(attribute.data), 2), np.int32)
    attribute.data.foreach_get("value", ids.ravel())
    return ids.any(axis=1)


def append(drawing, sizes, of_points, of_strokes):
    """Adds strokes of so many points after those of a drawing. `of_points`, `of_strokes`: {(attribute, type): values
    of the new points and strokes}."""
    pencils.need("bake with the type Mesh")
    drawing.add_strokes(sizes.tolist())
    for domain, given in (("POINT", of_points), ("CURVE", of_strokes)):
        for (name, kind), values in given.items():
            attribute = drawing.attributes.get(name) or drawing.attributes.new(name, kind, domain)
            what, columns = FIELDS.get(kind, ("value", 1))
            whole = np.empty((len(attribute.data), columns), values.dtype)
            attribute.data.foreach_get(what, whole.ravel())
            whole[len(whole) - len(values) :] = values.reshape(-1, columns)
            attribute.data.foreach_set(what, whole.ravel())
    drawing.tag_positions_changed()
