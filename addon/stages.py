"""What passes between the stages: frozen records of plain arrays, the same for every backend.

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
class Paths:
    """Segments chained into paths, in object space; N points, P paths. Lines of the image are in view space."""

    offsets: np.ndarray  # (P + 1,) uint32
    points_obj: np.ndarray  # (N, 3) float32
    place: np.ndarray  # (N,) uint32, where the segment from this point lies: edge, or number of edges + triangle
    edge_t: np.ndarray  # (N,) float32, where on its edge the point is
    kinds: np.ndarray  # (N,) uint32, bits of the registry: what the segment from this point is
    strength: np.ndarray  # (N,) float32 in [0, 1]
    other_facet: np.ndarray  # (N,) uint32 of a line on two surfaces: the second's facet over the scene; else 0xffffffff
    closed: np.ndarray  # (P,) uint8; a closed path repeats its first point at the end
    ids: np.ndarray  # (P,) uint64, stable over frames for static lines
    placement: np.ndarray  # (P,) uint32, index into the scene's placements; 0xffffffff: found in the image
    line_set: np.ndarray  # (P,) uint8, index into the style's line sets


@dataclass(frozen=True)
class ClippedPaths:
    """Paths projected and clipped to the frame: Q pieces, M points; see native/project/clipped_paths.h."""

    offsets: np.ndarray  # (Q + 1,) uint32: points of piece q
    path: np.ndarray  # (Q,) uint32: path it comes from
    closed: np.ndarray  # (Q,) uint8
    path_length_px: np.ndarray  # (Q,) float64, of the whole path, whatever the frame cuts off
    px: np.ndarray  # (M, 2) float32
    depth: np.ndarray  # (M,) float32
    position_view: np.ndarray  # (M, 3) float32
    arc_px: np.ndarray  # (M,) float64, 0 at the middle of the whole path
    source: np.ndarray  # (M,) uint32 point of Paths
    source_t: np.ndarray  # (M,) float32 fraction towards the next point
    facet0: np.ndarray  # (M,) uint32, facets at the segment from this point; 0xffffffff: none
    facet1: np.ndarray  # (M,) uint32
    sample_start: np.ndarray  # (M,) uint32, first atlas sample of the segment from this point
    sample_count: np.ndarray  # (M,) uint32, 0 for the last point of a piece
    samples: int  # size of the atlas


@dataclass(frozen=True)
class Runs:
    """Parts of pieces, sorted by piece, then start; pixels of arc length."""

    piece: np.ndarray  # (R,) uint32
    start_px: np.ndarray  # (R,) float64
    end_px: np.ndarray  # (R,) float64
    invisibility: np.ndarray  # (R,) uint8, how many surfaces hide it; 0: visible


@dataclass(frozen=True)
class Strokes:
    """Runs shaped into triangle strips (V vertices, I / 3 triangles); every backend draws the same arrays.

    A fragment's coverage is analytic: side = half_width + .5 - |v|, and beyond the ends the distance to the cap."""

    px: np.ndarray  # (V, 2) float32, corner of the strip, half a pixel wider than the pen
    arc: np.ndarray  # (V, 4) float32: u along the path (0 at its middle), v across, u of the run's start, of its end
    half_width: np.ndarray  # (V,) float32 pixels at this place along the stroke
    opacity: np.ndarray  # (V,) float32, of strength, thinness and the pens
    mix: np.ndarray  # (V, 2) float32, how far colour and ink are those of the pen out of focus
    path_px: np.ndarray  # (V,) float32, length of the whole path, for textures anchored to it
    pen: np.ndarray  # (V,) uint32, index into the frame's pens
    triangles: np.ndarray  # (T, 3) uint32, in drawing order
    count: int = 0  # strokes


@dataclass(frozen=True)
class Pen:
    """How a stroke looks; lengths in reference pixels (image height / 1080), colour scene-linear."""

    color: tuple = (0.0, 0.0, 0.0)
    opacity: float = 1.0
    width: float = 2.0
    texture: str = "solid"  # a file of addon/textures, without .png
    length_scale: float = 1.0  # stretches the texture along the stroke
    cap: str = "round"  # round, butt
    taper: float = 0.0  # length of the thinning ends
    strength_width: float = 0.0  # how far weak lines are thin instead of pale
    wobble: float = 0.0  # how far the pen strays from its line
    wobble_length: float = 60.0  # in waves of this length
    seed: float = 0.0  # of that hand
    pressure: float = 0.0  # how much thinner strokes are at their ends than in the middle
    spacing: float = 6.0  # how near two lines that go alongside may be where elision thins them
    width_unit: str = "reference"  # or pixels of the image, or millimetres on the style's paper; of the width alone
    texture_anchor: str = "screen"  # or path: in zooms it keeps its places along the path; for grain


@dataclass(frozen=True)
class Emphasis:
    """What focus, distance and elision say of the samples along the lines; None: nothing."""

    focus: np.ndarray | None = None  # (samples,) float32 in [0, 1]; 0: in focus
    distance: np.ndarray | None = None  # (samples,) float32 in [0, 1]; 0: near
    shown: np.ndarray | None = None  # (samples,) float32 in [0, 1], what elision leaves


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
class Image:
    """Scene-linear, premultiplied RGBA passes, bottom row first, as Blender stores them."""

    combined: np.ndarray  # (H, W, 4) float32
    lines: np.ndarray | None = None  # (H, W, 4) float32, strokes alone
    depth: np.ndarray | None = None  # (H, W) float32, distance from the camera
    color: np.ndarray | None = None  # (H, W, 4) float32, the colour layer alone
    focus: np.ndarray | None = None  # (H, W) float32 in [0, 1], 0: in focus
    statistics: dict = field(default_factory=dict)
