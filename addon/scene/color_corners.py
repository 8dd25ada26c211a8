# SPDX-License-Identifier: GPL-3.0-or-later
"""UV maps, attributes and vertex groups of a mesh, as arrays over the corners of its native surface."""

import weakref

import numpy as np

from . import color_nodes, mesh_arrays, vertex_groups

COLORS = {"FLOAT_COLOR", "BYTE_COLOR"}
VECTORS = {"FLOAT2": 2, "FLOAT_VECTOR": 3}  # types of attributes that may place an image, and their components


class Corners:
    """Reads arrays over the C corners on demand (over the vertices of a mesh without faces) and collects them in `uvs`
    and `attributes`. If the surface is a refined one, values are read from the mesh in the context `cage()` and
    interpolated to the refined corners; else the corners are those of `mesh`. `cache`: the ColorCache that keeps
    refined arrays between pictures, because evaluating a cage takes as long as evaluating the object, and weights; only
    UV maps are read without one."""

    def __init__(self, core, obj, mesh, surface, cage, cache):
        self._core, self._obj, self._mesh = core, obj, mesh
        self._surface, self._cache = surface, cache
        self._cage = cage if isinstance(surface, core.RefinedSurface) else None
        self._is_cut = isinstance(surface, core.CutSurface)
        self._index_of = {}
        self.uvs, self.attributes = [], []

    def normals(self):
        """(C, 3) Blender's corner normals; None for a refined surface, which uses limit normals."""
        return None if self._cage else self._cut(_read(self._mesh.corner_normals, "vector", 3))

    def uv(self, name, place):
        """Index into `uvs` of a UV map transformed by `place` (two rows, see color_nodes.Source); None if missing."""
        if name == color_nodes.ACTIVE:
            name = next((layer.name for layer in self._mesh.uv_layers if layer.active_render), None)
        found = self._mesh.attributes.get(name) if name else None
        if found is None or found.data_type not in VECTORS or found.domain not in {"POINT", "CORNER"}:
            return None
        return self._index(self.uvs, (name, place), lambda: _mapped(self._refined(name, _uvs), place))

    def attribute(self, name):
        """Index into `attributes` of a color attribute; None if missing."""
        colors = self._mesh.color_attributes
        if name == color_nodes.ACTIVE:
            index = colors.render_color_index
            name = colors[index].name if 0 <= index < len(colors) else None
        if not name or name not in colors or colors[name].domain not in {"POINT", "CORNER"}:
            return None
        return self._index(self.attributes, name, lambda: self._refined(name, _colors))

    def values(self, name):
        """(C,) float32 of a float attribute, or the mean of a color attribute's channels; None if missing."""
        return self._refined(name, _values)[:, 0] if self._is_painted(name) else None

    def colors(self, name):
        """(C, 3) float32 of a color attribute, or of a float attribute as grays; None if missing."""
        return self._refined(name, _colors_or_grays) if self._is_painted(name) else None

    def weights(self, name):
        """(C,) float32 of a vertex group; None if missing."""
        group = vertex_groups.index(self._obj, name)
        if group is None:
            return None
        known = self._cache.weights.of(self._obj, self._mesh, group)
        return self._refined(group, _weights, _of_vertices(self._mesh, known))[:, 0]

    def _is_painted(self, name):
        found = self._mesh.attributes.get(name)
        return found is not None and found.data_type in COLORS | {"FLOAT"} and found.domain in {"POINT", "CORNER"}

    def _index(self, arrays, name, read):
        if (id(arrays), name) not in self._index_of:
            self._index_of[id(arrays), name] = len(arrays)
            arrays.append(read())
        return self._index_of[id(arrays), name]

    def _refined(self, name, read, values=None):
        """read(mesh, name) as an array over the surface's corners. `values`: what it gives for the mesh, if known."""
        values = read(self._mesh, name) if values is None else values
        if self._cage is None:
            return self._cut(values)
        # Blender's subdivided mesh shows whether the cage has changed, without evaluating the cage.
        key = self._obj.name_full, self._mesh.name_full, name, read
        seen, entry = self._core.content_hash(values), self._cache.refined.get(key)
        if entry is None or entry[0] != seen or entry[1]() is not self._surface:
            with self._cage() as cage:
                offsets = mesh_arrays.read_offsets(cage, np.empty(len(cage.polygons) + 1, np.int32))
                mixed = self._surface.mix_corners(read(cage, name), offsets)
            entry = self._cache.refined[key] = (seen, weakref.ref(self._surface), mixed)
        return entry[2]

    def _cut(self, values):
        """Values at the mesh's corners as an array over the surface's, which may be cut out of the mesh."""
        return self._surface.mix_corners(values) if self._is_cut else values


def _uvs(mesh, name):
    """(C, 2) texture coordinates."""
    attribute = mesh.attributes[name]
    return np.ascontiguousarray(_at_corners(mesh, attribute, "vector", VECTORS[attribute.data_type])[:, :2])


def _colors(mesh, name):
    """(C, 3) scene-linear colors."""
    return np.ascontiguousarray(_at_corners(mesh, mesh.attributes[name], "color", 4)[:, :3])


def _colors_or_grays(mesh, name):
    """(C, 3) scene-linear colors, or floats as such."""
    if mesh.attributes[name].data_type in COLORS:
        return _colors(mesh, name)
    return np.repeat(_at_corners(mesh, mesh.attributes[name], "value", 1), 3, axis=1)


def _weights(mesh, group):
    """(C, 1) weights of the vertex group with that index."""
    return _of_vertices(mesh, vertex_groups.read(mesh, group))


def _values(mesh, name):
    """(C, 1) floats, or means of scene-linear colors."""
    attribute = mesh.attributes[name]
    if attribute.data_type in COLORS:
        return _at_corners(mesh, attribute, "color", 4)[:, :3].mean(axis=1, keepdims=True)
    return _at_corners(mesh, attribute, "value", 1)


def _at_corners(mesh, attribute, what, columns):
    values = _read(attribute.data, what, columns)
    return _of_vertices(mesh, values) if attribute.domain == "POINT" else values


def _of_vertices(mesh, values):
    """Values of vertices at the corners; those of a mesh without faces as they are."""
    if not len(mesh.loops):
        return values
    vertices = np.empty(len(mesh.loops), np.int32)
    mesh.attributes[".corner_vert"].data.foreach_get("value", vertices)
    return values[vertices]


def _read(data, what, columns):
    values = np.empty((len(data), columns), np.float32)
    data.foreach_get(what, values.ravel())
    return values


def _mapped(uvs, place):
    if place == color_nodes.Source.place:
        return uvs
    rows = np.array(place, np.float32).reshape(2, 3)
    return uvs @ rows[:, :2].T + rows[:, 2]
