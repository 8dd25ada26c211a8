# SPDX-License-Identifier: GPL-3.0-or-later
"""How large objects are seen by the scene's camera, for what is made only as fine as it is seen."""

import numpy as np

from . import camera, instances
from .problem import CannotDraw


def px_per_unit(depsgraph, cancel=None):
    """{full name of an object: pixels of the final render per unit of its space, where an instance of it comes nearest
    to the scene's camera, rounded up to a power of two}; {} without a camera that can be drawn with. `cancel`
    as for instances.read."""
    try:
        view = camera.of_scene(depsgraph)
    except CannotDraw:
        return {}
    names, boxes = [], []  # by kind

    def meet(instance):
        names.append(instance.object.name_full)
        boxes.append(np.array(instance.object.bound_box))

    matrices, _, kinds = instances.read(depsgraph.object_instances, meet, cancel)
    boxes = np.reshape(boxes, (-1, 8, 3))
    lowest, highest = boxes.min(axis=1)[kinds], boxes.max(axis=1)[kinds]
    to_view = view.world_to_view @ matrices
    axes = np.linalg.norm(to_view[:, :3, :3], axis=1)
    focal = view.view_to_clip[1, 1] * view.height / 2
    if view.orthographic:
        sizes = focal * axes.max(axis=1)
    else:
        solvable = np.abs(np.linalg.det(to_view[:, :3, :3])) > 0.0
        eye = np.zeros((len(matrices), 3))
        eye[solvable] = -np.linalg.solve(to_view[solvable, :3, :3], to_view[solvable, :3, 3:])[..., 0]
        away = eye - np.clip(eye, lowest, highest)
        distance = np.linalg.norm(np.einsum("kij,kj->ki", to_view[:, :3, :3], away), axis=1)
        sizes = focal * axes.max(axis=1) / np.maximum(distance, view.near_clip)
    largest, of_object = np.zeros(len(names)), {}
    np.fmax.at(largest, kinds, sizes)
    for name, size in zip(names, largest):
        of_object[name] = max(of_object.get(name, 0.0), size)
    return {name: float(2.0 ** np.ceil(np.log2(size))) if size > 0.0 else 0.0 for name, size in of_object.items()}
