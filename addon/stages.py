# SPDX-License-Identifier: GPL-3.0-or-later
"""Records of plain arrays exchanged between Blender, the stages and the backends.

Pixels have their origin at the lower left corner of the drawn region, y up, centers at .5. View space looks along -z.
Depth is reversed and screen-linear: near / distance for a perspective camera, 1 at the near and 0 at the far plane for
an orthographic one; larger is nearer. Matrices are (4, 4) float64 acting on columns, as Blender's.
"""

from dataclasses import dataclass, field

import numpy as np

REFERENCE_HEIGHT = 1080.0  # image height in pixels at which a pixel is one reference pixel


@dataclass(frozen=True)
class View:
    """A camera and its image. view_to_clip includes the crop to a render border, lens shift and pixel aspect."""

    world_to_view: np.ndarray  # (4, 4) float64
    view_to_clip: np.ndarray  # (4, 4) float64
    width: int  # of the drawn region
    height: int
    orthographic: bool
    near_clip: float
    far_clip: float
    reference_scale: float = 1.0  # image pixels per reference pixel: full frame height / 1080
    frame: tuple | None = None  # left, lower, width, height of the camera's full frame in pixels; None: the image


@dataclass(frozen=True)
class Image:
    """Scene-linear, premultiplied RGBA passes, bottom row first, as Blender stores them."""

    combined: np.ndarray  # (H, W, 4) float32
    lines: np.ndarray | None = None  # (H, W, 4) float32, strokes alone
    depth: np.ndarray | None = None  # (H, W) float32, distance along the view direction
    color: np.ndarray | None = None  # (H, W, 4) float32, the color layer alone
    focus: np.ndarray | None = None  # (H, W) float32 in [0, 1], 0: in focus
    # native/fovea/draw/line_passes.h:
    hidden_lines: np.ndarray | None = None  # (H, W, 4) float32
    line_sets: dict = field(default_factory=dict)  # {name: (H, W, 4) float32}
    line_depth: np.ndarray | None = None  # (H, W) float32, distance along the view direction
    line_vector: np.ndarray | None = None  # (H, W, 4) float32, pixels
    line_id: np.ndarray | None = None  # (H, W) float32
    mattes: list = field(default_factory=list)  # (H, W, 4) float32, two ranks each: id, coverage, id, coverage
    statistics: dict = field(default_factory=dict)
