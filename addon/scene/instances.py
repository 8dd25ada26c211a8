# SPDX-License-Identifier: GPL-3.0-or-later
"""The instances of a depsgraph as arrays."""

import numpy as np


def placements(depsgraph, viewport):
    """Objects, materials, visibility and matrices of all instances in a viewport (its SpaceView3D), without cameras; to
    be compared."""
    shown = []
    for instance in depsgraph.object_instances:
        obj = instance.object
        if obj.type == "CAMERA":
            shown.append(None)
            continue
        owner = (instance.parent if instance.is_instance else None) or obj
        names = [slot.material and slot.material.name_full for slot in obj.material_slots]
        seen = instance.show_self and owner.visible_in_viewport_get(viewport)
        shown.append((owner.name_full, obj.name_full, seen, names))
    kept = np.array([told is not None for told in shown], np.bool_)
    return shown, *(array[kept].tobytes() for array in arrays(depsgraph.object_instances))


def arrays(instances):
    """(k, 4, 4) float64 object-to-world matrices and (k, 8) int32 persistent ids of all instances, in order."""
    count = len(instances)
    matrices, persistent = np.empty((count, 4, 4), np.float32), np.empty((count, 8), np.int32)
    instances.foreach_get("matrix_world", matrices.ravel())
    instances.foreach_get("persistent_id", persistent.ravel())
    return matrices.transpose(0, 2, 1).astype(np.float64), persistent


def ids(names, persistent):
    """(n,) uint64 hashes of (n,) name hashes and (n, 8) persistent ids, which are both constant over frames."""
    mixed = names
    for column in persistent.T.astype(np.uint32):
        mixed = (mixed ^ column) * np.uint64(0x9E3779B97F4A7C15)
        mixed ^= mixed >> np.uint64(32)
    return mixed
