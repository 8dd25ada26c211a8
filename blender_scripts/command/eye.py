# SPDX-License-Identifier: GPL-3.0-or-later
"""The camera of `fovea lines`, aimed at the center of a model's bounding box."""

import numpy as np


def view(positions, eye, ortho, size=(1024, 1024), fov=90.0):
    """Positional arguments of a native View, world_to_view first. `eye`: position or, for an orthographic view, the
    direction towards the viewer. `fov`: degrees over the frame's shorter side; None: fits all positions, as an
    orthographic frame always does."""
    finite = positions[np.isfinite(positions).all(axis=1)]
    low, high = (finite.min(axis=0), finite.max(axis=0)) if len(finite) else (np.zeros(3), np.ones(3))
    center, radius = (low + high) / 2, max(np.linalg.norm(high - low) / 2, 1e-30)
    towards = eye if ortho else eye - center
    if not towards.any():
        if ortho:
            raise ValueError("--eye 0,0,0 is no direction")
        towards = np.array([0.0, 0.0, 1.0])  # eye at the center: any direction, as paths are extracted whole
    distance = 2 * radius if ortho else np.linalg.norm(towards)
    backwards = towards / np.linalg.norm(towards)
    eye = center + distance * backwards if ortho else eye
    near, far = (0.5 * radius, 4 * radius) if ortho else (1e-3 * max(distance, radius), distance + 2 * radius)
    half = radius if ortho else _half_frame(radius, distance, fov)
    halves = half * np.array(size) / min(size)
    clip = _orthographic(halves, near, far) if ortho else _perspective(halves, near, far)
    return _looking(eye, backwards), clip, *size, ortho, near, far


def _half_frame(radius, distance, fov):
    """Half the frame's shorter side at distance 1; at most 1 (90 degrees) if fitted, as near a model no frame fits
    it."""
    if fov is not None:
        return np.tan(np.radians(fov / 2))
    return radius / np.sqrt(distance**2 - radius**2) if distance > np.sqrt(2) * radius else 1.0


def _looking(eye, backwards):
    """World-to-view matrix: the eye at the origin, looking along -z."""
    aside = np.eye(3)[np.abs(backwards).argmin()]
    right = np.cross(aside, backwards)
    right /= np.linalg.norm(right)
    matrix = np.eye(4)
    matrix[:3, :3] = right, np.cross(backwards, right), backwards
    matrix[:3, 3] = -matrix[:3, :3] @ eye
    return matrix


def _perspective(halves, near, far):
    (x, y), depth = 1 / halves, far - near
    return np.array([[x, 0, 0, 0], [0, y, 0, 0], [0, 0, -(far + near) / depth, -2 * far * near / depth], [0, 0, -1, 0]])


def _orthographic(halves, near, far):
    (x, y), depth = 1 / halves, far - near
    return np.array([[x, 0, 0, 0], [0, y, 0, 0], [0, 0, -2 / depth, -(far + near) / depth], [0, 0, 0, 1]])
