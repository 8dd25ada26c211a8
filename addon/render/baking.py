# SPDX-License-Identifier: GPL-3.0-or-later
"""Converts DrawnLines to Blender objects: meshes of edges, or Grease Pencil strokes."""

import bpy
import numpy as np

from ..scene import pencils

# Point attributes: name -> type.
NUMBERS = {"strength": "FLOAT", "opacity": "FLOAT", "radius": "FLOAT", "kinds": "INT", "invisibility": "INT"}


def parts(lines, index):
    """The DrawnLines of one line set, as a dict of arrays: points (M, 3) float32, color (M, 4) float32, NUMBERS (M,),
    and per polyline size, closed and pen. The last point of a closed polyline, which repeats the first, is dropped."""
    size = np.diff(lines.offsets)
    wanted = lines.line_set == index
    last = np.zeros(len(lines.points), bool)
    last[lines.offsets[1:][lines.closed] - 1] = True
    at = np.repeat(wanted, size) & ~last
    found = {name: getattr(lines, name)[at] for name in ("strength", "opacity", "radius")}
    found["kinds"] = lines.kinds[at].view(np.int32)
    found["invisibility"] = np.repeat(lines.invisibility, size)[at].astype(np.int32)
    found["points"] = lines.points[at].astype(np.float32)
    found["color"] = np.column_stack([lines.color[at], np.ones(at.sum(), np.float32)])
    found |= {"size": (size - lines.closed)[wanted], "closed": lines.closed[wanted], "pen": lines.pen[wanted]}
    return found


def mesh(name, found):
    """A mesh of edges from the arrays of `parts`, with NUMBERS as point attributes."""
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


def grease_pencil(name, found, pens, frame):
    """Grease Pencil data from the arrays of `parts`: strokes on one layer at a frame, one material per pen."""
    data = pencils.kept().new(name)
    used = np.unique(found["pen"])
    for pen in used:
        data.materials.append(_material(name, pens[pen]))
    drawing = data.layers.new(name).frames.new(frame).drawing
    drawing.add_strokes(found["size"].tolist())
    attributes = drawing.attributes
    attributes["position"].data.foreach_set("vector", found["points"].ravel())
    for attribute in ("radius", "opacity", "strength"):
        _attribute(attributes, attribute, "FLOAT", "POINT").data.foreach_set("value", found[attribute])
    colors = _attribute(attributes, "vertex_color", "FLOAT_COLOR", "POINT").data
    colors.foreach_set("color", _apart(found, pens).ravel())
    _attribute(attributes, "cyclic", "BOOLEAN", "CURVE").data.foreach_set("value", found["closed"])
    index = np.searchsorted(used, found["pen"]).astype(np.int32)
    _attribute(attributes, "material_index", "INT", "CURVE").data.foreach_set("value", index)
    return data


def _apart(found, pens):
    """(M, 4) float32 colors that cover those of the materials, alpha 1, along strokes that focus gives another color;
    elsewhere alpha 0, so that materials color their strokes."""
    own = np.repeat(np.array([pens[pen].color for pen in found["pen"]], np.float32), found["size"], axis=0)
    other = np.abs(found["color"][:, :3] - own).max(axis=1) > 1e-4
    stroke = np.repeat(np.arange(len(found["size"])), found["size"])
    changed = np.bincount(stroke[other], minlength=len(found["size"])) > 0
    return np.where(changed[stroke][:, None], found["color"], np.float32(0))


def _attribute(attributes, name, kind, domain):
    return attributes.get(name) or attributes.new(name, kind, domain)


def _material(name, pen):
    material = bpy.data.materials.new(name)
    bpy.data.materials.create_gpencil_data(material)
    material.grease_pencil.color = (*pen.color, 1.0)
    return material


def objects(lines, chosen, kind, frame):
    """New objects of `kind` MESH or GREASE_PENCIL, one per line set with lines, not yet linked to a collection."""
    made = []
    for index, line_set in enumerate(chosen.line_sets):
        found = parts(lines, index)
        if not len(found["size"]):
            continue
        name = line_set.name.title()
        if kind == "MESH":
            data = mesh(name, found)
        else:
            data = grease_pencil(name, found, chosen.pens(), frame)
        made.append(bpy.data.objects.new(name, data))
        made[-1].fovea.usage = "IGNORE"  # so that baked lines do not get lines themselves
    return made
