# SPDX-License-Identifier: GPL-3.0-or-later
"""The lights of a scene: for shading, light contours and cast shadows."""

import math
from typing import NamedTuple

import numpy as np

# Blender's watts to intensity: point and spot lights radiate into 4 pi, area lights into a hemisphere (pi).
SPREAD = {"SUN": 1.0, "POINT": 4 * math.pi, "SPOT": 4 * math.pi, "AREA": math.pi}


class Lamp(NamedTuple):
    """Arguments of the native Light (native/fovea/scene/light.h), in world space."""

    kind: str
    position: np.ndarray
    direction: np.ndarray
    color: tuple
    cos_outer: float
    cos_inner: float
    half_x: np.ndarray
    half_y: np.ndarray
    casts: bool
    id: int
    radius: float


def lamp(data, matrix, persistent_id):
    """The Lamp of a light (bpy.types.Light) with its (4, 4) object-to-world matrix."""
    strength = data.energy * 2.0 ** getattr(data, "exposure", 0.0) / SPREAD[data.type]
    outer = inner = -1.0
    if data.type == "SPOT":
        outer = math.cos(data.spot_size / 2)
        inner = outer + (1 - outer) * data.spot_blend
    size = (0.0, 0.0)
    if data.type == "AREA":
        size = (data.size, data.size_y if data.shape in {"RECTANGLE", "ELLIPSE"} else data.size)
    return Lamp(
        kind=data.type.lower(),
        position=matrix[:3, 3],
        direction=-matrix[:3, 2],
        color=tuple(channel * strength for channel in data.color),
        cos_outer=outer,
        cos_inner=inner,
        half_x=matrix[:3, 0] * size[0] / 2,
        half_y=matrix[:3, 1] * size[1] / 2,
        casts=data.use_shadow,
        id=int(persistent_id),
        radius=math.tan(data.angle / 2) if data.type == "SUN" else getattr(data, "shadow_soft_size", 0.0),
    )
