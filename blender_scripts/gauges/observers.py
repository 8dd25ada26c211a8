# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulated participants: they see a relief of the surface, set gauges not quite exactly, and sometimes blindly."""

import numpy as np

from .formulas import STEEPEST


def anywhere(random, count):
    """(count, 3) of gauges set blindly: every direction towards the viewer is equally likely."""
    z, tilt = random.random(count), 2 * np.pi * random.random(count)
    across = np.sqrt(1 - z * z)
    return np.stack([across * np.cos(tilt), across * np.sin(tilt), z], axis=1)


def around(random, normals, kappa):
    """(n, 3) vectors about normals (n, 3), distributed as von Mises and Fisher: about 1 / sqrt(kappa) away."""
    along = 1 + np.log1p(random.random(len(normals)) * np.expm1(-2 * kappa)) / kappa
    turn = 2 * np.pi * random.random(len(normals))
    other = np.where(np.abs(normals[:, 2:]) < 0.9, [[0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]])
    first = np.cross(normals, other)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second = np.cross(normals, first)
    away = np.sqrt(1 - along**2)[:, None] * (np.cos(turn)[:, None] * first + np.sin(turn)[:, None] * second)
    return along[:, None] * normals + away


def settable(vectors):
    """(n, 3) the nearest that gauges can be set to: towards the viewer, and no steeper than STEEPEST."""
    across = vectors[:, :2] / np.maximum(np.linalg.norm(vectors[:, :2], axis=1, keepdims=True), 1e-12)
    z = np.maximum(vectors[:, 2], np.cos(np.radians(STEEPEST)))
    return np.concatenate([across * np.sqrt(1 - z**2)[:, None], z[:, None]], axis=1)


def settings(random, truth, relief, kappa=30.0, lapses=0.05):
    """(n, 3) of one who sees a relief (native BasRelief) of the truth (n, 3), and sets a share of gauges blindly."""
    seen = settable(around(random, relief.of_normals(truth), kappa))
    blind = random.random(len(truth)) < lapses
    return np.where(blind[:, None], anywhere(random, len(truth)), seen)
