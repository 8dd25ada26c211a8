# SPDX-License-Identifier: GPL-3.0-or-later
"""What passes between Blender, the stages and the backends: frozen records of plain arrays.

Pixels have their origin at the lower left corner of the drawn region, y up, centres at .5. View space looks along -z.
Depth is reversed and screen-linear: near / distance for a perspective camera, 1 at the near and 0 at the far plane for
an orthographic one; larger is nearer. Matrices are (4, 4) float64 acting on columns, as Blender's.
"""

from dataclasses import dataclass, field

import numpy as np

REFERENCE_HEIGHT = 1080.0  # pixels: of an image so high, pixels are reference pixels


@dataclass(frozen=True)
class View:
    """A camera and the image it makes. The crop of a render border, lens shift and pixel aspect are in view_to_clip."""

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
class LineFilters:
    """Which lines n placements have. Materials are a pair: (n,) uint32 mask of each placement, and a list of masks,
    uint8 by the number of the material on its surface, 0: its faces have no lines; None: all have."""

    placements: tuple = ()  # per line set (n,) uint8 whether its lines are for it, or None for all; (): all, for all
    materials: tuple = ()  # per line set materials whose lines are for it; (): all, for all
    shown: np.ndarray | None = None  # (n,) uint32, bits of the registry: what each shows of any set; None: all
    parameters: dict = field(default_factory=dict)  # {definition: {parameter: (n,) float64, NaN: as the set says}}
    lined: tuple | None = None  # materials that have lines at all


@dataclass(frozen=True)
class Notes:
    """What an artist has said of a scene's n placements, beside what they look like."""

    importance: np.ndarray | None = None  # (n,) float32 in [0, 1]; None: all the same
    painted: dict = field(default_factory=dict)  # {attribute: n arrays (C,) float32 at the mesh's corners, or None}
    objects: tuple = ()  # n tuples of names: of the object, and of what made an instance of it
    density_map: object = None  # native ColorTexture over the camera's frame; None: there is none
    filters: LineFilters = LineFilters()


@dataclass(frozen=True)
class ColorSources:
    """Where the colors of a scene come from, in native handles."""

    surfaces: list  # a SurfaceColor or None per placement
    lights: list = field(default_factory=list)  # native Lights; none: one at the eye
    world: tuple = (0.0, 0.0, 0.0)  # radiance of the sky


@dataclass(frozen=True)
class Image:
    """Scene-linear, premultiplied RGBA passes, bottom row first, as Blender stores them."""

    combined: np.ndarray  # (H, W, 4) float32
    lines: np.ndarray | None = None  # (H, W, 4) float32, strokes alone
    depth: np.ndarray | None = None  # (H, W) float32, distance from the camera
    color: np.ndarray | None = None  # (H, W, 4) float32, the colour layer alone
    focus: np.ndarray | None = None  # (H, W) float32 in [0, 1], 0: in focus
    statistics: dict = field(default_factory=dict)
