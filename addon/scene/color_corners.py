# SPDX-License-Identifier: GPL-3.0-or-later
"""Attributes of a mesh at the corners of its native surface."""

import weakref

import numpy as np

from . import color_nodes

COLORS = {"FLOAT_COLOR", "BYTE_COLOR"}


class Corners:
    """Read when first asked for; `uvs` and `attributes` hold what was. `cage()`: a context with the mesh whose corners
    were refined, where the surface is a refined one; else the mesh's are the surface's own. `known`: what is kept from
    picture to picture of refined ones, for evaluating a cage takes as long as evaluating the object."""

    def __init__(self, core, obj, mesh, surface, cage, known):
        self._core, self._name, self._mesh = core, obj.name_full, mesh
        self._surface, self._known = surface, known
        self._cage = cage if isinstance(surface, core.RefinedSurface) else None
        self._index_of = {}
        self.uvs, self.attributes = [], []

    def normals(self):
        """(C, 3) as Blender shades; None: those of the limit surface."""
        return None if self._cage else _read(self._mesh.corner_normals, "vector", 3)

    def uv(self, name, place):
        """Which of `uvs` holds a UV map, mapped; None where there is none."""
        if name == color_nodes.ACTIVE:
            name = next((layer.name for layer in self._mesh.uv_layers if layer.active_render), None)
        found = self._mesh.attributes.get(name) if name else None
        if found is None or (found.data_type, found.domain) != ("FLOAT2", "CORNER"):
            return None
        return self._index(self.uvs, (name, place), lambda: _mapped(self._refined(name, _uvs), place))

    def attribute(self, name):
        """Which of `attributes` holds a color attribute; None where there is none."""
        colors = self._mesh.color_attributes
        if name == color_nodes.ACTIVE:
            index = colors.render_color_index
            name = colors[index].name if 0 <= index < len(colors) else None
        if not name or name not in colors or colors[name].domain not in {"POINT", "CORNER"}:
            return None
        return self._index(self.attributes, name, lambda: self._refined(name, _colors))

    def values(self, name):
        """(C,) float32 of an attribute of numbers, or the mean of a color's channels; None where there is none."""
        found = self._mesh.attributes.get(name)
        if found is None or found.data_type not in COLORS | {"FLOAT"} or found.domain not in {"POINT", "CORNER"}:
            return None
        return self._refined(name, _values)[:, 0]

    def _index(self, arrays, name, read):
        if (id(arrays), name) not in self._index_of:
            self._index_of[id(arrays), name] = len(arrays)
            arrays.append(read())
        return self._index_of[id(arrays), name]

    def _refined(self, name, read):
        """What `read` gives of an attribute, at the surface's corners."""
        values = read(self._mesh, name)
        if self._cage is None:
            return values
        # What Blender made of the cage tells whether it has changed.
        key, seen = (self._name, self._mesh.name_full, name, read), self._core.content_hash(values)
        entry = self._known.get(key)
        if entry is None or entry[0] != seen or entry[1]() is not self._surface:
            with self._cage() as cage:
                mixed = self._surface.mix_corners(read(cage, name), _offsets(cage))
            entry = self._known[key] = (seen, weakref.ref(self._surface), mixed)
        return entry[2]


def _uvs(mesh, name):
    return _read(mesh.attributes[name].data, "vector", 2)


def _colors(mesh, name):
    """(C, 3) scene-linear colors."""
    return np.ascontiguousarray(_at_corners(mesh, mesh.attributes[name], "color", 4)[:, :3])


def _values(mesh, name):
    """(C, 1) numbers, or means of scene-linear colors."""
    attribute = mesh.attributes[name]
    if attribute.data_type in COLORS:
        return _at_corners(mesh, attribute, "color", 4)[:, :3].mean(axis=1, keepdims=True)
    return _at_corners(mesh, attribute, "value", 1)


def _at_corners(mesh, attribute, what, columns):
    values = _read(attribute.data, what, columns)
    if attribute.domain != "POINT":
        return values
    vertices = np.empty(len(mesh.loops), np.int32)
    mesh.attributes[".corner_vert"].data.foreach_get("value", vertices)
    return values[vertices]


def _offsets(mesh):
    offsets = np.empty(len(mesh.polygons) + 1, np.int32)
    mesh.polygons.foreach_get("loop_start", offsets[:-1])
    offsets[-1] = len(mesh.loops)
    return offsets


def _read(data, what, columns):
    values = np.empty((len(data), columns), np.float32)
    data.foreach_get(what, values.ravel())
    return values


def _mapped(uvs, place):
    if place == color_nodes.Source.place:
        return uvs
    rows = np.array(place, np.float32).reshape(2, 3)
    return uvs @ rows[:, :2].T + rows[:, 2]
