# SPDX-License-Identifier: GPL-3.0-or-later
"""How large objects are seen by the scene's camera, for what is made only as fine as it is seen."""

import numpy as np

from . import camera
from .problem import CannotDraw


def px_per_unit(depsgraph, instances, matrices):
    """{full name of an object: pixels of the final render per unit of its space, where an instance of it comes nearest
    to the scene's camera, rounded up to a power of two}; {} without a camera that can be drawn with.

    `instances`: those of the depsgraph; `matrices`: (k, 4, 4), theirs."""
    try:
        view = camera.of_scene(depsgraph)
    except CannotDraw:
        return {}
    boxes, names = np.zeros((len(matrices), 8, 3)), []
    known = {}
    for i, instance in enumerate(instances):
        obj = instance.object
        names.append(obj.name_full)
        if obj.name_full not in known:
            known[obj.name_full] = np.array(obj.bound_box)
        boxes[i] = known[obj.name_full]
    to_view = view.world_to_view @ matrices
    axes = np.linalg.norm(to_view[:, :3, :3], axis=1)
    focal = view.view_to_clip[1, 1] * view.height / 2
    if view.orthographic:
        sizes = focal * axes.max(axis=1)
    else:
        solvable = np.abs(np.linalg.det(to_view[:, :3, :3])) > 0.0
        eye = np.zeros((len(matrices), 3))
        eye[solvable] = -np.linalg.solve(to_view[solvable, :3, :3], to_view[solvable, :3, 3:])[..., 0]
        away = eye - np.clip(eye, boxes.min(axis=1), boxes.max(axis=1))
        distance = np.linalg.norm(np.einsum("kij,kj->ki", to_view[:, :3, :3], away), axis=1)
        sizes = focal * axes.max(axis=1) / np.maximum(distance, view.near_clip)
    largest = {}
    for name, size in zip(names, sizes, strict=True):
        largest[name] = max(largest.get(name, 0.0), size)
    return {name: float(2.0 ** np.ceil(np.log2(size))) if size > 0.0 else 0.0 for name, size in largest.items()}
