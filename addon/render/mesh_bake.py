# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawn lines as meshes of edges."""

import bpy
import numpy as np

# Point attributes: name -> type.
NUMBERS = {"strength": "FLOAT", "opacity": "FLOAT", "radius": "FLOAT", "kinds": "INT", "invisibility": "INT"}


def objects(lines, style):
    """New objects of DrawnLines, one per line set with lines, not yet linked to a collection."""
    made = []
    for index, line_set in enumerate(style.line_sets):
        found = _part(lines, lines.line_set == index)
        if len(found["size"]):
            name = line_set.name.title()
            made.append(bpy.data.objects.new(name, _mesh(name, found)))
    return made


def _part(lines, wanted):
    """Some of the polylines, as a dict of arrays: points (M, 3), color (M, 4), NUMBERS (M,), and per polyline size and
    closed. The last point of a closed polyline, which repeats the first, is dropped."""
    size = np.diff(lines.offsets)
    last = np.zeros(len(lines.points), bool)
    last[lines.offsets[1:][lines.closed] - 1] = True
    at = np.repeat(wanted, size) & ~last
    return {
        "points": lines.points[at],
        "color": np.column_stack([lines.color[at], np.ones(at.sum(), np.float32)]),
        "strength": lines.strength[at],
        "opacity": lines.opacity[at],
        "radius": lines.radius[at],
        "kinds": lines.kinds[at].view(np.int32),
        "invisibility": np.repeat(lines.invisibility, size)[at].astype(np.int32),
        "size": (size - lines.closed)[wanted],
        "closed": lines.closed[wanted],
    }


def _mesh(name, found):
    """A mesh of edges from the arrays of `_part`, with NUMBERS and color as point attributes."""
    data, count = bpy.data.meshes.new(name), len(found["points"])
    edges = _edges(found["size"], found["closed"])
    data.vertices.add(count)
    data.vertices.foreach_set("co", found["points"].ravel())
    data.edges.add(len(edges))
    data.edges.foreach_set("vertices", edges.ravel())
    for attribute, kind in NUMBERS.items():
        data.attributes.new(attribute, kind, "POINT").data.foreach_set("value", found[attribute])
    data.attributes.new("color", "FLOAT_COLOR", "POINT").data.foreach_set("color", found["color"].ravel())
    data.update()
    return data


def _edges(size, closed):
    """(E, 2) int32 edges of consecutive polylines of `size` points; a closed one has an edge back to its start."""
    start = np.cumsum(size) - size
    following = np.arange(size.sum()) + 1
    ends = start + size - 1
    following[ends] = np.where(closed, start, -1)
    first = np.flatnonzero(following >= 0)
    return np.stack([first, following[first]], axis=1).astype(np.int32)
