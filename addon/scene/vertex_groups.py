# SPDX-License-Identifier: GPL-3.0-or-later
"""Weights of vertex groups, as arrays.

No version of Blender hands them out as an array: they are no attributes of the mesh, and what would make them some (a
node group, an operator) writes to the file that is drawn. So vertices are asked one by one, about a microsecond each,
and in viewports only after the geometry of their object has changed.
"""

import bpy
import numpy as np


def index(obj, name):
    """Index of an object's vertex group of that name; None if there is none."""
    group = obj.vertex_groups.get(name) if isinstance(obj.data, bpy.types.Mesh) else None
    return None if group is None else group.index


def read(mesh, group):
    """(V, 1) float32 weights of the group with that index, 0 where a vertex is not in it."""
    where, weights = [], []
    for i, vertex in enumerate(mesh.vertices):
        for element in vertex.groups:
            if element.group == group:
                where.append(i)
                weights.append(element.weight)
    found = np.zeros((len(mesh.vertices), 1), np.float32)
    found[where, 0] = weights
    return found


class Weights:
    """Weights of the evaluated meshes of one depsgraph at a time. In viewports they are kept until `forget` is called
    with an update of the geometry of their object; renders read them anew, as no updates are known of them."""

    def __init__(self):
        self._known, self._of = {}, None

    def begin(self, depsgraph):
        """Starts a pass over a depsgraph."""
        of = depsgraph.scene.name_full, depsgraph.view_layer.name
        if depsgraph.mode == "RENDER" or of != self._of:
            self._known.clear()
        self._of = of

    def of(self, obj, mesh, group):
        """`read`, or what was read before."""
        of_object = self._known.setdefault(obj.name_full, {})
        key = mesh.name_full, group
        if key not in of_object or len(of_object[key]) != len(mesh.vertices):
            of_object[key] = read(mesh, group)
        return of_object[key]

    def forget(self, updates=None):
        """Forgets the objects whose geometry the updates of a depsgraph are about; None: all."""
        if updates is None:
            self._known.clear()
            return
        for update in updates:
            if update.is_updated_geometry and isinstance(update.id, bpy.types.Object):
                self._known.pop(update.id.name_full, None)

    def size(self):
        """Bytes."""
        return sum(values.nbytes for known in self._known.values() for values in known.values())
