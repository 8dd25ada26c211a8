# SPDX-License-Identifier: GPL-3.0-or-later
"""The instances of a depsgraph as arrays."""

from array import array
from collections import deque

import bpy
import numpy as np

from .. import native

POLLED = 1 << 10  # instances from one look at a Cancel to the next
# Blender 4.3 never frees the instances of an object, 250 bytes each, where a traversal ends among them, as that of
# foreach_get does. 5.2 does; between them, nobody has looked.
AT_ONCE = bpy.app.version >= (5, 2)


def instancer(instance):
    """The object that an instance is of; None of what no object instances."""
    return instance.parent if instance.is_instance else None


def owner(instance):
    """Whose visibility an instance has: its instancer's or, of what no object instances, its own."""
    return instancer(instance) or instance.object


def placements(depsgraph, viewport):
    """Objects, materials, visibility and matrices of all instances in a viewport (its SpaceView3D), without cameras; to
    be compared."""
    told, index = [], []  # index: by kind, that of what is told of it; -1: a camera

    def meet(instance):
        obj, instancer = instance.object, owner(instance)
        index.append(-1 if obj.type == "CAMERA" else len(told))
        if obj.type == "CAMERA":
            return
        names = [slot.material and slot.material.name_full for slot in obj.material_slots]
        seen = instance.show_self and instancer.visible_in_viewport_get(viewport)
        told.append((instancer.name_full, obj.name_full, seen, names))

    matrices, persistent, kinds = read(depsgraph.object_instances, meet)
    of_instance = np.array(index, np.int32)[kinds]
    return told, *(array[of_instance >= 0].tobytes() for array in (of_instance, matrices, persistent))


def read(instances, meet, cancel=None):
    """Of all k instances, in order: (k, 4, 4) float64 object-to-world matrices, (k, 8) int32 persistent ids, and (k,)
    int32 kinds. Instances of a kind differ in their places alone: `meet(instance)` is called with the first of each.
    `cancel`: a native Cancel, which is polled, or None."""
    count = len(instances)
    matrices, persistent = np.empty((count, 16), np.float32), np.empty((count, 8), np.int32)
    known, kinds = {}, array("i")
    each = iter(instances)
    for instance in each if AT_ONCE else _filling(each, matrices, persistent):
        if cancel and not len(kinds) % POLLED and cancel.requested:
            if not AT_ONCE:
                deque(each, maxlen=0)  # to their end
            raise native.cancelled()
        # The object of an instance is a temporary copy, all of them at one address, and the Python object that is made
        # for each is never freed where nodes gave it other data: so none is made where there is a source.
        data, source = instance.path_resolve("object.data"), instance.instance_object or instance.object
        key = data, source, instance.parent, instance.show_self, instance.show_particles
        if key not in known:
            known[key] = len(known)
            meet(instance)
        kinds.append(known[key])
    if AT_ONCE:
        instances.foreach_get("matrix_world", matrices.ravel())
        instances.foreach_get("persistent_id", persistent.ravel())
    return matrices.reshape(-1, 4, 4).transpose(0, 2, 1).astype(np.float64), persistent, np.array(kinds, np.int32)


def _filling(instances, matrices, persistent):
    """Each of the instances; on the way, their matrices and ids fill the arrays."""
    for instance, matrix, numbers in zip(instances, matrices, persistent):  # first the instances: to their end
        instance.path_resolve("matrix_world", False).foreach_get(matrix)  # False: its numbers, without a Matrix
        instance.persistent_id.foreach_get(numbers)
        yield instance


def ids(names, persistent):
    """(n,) uint64 hashes of (n,) name hashes and (n, 8) persistent ids, which are both constant over frames."""
    mixed = names
    for column in persistent.T.astype(np.uint32):
        mixed = (mixed ^ column) * np.uint64(0x9E3779B97F4A7C15)
        mixed ^= mixed >> np.uint64(32)
    return mixed
