# SPDX-License-Identifier: GPL-3.0-or-later
# Made by `fovea stub` of what the module says of itself; not to be edited.
"""Fovea's core: drawings of scenes, and what they are made of, as numpy arrays."""

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Annotated, ClassVar, overload

import numpy
from numpy.typing import ArrayLike, NDArray


class Cancel:
    """A flag that long calls poll; cancel() makes them raise Cancelled. As a context: calls in it, by the same thread,
    poll it."""
    def __init__(self) -> None: ...
    def cancel(self) -> None: ...
    @property
    def requested(self) -> bool: ...

class Cancelled(RuntimeError):
    ...

def limit_threads(most: int) -> None:
    """Most threads that work at once from now on; 0: as many as the machine has. Results never depend on it."""

def release_memory() -> None:
    """Returns memory that is kept for the arrays of the next pictures to the system, or to Blender's heap."""

def content_hash(array: numpy.ndarray) -> int:
    """64-bit hash of an array's bytes."""

class style:
    """What a style is made of. A class tells in `fields` what each of its members is and may be: dicts of name, key (in
    files; None: not there), label, description, type, group, default, min, max, soft_max, unit, names, most_letters and
    choices."""

    class Transfer:
        """Mix of an effect over focus, distance or the length of a stroke."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.Transfer:
            """The same with other values."""
        def __eq__(self, other: style.Transfer) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def start(self) -> float: ...
        @property
        def end(self) -> float: ...
        @property
        def strength(self) -> float: ...
        @property
        def curve(self) -> tuple[tuple[float, ...], ...]: ...
        fields: ClassVar[tuple]

    class Pen:
        """How strokes look."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.Pen:
            """The same with other values."""
        def __eq__(self, other: style.Pen) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def color(self) -> tuple[float, ...]: ...
        @property
        def opacity(self) -> float: ...
        @property
        def width(self) -> float: ...
        @property
        def texture(self) -> str: ...
        @property
        def length_scale(self) -> float: ...
        @property
        def cap(self) -> str: ...
        @property
        def taper(self) -> float: ...
        @property
        def written(self) -> float: ...
        @property
        def strength_width(self) -> float: ...
        @property
        def wobble(self) -> float: ...
        @property
        def wobble_length(self) -> float: ...
        @property
        def seed(self) -> float: ...
        @property
        def pressure(self) -> float: ...
        @property
        def spacing(self) -> float: ...
        @property
        def width_unit(self) -> str: ...
        @property
        def texture_anchor(self) -> str: ...
        @property
        def second_color(self) -> tuple[float, ...]: ...
        @property
        def along_width(self) -> style.Transfer: ...
        @property
        def along_opacity(self) -> style.Transfer: ...
        @property
        def along_color(self) -> style.Transfer: ...
        @property
        def nib_angle(self) -> float: ...
        @property
        def nib_width(self) -> float: ...
        @property
        def nib_opacity(self) -> float: ...
        @property
        def nib_color(self) -> float: ...
        @property
        def distance_near(self) -> float: ...
        @property
        def distance_far(self) -> float: ...
        @property
        def distance_width(self) -> float: ...
        @property
        def distance_opacity(self) -> float: ...
        @property
        def distance_color(self) -> float: ...
        @property
        def noise_length(self) -> float: ...
        @property
        def noise_width(self) -> float: ...
        @property
        def noise_opacity(self) -> float: ...
        @property
        def noise_color(self) -> float: ...
        @property
        def paint_width(self) -> str: ...
        @property
        def paint_width_name(self) -> str: ...
        @property
        def paint_opacity(self) -> str: ...
        @property
        def paint_opacity_name(self) -> str: ...
        @property
        def paint_color(self) -> str: ...
        @property
        def paint_color_name(self) -> str: ...
        fields: ClassVar[tuple]

    class Hidden:
        """How the parts of lines are drawn that a range of numbers of surfaces hides."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.Hidden:
            """The same with other values."""
        def __eq__(self, other: style.Hidden) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def first(self) -> int: ...
        @property
        def last(self) -> int | None: ...
        @property
        def pen(self) -> style.Pen: ...
        @property
        def pen_away(self) -> style.Pen | None: ...
        fields: ClassVar[tuple]

    class LineSet:
        """Lines drawn alike."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.LineSet:
            """The same with other values."""
        def __eq__(self, other: style.LineSet) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def name(self) -> str: ...
        @property
        def kinds(self) -> dict[str, dict[str, object]]: ...
        @property
        def collection(self) -> str: ...
        @property
        def outside(self) -> bool: ...
        @property
        def object(self) -> str: ...
        @property
        def other_objects(self) -> bool: ...
        @property
        def material(self) -> str: ...
        @property
        def other_materials(self) -> bool: ...
        @property
        def surfaces(self) -> str: ...
        @property
        def light(self) -> str: ...
        @property
        def corner_angle(self) -> float: ...
        @property
        def least_length(self) -> float: ...
        @property
        def overshoot(self) -> float: ...
        @property
        def halo(self) -> float: ...
        @property
        def overshoot_away(self) -> float | None: ...
        @property
        def pen(self) -> style.Pen: ...
        @property
        def pen_away(self) -> style.Pen | None: ...
        @property
        def hidden(self) -> tuple[style.Hidden, ...]: ...
        fields: ClassVar[tuple]

    class Paper:
        """The paper."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.Paper:
            """The same with other values."""
        def __eq__(self, other: style.Paper) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def color(self) -> tuple[float, ...]: ...
        @property
        def transparent(self) -> bool: ...
        @property
        def texture(self) -> str: ...
        @property
        def scale(self) -> float: ...
        @property
        def tooth(self) -> float: ...
        @property
        def granulation(self) -> float: ...
        @property
        def tint(self) -> float: ...
        @property
        def height_mm(self) -> float: ...
        fields: ClassVar[tuple]

    class Color:
        """The scene's surfaces in color, under the lines."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.Color:
            """The same with other values."""
        def __eq__(self, other: style.Color) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def shading(self) -> str: ...
        @property
        def bands(self) -> int: ...
        @property
        def opacity(self) -> float: ...
        @property
        def desaturation(self) -> float: ...
        @property
        def shadow(self) -> float: ...
        @property
        def blacks(self) -> float: ...
        @property
        def black_color(self) -> tuple[float, ...]: ...
        @property
        def edge_darkening(self) -> float: ...
        @property
        def backruns(self) -> float: ...
        @property
        def background(self) -> tuple[float, ...] | None: ...
        fields: ClassVar[tuple]

    class Section:
        """The inside of what the scene's section plane cuts."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.Section:
            """The same with other values."""
        def __eq__(self, other: style.Section) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def filled(self) -> bool: ...
        @property
        def color(self) -> tuple[float, ...]: ...
        fields: ClassVar[tuple]

    class Elision:
        """Which of the lines that crowd each other stay."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.Elision:
            """The same with other values."""
        def __eq__(self, other: style.Elision) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def enabled(self) -> bool: ...
        @property
        def fade_from(self) -> float: ...
        @property
        def cut(self) -> float: ...
        @property
        def frames(self) -> int: ...
        @property
        def length(self) -> float: ...
        @property
        def kind(self) -> float: ...
        @property
        def strength(self) -> float: ...
        @property
        def depth(self) -> float: ...
        @property
        def object(self) -> float: ...
        @property
        def painted(self) -> float: ...
        @property
        def priority_attribute(self) -> str: ...
        @property
        def density_attribute(self) -> str: ...
        fields: ClassVar[tuple]
        def ranks(self) -> bool:
            """Whether something counts for the priority of lines."""

    class Animation:
        """How drawings follow each other in an animation."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.Animation:
            """The same with other values."""
        def __eq__(self, other: style.Animation) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def hold(self) -> int: ...
        @property
        def boil(self) -> float: ...
        @property
        def boil_hold(self) -> int: ...
        @property
        def boil_cycle(self) -> int: ...
        @property
        def start_frame(self) -> int: ...
        @property
        def written(self) -> float: ...
        @property
        def visibility_frames(self) -> int: ...
        @property
        def vanish(self) -> str: ...
        @property
        def marks_frames(self) -> int: ...
        @property
        def marks_baked(self) -> bool: ...
        @property
        def motion_blur(self) -> bool: ...
        @property
        def motion_samples(self) -> int: ...
        fields: ClassVar[tuple]
        def held(self, frame: int) -> int:
            """The frame whose drawing stands at a frame."""
        def since_key(self, frame: int) -> int:
            """How many frames before this one the last key of marks is."""
        def boil_drawing(self, frame: int) -> int:
            """The number of the boil's drawing at a frame, in its cycle."""

    class Effects:
        """What answers to focus."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.Effects:
            """The same with other values."""
        def __eq__(self, other: style.Effects) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def color(self) -> style.Transfer: ...
        @property
        def texture(self) -> style.Transfer: ...
        @property
        def width(self) -> style.Transfer: ...
        @property
        def opacity(self) -> style.Transfer: ...
        @property
        def density(self) -> style.Transfer: ...
        @property
        def overshoot(self) -> style.Transfer: ...
        @property
        def desaturation(self) -> style.Transfer: ...
        @property
        def fade(self) -> style.Transfer: ...
        @property
        def blur(self) -> style.Transfer: ...
        @property
        def lines(self) -> str: ...
        @property
        def colors(self) -> str: ...
        @property
        def emphasis(self) -> float: ...
        @property
        def uniform(self) -> float: ...
        @property
        def blur_radius(self) -> float: ...
        fields: ClassVar[tuple]

    class Distance:
        """What answers to the distance from the camera."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.Distance:
            """The same with other values."""
        def __eq__(self, other: style.Distance) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def near(self) -> float: ...
        @property
        def far(self) -> float: ...
        @property
        def width(self) -> style.Transfer: ...
        @property
        def opacity(self) -> style.Transfer: ...
        @property
        def density(self) -> style.Transfer: ...
        fields: ClassVar[tuple]

    class FocusPlace:
        """A place to look at."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.FocusPlace:
            """The same with other values."""
        def __eq__(self, other: style.FocusPlace) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def at(self) -> tuple[float, ...]: ...
        @property
        def near(self) -> float: ...
        @property
        def far(self) -> float: ...
        @property
        def object(self) -> str: ...
        fields: ClassVar[tuple]

    class Focus:
        """Where the viewer shall look."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.Focus:
            """The same with other values."""
        def __eq__(self, other: style.Focus) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def model(self) -> str: ...
        @property
        def points(self) -> tuple[style.FocusPlace, ...]: ...
        @property
        def combine(self) -> str: ...
        @property
        def attribute(self) -> str: ...
        fields: ClassVar[tuple]
        def active(self) -> bool: ...

    class Style:
        """A style."""
        def __init__(self, **kwargs) -> None: ...
        def replace(self, **kwargs) -> style.Style:
            """The same with other values."""
        def __eq__(self, other: style.Style) -> bool: ...
        def __hash__(self) -> int: ...
        @property
        def paper(self) -> style.Paper: ...
        @property
        def line_sets(self) -> tuple[style.LineSet, ...]: ...
        @property
        def focus(self) -> style.Focus: ...
        @property
        def effects(self) -> style.Effects: ...
        @property
        def distance(self) -> style.Distance: ...
        @property
        def color(self) -> style.Color: ...
        @property
        def elision(self) -> style.Elision: ...
        @property
        def section(self) -> style.Section: ...
        @property
        def animation(self) -> style.Animation: ...
        @property
        def kept(self) -> tuple[tuple, ...]: ...
        fields: ClassVar[tuple]
        @staticmethod
        def read(json: str, textures: Sequence[str], papers: Sequence[str]) -> style.Style:
            """The style in a file's JSON (UTF-8), which names of textures and papers only these. ValueError says what is
            wrong."""
        def written(self) -> str:
            """The JSON of its file."""
        def mixed(self, other: style.Style, share: float) -> style.Style:
            """The style between it (0) and another (1)."""
        def has_color(self) -> bool:
            """Whether there is a color layer."""
        def fixes_marks(self) -> bool:
            """Whether a pen fixes its marks to paths."""
        def pens(self) -> list[style.Pen]:
            """Those in focus of visible parts by line set, of hidden parts, and all those out of focus."""
        def width_px(self, pen: style.Pen, reference_scale: float) -> float:
            """Width of a pen in pixels of an image, so many of which are a reference pixel."""

    def parameters(definition: str, values: dict, where: str) -> dict[str, object]:
        """{parameter: value} of a line definition, checked. ValueError says what is wrong with it."""

    def file_bytes(path: bytes) -> bytes:
        """The bytes of a style file; a byte order mark does not count. ValueError if it is none or too large."""

    SCHEMA: int

    LARGEST: int

    MOST_SURFACES: int

    MOST_PLACES: int

    MOST_CURVE_POINTS: int

class Mesh:
    """A mesh as Blender holds it; it keeps the arrays that it is made of."""
    def __init__(
        self,
        *,
        positions: Annotated[ArrayLike, numpy.float32],
        edge_verts: Annotated[ArrayLike, numpy.int32],
        corner_verts: Annotated[ArrayLike, numpy.int32],
        corner_edges: Annotated[ArrayLike, numpy.int32],
        polygon_offsets: Annotated[ArrayLike, numpy.int32],
        ngon_triangles: Annotated[ArrayLike, numpy.int32] | None=None,
        ngon_polygon: Annotated[ArrayLike, numpy.int32] | None=None,
        material: Annotated[ArrayLike, numpy.int32] | None=None,
        occluding: Annotated[ArrayLike, numpy.uint8] | None=None,
        sharp_edges: Annotated[ArrayLike, numpy.uint8] | None=None,
        seams: Annotated[ArrayLike, numpy.uint8] | None=None,
        edge_marks: Annotated[ArrayLike, numpy.uint8] | None=None,
        smooth_edges: Annotated[ArrayLike, numpy.uint8] | None=None,
        one_sided: Annotated[ArrayLike, numpy.uint8] | None=None,
    ) -> None:
        """positions (V, 3) float32 in object space; edge_verts (E, 2), corner_verts (C,), corner_edges (C,),
        polygon_offsets (F + 1,) int32 as Blender stores them; ngon_triangles (T, 3) vertices with ngon_polygon (T,)
        ascending: triangulation of polygons with more than four corners; material (F,) int32; occluding (F,),
        sharp_edges, seams, edge_marks, smooth_edges (across which shading is continuous) (E,) bool; one_sided (F,)
        bool: their backs are not seen."""

def all_polygons_have(
    corners: int,
    edge_verts: Annotated[ArrayLike, numpy.int32],
    corner_verts: Annotated[ArrayLike, numpy.int32],
    corner_edges: Annotated[ArrayLike, numpy.int32],
) -> bool:
    """Whether the polygons of a mesh all have 3, or all 4 corners, as their edges tell."""

class PolygonEdges:
    """The edges of polygons that come without any."""
    def __init__(
        self,
        polygon_offsets: Annotated[ArrayLike, numpy.int32],
        corner_verts: Annotated[ArrayLike, numpy.int32],
    ) -> None: ...
    @property
    def edge_verts(self) -> NDArray[numpy.int32]:
        """(E, 2) int32"""
    @property
    def corner_edges(self) -> NDArray[numpy.int32]:
        """(C,) int32: the edge from each corner to the next"""

class RepairReport:
    """How much a repair has done; counts of elements."""
    @property
    def turned_polygons(self) -> int: ...
    @property
    def refused_polygons(self) -> int: ...
    @property
    def too_many_triangles(self) -> int: ...

class RepairedMesh:
    """A mesh put in order; see native/fovea/repair/repair.h."""
    def __init__(
        self,
        name: str,
        mesh: Mesh,
        *,
        orient: bool=False,
        resample: int=0,
        edge_length: float=0.0,
        most_triangles: int | None=None,
    ) -> None:
        """Raises ValueError, naming the object, as Surface does."""
    @property
    def mesh(self) -> Mesh: ...
    @property
    def report(self) -> RepairReport: ...

class ShapeMesh:
    """The mesh of what has no faces in Blender."""
    @staticmethod
    def strands(
        name: str,
        points: Annotated[ArrayLike, numpy.float32],
        radii: Annotated[ArrayLike, numpy.float32],
        offsets: Annotated[ArrayLike, numpy.int32],
        *,
        steps: int=1,
        ribbons: bool=True,
        occludes: bool=True,
    ) -> ShapeMesh:
        """points (P, 3), radii (P,) float32, offsets (S + 1,) int32: strand s has the points offsets[s] to offsets[s +
        1], two or more. steps: segments on the Catmull-Rom curve for each one; ribbons: prisms as wide as the strands,
        else edges without faces; occludes: whether they hide what lies behind. Raises ValueError, naming the object."""
    @staticmethod
    def spheres(
        name: str,
        centers: Annotated[ArrayLike, numpy.float32],
        radii: Annotated[ArrayLike, numpy.float32],
        *,
        occludes: bool=True,
    ) -> ShapeMesh:
        """A sphere around each point; centers (P, 3), radii (P,) float32."""
    @property
    def mesh(self) -> Mesh: ...
    @property
    def positions(self) -> NDArray[numpy.float32]:
        """(V, 3) float32"""

class SurfaceReport:
    """What of a mesh was skipped or looked wrong; counts of elements."""
    @property
    def non_finite_vertices(self) -> int: ...
    @property
    def degenerate_polygons(self) -> int: ...
    @property
    def duplicate_polygons(self) -> int: ...
    @property
    def loose_edges(self) -> int: ...
    @property
    def non_manifold_edges(self) -> int: ...
    @property
    def inconsistent_edges(self) -> int: ...

class Surface:
    """A mesh with all that is derived from it; see native/fovea/mesh/surface.h."""
    def __init__(self, name: str, mesh: Mesh) -> None:
        """Raises ValueError, naming the object, where sizes or indices do not fit together."""
    def set_positions(self, positions: Annotated[ArrayLike, numpy.float32], *, refit: bool=False) -> None:
        """Moves the vertices, (V, 3) float32; the topology stays. refit: rays follow by a refitted BVH instead of a new
        one, which is faster; which triangle a ray through the side of two hits then depends on earlier positions."""
    def set_rest(self, positions: Annotated[ArrayLike, numpy.float32] | None) -> None:
        """Sets where the vertices, (V, 3) float32, are before what deforms the surface; None: where they are."""
    def set_field_options(self, estimator: str='automatic', degree: int=0, rings: int=0, smoothing: float=0.0) -> None:
        """How curvature is estimated from now on. estimator: automatic, jets or one_ring; degree (2 to 4) and rings (1
        to 32) of jets, 0: automatic; smoothing: deviation, in edge lengths, of the Gaussian it is averaged with."""
    @property
    def fields_reason(self) -> str:
        """How curvature was estimated, and why, in one sentence; empty while no line has asked for it."""
    def set_shape(self, shape: str) -> None:
        """What its polygons stand for from now on: hard, rounded, smooth, or automatic; see
        native/fovea/mesh/shape.h."""
    @property
    def shape(self) -> str:
        """hard, rounded or smooth, as set or decided; see native/fovea/field/shape.h."""
    @property
    def known_shape(self) -> tuple[str, str] | None:
        """(shape, reason in one sentence), or None while no line has asked for it."""
    @property
    def name(self) -> str: ...
    @property
    def version(self) -> int:
        """Changes whenever the positions do."""
    @property
    def report(self) -> SurfaceReport: ...
    @property
    def positions(self) -> NDArray[numpy.float32]: ...
    @property
    def triangles(self) -> NDArray[numpy.uint32]:
        """(T, 3) uint32 vertices; occluding ones first"""
    @property
    def triangle_facet(self) -> NDArray[numpy.uint32]:
        """(T,) uint32"""
    @property
    def edges(self) -> NDArray[numpy.uint32]:
        """(E, 2) uint32 vertices; those of the mesh first"""
    @property
    def mesh_edges(self) -> int: ...
    @property
    def facet_count(self) -> int: ...
    @property
    def polygon_count(self) -> int: ...
    def fields(self, estimator: str='automatic', degree: int=0, rings: int=0) -> Fields:
        """Fields by an estimator: automatic, jets, one_ring; degree and rings of jets, 0: automatic. Kept with the
        surface."""
    def find_curves(
        self,
        definition: str,
        parameters: Mapping[str, float]={},
        eye: Annotated[Sequence[float], 'FixedSize(3)']=(0.0, 0.0, 1.0),
        orthographic: bool=True,
    ) -> Curves:
        """Curves that a definition finds across the triangles of this surface alone. eye: in object space; for an
        orthographic view the direction towards the viewer."""

class Fields:
    """Curvature at the V vertices of a surface."""
    @property
    def normal(self) -> NDArray[numpy.float32]:
        """(V, 3) float32"""
    @property
    def k1(self) -> NDArray[numpy.float32]:
        """(V,) float32 per object unit, |k1| >= |k2|"""
    @property
    def k2(self) -> NDArray[numpy.float32]:
        """(V,) float32"""
    @property
    def feature_size(self) -> float:
        """the length that thresholds are relative to"""
    @property
    def reason(self) -> str:
        """which estimator was taken, and why"""

class Curves:
    """P pieces of curves in triangles, before they are chained."""
    def __len__(self) -> int: ...
    @property
    def triangle(self) -> NDArray[numpy.uint32]:
        """(P,) uint32"""
    @property
    def start(self) -> NDArray[numpy.float32]:
        """(P, 3) float32, object space"""
    @property
    def end(self) -> NDArray[numpy.float32]:
        """(P, 3) float32, object space"""

class RefinedSurface(Surface):
    """The refined mesh of a cage, on the limit of its subdivision; see native/fovea/mesh/refine.h."""
    def __init__(
        self,
        name: str,
        cage: Mesh,
        level: int,
        round_corners: bool=True,
        edge_creases: Annotated[ArrayLike, numpy.float32] | None=None,
        vertex_creases: Annotated[ArrayLike, numpy.float32] | None=None,
    ) -> None:
        """level 1 to 7; round_corners: also at corners of one polygon on a border; edge_creases (E,) and vertex_creases
        (V,) float32, weights from 0 to 1. Raises ValueError, naming the object, for a cage without a limit surface."""
    def set_positions(self, positions: Annotated[ArrayLike, numpy.float32], *, refit: bool=False) -> None:
        """Moves the cage's vertices, (V, 3) float32; the topology stays. refit: as Surface has it."""
    def set_rest(self, positions: Annotated[ArrayLike, numpy.float32] | None) -> None:
        """As Surface has it, of the cage's vertices."""
    def mix_corners(
        self,
        values: Annotated[ArrayLike, numpy.float32],
        polygon_offsets: Annotated[ArrayLike, numpy.int32],
    ) -> NDArray[numpy.float32]:
        """(C, k) float32 at the corners of the cage, mixed to those of the refined mesh."""

class Opacity:
    """Opacity of a material over its texture coordinates."""
    def __init__(
        self,
        texels: Annotated[ArrayLike, numpy.float32],
        threshold: float=0.5,
        extension: str='repeat',
        closest: bool=False,
    ) -> None:
        """(height, width) float32, bottom row first; opaque above the threshold; extension: repeat, extend, clip or
        mirror; closest: texels are squares, else opacity is interpolated between their centers."""

class Cut:
    """Opacity over a mesh."""
    def __init__(self, uvs: Annotated[ArrayLike, numpy.float32], opacity: Opacity) -> None:
        """uvs (C, 2) float32 per corner, in the image's texture space."""

class CutSurface(Surface):
    """A mesh without what is transparent; see native/fovea/cutout/cutout.h."""
    def __init__(
        self,
        name: str,
        mesh: Mesh,
        cuts: Sequence[Cut],
        cut_of_polygon: Annotated[ArrayLike, numpy.int32],
        *,
        px_per_unit: float=0.0,
    ) -> None:
        """cut_of_polygon (F,) int32: an index into the cuts, -1: opaque. px_per_unit: pixels of the drawing per unit of
        object space; images are halved to about a texel per pixel; 0: as they are. Raises ValueError, naming the
        object, as Surface does."""
    def set_positions(self, positions: Annotated[ArrayLike, numpy.float32], *, refit: bool=False) -> None:
        """Moves the vertices of the mesh that was cut, (V, 3) float32. refit: as Surface has it."""
    def mix_corners(self, values: Annotated[ArrayLike, numpy.float32]) -> NDArray[numpy.float32]:
        """(C, k) float32 at the corners of the mesh that was cut, to those of the surface."""

def line_definitions() -> list[dict[str, object]]:
    """The registry: one dict per definition, in the order of its bits, with its parameters."""

class FileContent:
    """What a file says that a line definition is given."""

class Paths:
    """Segments chained into paths, in object space; N points, P paths."""
    def __len__(self) -> int: ...
    @property
    def offsets(self) -> NDArray[numpy.uint32]:
        """(P + 1,) uint32: points of path p are offsets[p] .. offsets[p + 1]"""
    @property
    def closed(self) -> NDArray[numpy.uint8]:
        """(P,) uint8; a closed path repeats its first point at the end"""
    @property
    def ids(self) -> NDArray[numpy.uint64]:
        """(P,) uint64, from the object's persistent id and the lowest edge: stable over frames for static lines"""
    @property
    def placement(self) -> NDArray[numpy.uint32]:
        """(P,) uint32; 0xffffffff: found in the image, in view space"""
    @property
    def line_set(self) -> NDArray[numpy.uint8]:
        """(P,) uint8, the first line set that wants the path"""
    @property
    def free_ends(self) -> NDArray[numpy.uint8]:
        """(P,) uint8: 1 where the start touches no other line, 2 where the end does not"""
    @property
    def of_view(self) -> NDArray[numpy.uint8]:
        """(P,) uint8: nonzero if the path depends on the view; 2: a contour whose ends are cusps; 3: one of many that
        make a tone, which do not fold, and at which others do not go on"""
    @property
    def points_obj(self) -> NDArray[numpy.float32]:
        """(N, 3) float32"""
    @property
    def arc_obj(self) -> NDArray[numpy.float64]:
        """(N,) float64 arc length from the path's start, object units; in the surface's rest shape, if it has one"""
    @property
    def place(self) -> NDArray[numpy.uint32]:
        """(N,) uint32 where the segment from this point lies: an edge, or the number of edges + a triangle; the last:
        as before"""
    @property
    def edge_t(self) -> NDArray[numpy.float32]:
        """(N,) float32, where on that edge the point is: 0 at its first vertex, 1 at its second; else 0"""
    @property
    def kinds(self) -> NDArray[numpy.uint32]:
        """(N,) uint32, registry bits of the segment from this point"""
    @property
    def strength(self) -> NDArray[numpy.float32]:
        """(N,) float32 in [0, 1]"""
    @property
    def other_facet(self) -> NDArray[numpy.uint32]:
        """(N,) uint32 of a line on two surfaces: the second's facet over the scene; else 0xffffffff. May be empty: no
        line lies on two"""

class ClippedPaths:
    """Paths projected and clipped: Q pieces, M points; see native/fovea/project/clipped_paths.h."""
    def __len__(self) -> int: ...
    @property
    def offsets(self) -> NDArray[numpy.uint32]:
        """(Q + 1,) uint32: points of piece q"""
    @property
    def samples(self) -> int:
        """size of the atlas"""
    @property
    def path(self) -> NDArray[numpy.uint32]:
        """(Q,) uint32 path it comes from"""
    @property
    def closed(self) -> NDArray[numpy.uint8]:
        """(Q,) uint8: 1 where a whole closed path lies inside the frame (first and last point coincide)"""
    @property
    def free_ends(self) -> NDArray[numpy.uint8]:
        """(Q,) uint8: 1 where it starts, 2 where it ends with an end of the path that touches no other line: there pens
        taper"""
    @property
    def path_length_px(self) -> NDArray[numpy.float64]:
        """(Q,) float64 pixels of its whole path, whatever of it is outside of the frame or hidden; what lies behind the
        near plane, or a million frames away, has no pixels and does not count"""
    @property
    def ends(self) -> NDArray[numpy.uint8]:
        """(Q,) uint8: 1 starts, 2 ends with its path's end; 4 starts, 8 ends at a closed path's seam; else the frame
        cuts it"""
    @property
    def px(self) -> NDArray[numpy.float32]:
        """(M, 2) float32 pixels"""
    @property
    def depth(self) -> NDArray[numpy.float32]:
        """(M,) float32, reversed and screen-linear (base/view.h); before_all where nothing hides the path"""
    @property
    def position_view(self) -> NDArray[numpy.float32]:
        """(M, 3) float32 view space"""
    @property
    def arc_px(self) -> NDArray[numpy.float64]:
        """(M,) float64 arc length in pixels along the whole path, 0 at its middle, independent of clipping"""
    @property
    def source(self) -> NDArray[numpy.uint32]:
        """(M,) uint32 point of Paths"""
    @property
    def source_t(self) -> NDArray[numpy.float32]:
        """(M,) float32 fraction towards the next point"""
    @property
    def facet0(self) -> NDArray[numpy.uint32]:
        """(M,) uint32: with facet1 the facets at the mesh edge of the segment from this point, numbered over the whole
        scene, which visibility ignores; 0xffffffff: none"""
    @property
    def facet1(self) -> NDArray[numpy.uint32]:
        """(M,) uint32: see facet0"""
    @property
    def sample_start(self) -> NDArray[numpy.uint32]:
        """(M,) uint32: the segment from this point has the samples sample_start .. sample_start + sample_count of the
        atlas; sample j lies at its screen fraction (j + 0.5) / sample_count"""
    @property
    def sample_count(self) -> NDArray[numpy.uint32]:
        """(M,) uint32, 0 at the end of a piece"""

class Runs:
    """Parts of pieces, sorted by piece, then by start; see native/fovea/visibility/runs.h."""
    def __len__(self) -> int: ...
    def samples(self, clipped: ClippedPaths) -> NDArray[numpy.float32]:
        """(samples,) float32 share of each atlas sample that visible runs cover."""
    @property
    def piece(self) -> NDArray[numpy.uint32]:
        """(R,) uint32"""
    @property
    def start_px(self) -> NDArray[numpy.float64]:
        """(R,) float64"""
    @property
    def end_px(self) -> NDArray[numpy.float64]:
        """(R,) float64"""
    @property
    def invisibility(self) -> NDArray[numpy.uint8]:
        """(R,) uint8, how many surfaces hide it (quantitative invisibility, Appel 1967), as far as they were counted;
        0: visible"""

class Polylines:
    """A frame's lines: R runs as polylines of M points in all, in path order."""
    def __len__(self) -> int: ...
    @property
    def offsets(self) -> NDArray[numpy.uint32]:
        """(R + 1,) uint32: points of run r are offsets[r] .. offsets[r + 1]"""
    @property
    def path_id(self) -> NDArray[numpy.uint64]:
        """(R,) uint64 persistent id of the path"""
    @property
    def path(self) -> NDArray[numpy.uint32]:
        """(R,) uint32 path of Paths"""
    @property
    def piece(self) -> NDArray[numpy.uint32]:
        """(R,) uint32 piece of ClippedPaths"""
    @property
    def start_px(self) -> NDArray[numpy.float64]:
        """(R,) float64 arc length in pixels, 0 at the path's middle"""
    @property
    def end_px(self) -> NDArray[numpy.float64]:
        """(R,) float64"""
    @property
    def invisibility(self) -> NDArray[numpy.uint8]:
        """(R,) uint8 surfaces that hide it; 0: visible"""
    @property
    def line_set(self) -> NDArray[numpy.uint8]:
        """(R,) uint8"""
    @property
    def closed(self) -> NDArray[numpy.uint8]:
        """(R,) uint8, 1: all of a closed piece; the last point is the first again"""
    @property
    def pen(self) -> NDArray[numpy.uint32]:
        """(R,) uint32 of the style's pens, as Pens numbers them; 0xffffffff: none"""
    @property
    def shown(self) -> NDArray[numpy.float32]:
        """(R,) float32 in [0, 1] that elision leaves"""
    @property
    def px(self) -> NDArray[numpy.float32]:
        """(M, 2) float32 pixels, from the lower left corner, y up"""
    @property
    def position_view(self) -> NDArray[numpy.float32]:
        """(M, 3) float32 view space: the eye at 0, looking along -z"""
    @property
    def arc_px(self) -> NDArray[numpy.float64]:
        """(M,) float64 arc length in pixels"""
    @property
    def strength(self) -> NDArray[numpy.float32]:
        """(M,) float32 in [0, 1]"""
    @property
    def kinds(self) -> NDArray[numpy.uint32]:
        """(M,) uint32 bits of what the segment from the point is, of the last point what that before it is; see
        line_definitions()"""

class View:
    """A camera and its image; see addon/stages.py."""
    def __init__(
        self,
        world_to_view: Annotated[ArrayLike, numpy.float64],
        view_to_clip: Annotated[ArrayLike, numpy.float64],
        width: int,
        height: int,
        orthographic: bool,
        near_clip: float,
        far_clip: float,
        reference_scale: float=1.0,
        frame: Annotated[Sequence[float], 'FixedSize(4)'] | None=None,
    ) -> None:
        """frame: left, lower, width and height of the camera's full frame in pixels; None: the image."""
    @property
    def world_to_view(self) -> numpy.ndarray:
        """(4, 4) float64"""
    @property
    def frame(self) -> Annotated[list[float], 'FixedSize(4)']:
        """left, lower, width and height of the camera's full frame in pixels"""
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def orthographic(self) -> bool: ...
    @property
    def near_clip(self) -> float: ...
    @property
    def far_clip(self) -> float: ...
    @property
    def reference_scale(self) -> float: ...
    def smaller(self, scale: float) -> View:
        """The same in fewer pixels, as many as make a whole picture."""

class Usage:
    """Bits: what a placement does in the drawing."""
    def __init__(self, value: int) -> None: ...
    @property
    def name(self) -> str: ...
    def __hash__(self, /) -> int: ...
    @property
    def value(self) -> int: ...
    @overload
    def __eq__(self, other: Usage, /) -> bool: ...
    @overload
    def __eq__(self, other: int, /) -> bool: ...
    @overload
    def __eq__(self, other: object, /) -> bool: ...
    @overload
    def __and__(self, other: Usage, /) -> int: ...
    @overload
    def __and__(self, other: int, /) -> int: ...
    @overload
    def __or__(self, other: Usage, /) -> int: ...
    @overload
    def __or__(self, other: int, /) -> int: ...
    def __int__(self, /) -> int: ...
    DRAW: ClassVar[Usage]
    OCCLUDE: ClassVar[Usage]
    HOLDOUT: ClassVar[Usage]

class Light:
    """A light; see native/fovea/scene/light.h."""
    def __init__(
        self,
        kind: str,
        position: Annotated[Sequence[float], 'FixedSize(3)'],
        direction: Annotated[Sequence[float], 'FixedSize(3)'],
        color: Annotated[Sequence[float], 'FixedSize(3)'],
        cos_outer: float=-1.0,
        cos_inner: float=-1.0,
        half_x: Annotated[Sequence[float], 'FixedSize(3)']=(0.0, 0.0, 0.0),
        half_y: Annotated[Sequence[float], 'FixedSize(3)']=(0.0, 0.0, 0.0),
        casts: bool=True,
        id: int=0,
        radius: float=0.0,
    ) -> None: ...

class Scene:
    """Placements of surfaces: what one frame sees."""
    def __init__(
        self,
        surfaces: Sequence[Surface],
        surface_of_placement: Annotated[ArrayLike, numpy.int32],
        object_to_world: Annotated[ArrayLike, numpy.float64],
        ids: Annotated[ArrayLike, numpy.uint64],
        usage: Annotated[ArrayLike, numpy.uint8],
        groups: Annotated[ArrayLike, numpy.uint64] | None=None,
        section: Annotated[Sequence[float], 'FixedSize(4)'] | None=None,
        lights: Sequence[Light]=[],
    ) -> None:
        """surface_of_placement (n,) int32 into surfaces; object_to_world (n, 4, 4) float64; ids (n,) uint64 persistent
        ids; usage (n,) uint8, bits of Usage; groups (n,) uint64: placements of the same one have one outline together,
        0: of none. section: a plane (x, y, z, w) in the world; where x, y and z times a point, plus w, is positive, all
        is cut away. lights: by which light contours and cast shadows are found."""
    def __len__(self) -> int: ...
    def surface(self, placement: int) -> Surface: ...

class Pose:
    """Where the surfaces of a scene are, as its view sees them; a copy, which outlives both."""
    def __init__(self, scene: Scene, view: View) -> None: ...

class Tracer:
    """Rays through a scene as a view sees it (Embree)."""
    def __init__(self, scene: Scene, view: View) -> None: ...
    def extract_paths(self, kinds: Mapping[str, Mapping[str, float]], corner_angle: float=60.0) -> Paths:
        """Paths of what definitions find, {definition: {parameter: value}}; they end at corners sharper than so many
        degrees."""

class Transfer:
    """From focus in [0, 1] to how strong an effect is; see native/fovea/focus/transfer.h."""
    def __init__(
        self,
        start: float=0.0,
        end: float=1.0,
        strength: float=1.0,
        curve: Sequence[Annotated[Sequence[float], 'FixedSize(2)']]=[],
    ) -> None:
        """curve: points (x, y) of the response, ascending in x; none: straight."""
    def __call__(self, values: Annotated[ArrayLike, numpy.float32]) -> NDArray[numpy.float32]:
        """(n,) float32 mixes in [0, 1] of (n,) values."""

def monotone_cubic(
    points: Annotated[ArrayLike, numpy.float32],
    x: Annotated[ArrayLike, numpy.float32],
) -> NDArray[numpy.float32]:
    """(n,) float32 of (n,) x: the response curve through (k, 2) points, ascending in x, that a Transfer follows."""

class Focus:
    """Where the viewer shall look; see native/fovea/focus/focus.h."""
    def of_pixels(self, view: View, distance: Annotated[ArrayLike, numpy.float32]) -> NDArray[numpy.float32]:
        """(H, W) float32 in [0, 1]; 0: in focus. distance (H, W): along the view, of what each pixel shows; inf:
        nothing."""

class DepthDraw:
    """What hides lines, as the depth pass draws it."""
    @property
    def placement(self) -> int: ...
    @property
    def surface_version(self) -> int:
        """Surface.version"""
    @property
    def object_to_depth_clip(self) -> NDArray[numpy.float32]:
        """(16,) float32, column by column"""
    @property
    def facet_base(self) -> int:
        """number of its first facet"""
    @property
    def culled(self) -> str:
        """side that is not drawn: NONE, FRONT or BACK"""
    @property
    def cut(self) -> Annotated[list[float], 'FixedSize(4)']:
        """plane in object space: what is before it is cut away"""
    @property
    def first(self) -> int:
        """the first of the corners to draw"""
    @property
    def count(self) -> int:
        """and their number"""

class DepthCorners:
    """Corners of T occluding triangles, one after the other."""
    def __init__(self, surface: Surface) -> None: ...
    @property
    def positions(self) -> NDArray[numpy.float32]:
        """(3 T, 3) float32"""
    @property
    def facets(self) -> NDArray[numpy.uint32]:
        """(3 T,) uint32"""

class DepthLayout:
    """Size of a view's depth buffer; see native/fovea/visibility/depth.h."""
    def __init__(self, view: View, scale: int=2) -> None:
        """scale: texels per pixel, along each axis."""
    def texels(self, scene: Scene, view: View) -> numpy.ndarray:
        """(height, width) records depth, ddx, ddy, facet, edges (x, y) of the nearest surface; bottom row first."""
    def draws(self, scene: Scene, view: View) -> list[DepthDraw]:
        """All that hides lines, in drawing order."""
    @property
    def scale(self) -> int: ...
    @property
    def border_x(self) -> int:
        """pixels"""
    @property
    def border_y(self) -> int:
        """pixels"""
    @property
    def width(self) -> int:
        """texels"""
    @property
    def height(self) -> int:
        """texels"""
    @property
    def core(self) -> Annotated[list[float], 'FixedSize(4)']:
        """left, lower, right and upper edge of what it decides, in pixels"""

def has_section(scene: Scene) -> bool:
    """Whether a section plane cuts the scene open."""

def depth_reach(scene: Scene, view: View) -> float:
    """How far away along the view anything that hides lines reaches."""

class SampledOptions:
    """How the segment atlas looks; see native/fovea/visibility/sampled.h."""
    def __init__(self) -> None: ...
    @property
    def bias(self) -> float: ...
    @property
    def slack_px(self) -> float: ...

class ItemOptions:
    """How lines are drawn by number; see native/fovea/visibility/item_buffer.h."""
    def __init__(self) -> None: ...
    @property
    def slope_factor(self) -> float: ...
    @property
    def bias(self) -> float: ...

class OwnSides:
    """What the facets at each line's own edge tell; see native/fovea/visibility/own_sides.h."""
    def __init__(self, clipped: ClippedPaths, scene: Scene, view: View) -> None: ...
    def spine_table(self, clipped: ClippedPaths) -> NDArray[numpy.float32]:
        """(3 M, 4) float32; see native/fovea/visibility/spine.h."""

class AtlasTables:
    """N segments; see native/fovea/visibility/layout.h."""
    @property
    def segments(self) -> NDArray[numpy.float32]:
        """(3 N, 4) float32"""
    @property
    def owners(self) -> NDArray[numpy.float32]:
        """(B,) float32"""

class AtlasBatch:
    """Whole pieces whose samples share a texture."""
    ROW_WIDTH: ClassVar[int]
    OWNER_STRIDE: ClassVar[int]
    @staticmethod
    def of(clipped: ClippedPaths, limit: int=4194304) -> list[AtlasBatch]:
        """Of at most so many samples, or one piece."""
    def tables(self, clipped: ClippedPaths, sides: OwnSides) -> AtlasTables: ...
    @property
    def sample_begin(self) -> int: ...
    @property
    def sample_end(self) -> int: ...

class Elision:
    """Bands of runs, of V corners, and the D atlas samples that runs cover; see native/fovea/elision/elide.h."""
    @property
    def reach_px(self) -> float:
        """pixels from its end over which a band hands over to a line that goes on"""
    @property
    def figure_of_rank(self) -> NDArray[numpy.float32]:
        """(R,) float32, per rank: number of the figure of its run; -1: none"""
    @property
    def triangles(self) -> NDArray[numpy.uint32]:
        """(T, 3) uint32, the highest rank first"""
    @property
    def sample(self) -> NDArray[numpy.uint32]:
        """(D,) uint32 number of the sample in the atlas"""
    @property
    def place(self) -> NDArray[numpy.float32]:
        """(D, 4) float32: pixel position, direction (unit length)"""
    @property
    def band(self) -> NDArray[numpy.float32]:
        """(D, 4) float32: half the band's width [px], at least half a pixel, so that no line slips between pixels; rank
        of the run; pixels back to its start, and ahead to its end"""
    @property
    def ends(self) -> NDArray[numpy.float32]:
        """(D, 4) float32: where the run starts, and where it ends [px]"""
    @property
    def figure(self) -> NDArray[numpy.float32]:
        """(D, 3) float32: number of the run's figure (elision/figures.h), -1: none; weight in [0, 1] with which it is
        thinned as a whole; pixels of the run, or, with that weight, of the figure"""
    @property
    def px(self) -> NDArray[numpy.float32]:
        """(V, 2) float32 pixels"""
    @property
    def across(self) -> NDArray[numpy.float32]:
        """(V, 3) float32: v: pixels across, positive to the left of the way, h: half the band's width, e: how near the
        run's end is, from 0 at OwnBands::reach_px, or half way along the run, to 1 there; negative towards the start"""
    @property
    def owner(self) -> NDArray[numpy.float32]:
        """(V, 3) float32: unit vector to the left of the way, and rank; the same for the corners of a triangle"""
    WINDOW_COLUMNS: ClassVar[int]
    WINDOW_LENGTH_PX: ClassVar[float]
    MOST_WINDOW_ROWS: ClassVar[int]
    END_REACH: ClassVar[float]

class ShownLines:
    """What elision leaves of the lines of a frame that no view makes."""
    def smoothed(
        self,
        shown: Annotated[ArrayLike, numpy.float32],
        near: Mapping[int, ShownLines],
        frames: int,
    ) -> NDArray[numpy.float32]:
        """(samples,) float32: the mean of what is shown of this frame over so many frames to each side, see
        native/fovea/elision/in_time.h. shown: (samples,) float32; near: {how many frames later another is: its
        ShownLines}."""

class Pen:
    """A style's pen as one picture has it."""

class PenTexture:
    """Ink of a pen, repeated along the stroke."""

class PenTable:
    """N pens and their ink as the gpu's stroke pass reads them; see native/fovea/stroke/ink.h."""
    def __init__(self, pens: Sequence[Pen], textures: Sequence[PenTexture]) -> None: ...
    @property
    def pens(self) -> NDArray[numpy.float32]:
        """(3 N, 4) float32"""
    @property
    def ink(self) -> NDArray[numpy.float32]:
        """(I,) float32"""

class Strokes:
    """Visible runs shaped into V vertices and T triangles; see native/fovea/stroke/strokes.h."""
    def __len__(self) -> int: ...
    @property
    def triangles(self) -> NDArray[numpy.uint32]:
        """(T, 3) uint32, in drawing order"""
    @property
    def count(self) -> int:
        """strokes"""
    def raster(
        self,
        pens: Sequence[Pen],
        textures: Sequence[PenTexture],
        width: int,
        height: int,
    ) -> NDArray[numpy.float32]:
        """(height, width, 4) float32: the reference picture, premultiplied, bottom row first."""
    @property
    def px(self) -> NDArray[numpy.float32]:
        """(V, 2) float32 corner of the strip, pixels"""
    @property
    def arc(self) -> NDArray[numpy.float32]:
        """(V, 4) float32: u [px of arc along the whole path, 0 at its middle], v [px across, positive to the left of
        the way], u of the run's start and of its end (-+1e9 where a closed stroke has no ends)"""
    @property
    def half_width(self) -> NDArray[numpy.float32]:
        """(V,) float32 half the drawn width [px], at least .5: thinner pens are drawn a pixel wide and fainter"""
    @property
    def opacity(self) -> NDArray[numpy.float32]:
        """(V,) float32 of strength, thinness and the pens"""
    @property
    def mix(self) -> NDArray[numpy.float32]:
        """(V, 4) float32: how far color and ink are those of the pen out of focus, and how far the color is the pen's
        second one, each in [0, 1]; and up to how much ink of its texture nothing is left, 0: all is"""
    @property
    def anchor(self) -> NDArray[numpy.float32]:
        """(V, 2) float32, for marks fixed to the path: place on the whole path, from -.5 to .5, and the pixels of a
        path that is as large all along as it is here; 0 where no marks are fixed to it"""
    @property
    def pen(self) -> NDArray[numpy.uint32]:
        """(V,) uint32 index of the pen in focus, the same all over a stroke"""
    @property
    def piece(self) -> NDArray[numpy.uint32]:
        """(V,) uint32 piece of ClippedPaths that it belongs to; only the spine test asks, and it may be empty
        otherwise"""
    @property
    def color(self) -> NDArray[numpy.float32]:
        """(V, 3) float32 scene-linear color before the second one, where a pen takes it from surfaces; else it is
        empty, and colors are those of the pens"""

class ColorTexture:
    """An image of base colors."""
    def __init__(self, pixels: Annotated[ArrayLike, numpy.float32], encoded: bool) -> None:
        """(height, width, 1 to 4 channels) float32, bottom row first; encoded: as sRGB, else scene-linear."""

class ColorSlot:
    """What a material says about color."""
    def __init__(
        self,
        color: Annotated[Sequence[float], 'FixedSize(3)'],
        texture: ColorTexture | None=None,
        uv: int | None=None,
        attribute: int | None=None,
        unlit: bool=False,
        opacity: float=0.0,
    ) -> None: ...

class SurfaceColor:
    """Colors of a surface; see native/fovea/color/source.h."""
    def __init__(
        self,
        slots: Sequence[ColorSlot],
        normals: Annotated[ArrayLike, numpy.float32] | None=None,
        uvs: Sequence[Annotated[ArrayLike, numpy.float32]]=[],
        attributes: Sequence[Annotated[ArrayLike, numpy.float32]]=[],
    ) -> None:
        """normals (C, 3), each of uvs (C, 2), each of attributes (C, 3): float32 per corner of the mesh."""

class StoredPng:
    """The pixels of a PNG file as it stores them."""
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def channels(self) -> int:
        """of a palette: 1, its entry"""
    @property
    def bits(self) -> int:
        """of a value: 1, 2, 4, 8 or 16"""
    @property
    def values(self) -> bytes:
        """Rows from the top, each begins with a byte; of 16 bits the higher byte is first."""

def stored_png(file: bytes) -> StoredPng:
    """The pixels of a PNG file, of all of its bytes. ValueError if it is broken."""

def png_bytes(rgb: Annotated[ArrayLike, numpy.uint8]) -> bytes:
    """The bytes of a PNG file of (height, width, 3) uint8 sRGB, bottom row first."""

def pixels_of_png(file: bytes) -> NDArray[numpy.uint8]:
    """The same pixels of the bytes of a PNG file of any kind; transparent parts lie on white."""

def displayed(image: Annotated[ArrayLike, numpy.float32]) -> NDArray[numpy.uint8]:
    """The same of (height, width, 4) float32, scene-linear and premultiplied, on white."""

class Frame:
    """One picture on its way: each step takes those before it; see native/fovea/draw/frame.h."""
    def __init__(
        self,
        scene: Scene,
        view: View,
        style: style.Style,
        *,
        options: Options=Options(visibility='exact', sample_step=2.0, depth_scale=2, probes=9, layers=3, gap=3.0, spur=1.0, contour_spur=10.0, fold=30.0, tip=6.0, dot=3.0, joint=2.0, fair=1.5, meet=8.0, beside=4.0, least_hidden=6.0, outlines=(), all_paths=False, focus_step=1, with_depth=False, with_focus=False, with_hidden=False, with_line_sets=False, with_line_depth=False, with_line_vector=False, with_line_id=False, boil_drawing=0, matte_ranks=0),
        assets: Assets | None=None,
        backend: Backend | None=None,
        overrides: Overrides | None=None,
        colors: ColorSources | None=None,
        near: Mapping[int, NearLines]={},
        since_key: int=0,
        baked_marks: Annotated[ArrayLike, numpy.float64] | None=None,
        poses: Mapping[int, Pose]={},
        exposure: Exposure | None=None,
        files: Mapping[str, FileContent]={},
        cancel: Cancel | None=None,
        progress: Callable | None=None,
    ) -> None:
        """near: {how many frames later another is: its NearLines}; since_key: how many frames earlier the last key of
        marks is (Animation.since_key); baked_marks: (n,) float64 of its own lines, in place of those handed on; poses:
        of the frames before and after, {-1: Pose, 1: Pose}, either of which may be missing, for line vectors; exposure:
        an Exposure, whose ink is drawn in place of the frame's own; files: {path as the style has it: FileContent},
        others are missing; progress(share, stage) is called before each stage."""
    def find(self) -> None: ...
    def see(self) -> None: ...
    def filter(self) -> None: ...
    def thin(self) -> None: ...
    def shape(self) -> None: ...
    def ink(self) -> None: ...
    def picture(self) -> None: ...
    def passes(self) -> dict[str, object]:
        """{name: pixels, or None}, of line_sets {name of the set: pixels}, of mattes [pixels]; they are handed over,
        once."""
    def answers(self) -> bool:
        """Whether lines answer to frames near this one."""
    def found_lines(self) -> FoundLines: ...
    def take_over(self, same: FoundLines) -> None:
        """Takes over the FoundLines of a Frame of the same content (content_of), style, options and backend."""
    def focus_of_pixels(self) -> NDArray[numpy.float32] | None:
        """(H, W) float32 in [0, 1] of what each pixel shows; None: all is in focus."""
    def object_at(self, px: Annotated[Sequence[float], 'FixedSize(2)'], radius: float) -> str:
        """Name of the object that a disc of the picture shows most of, around a place (x, y) in pixels from the lower
        left; empty: none."""
    def strokes_with(self, shown: Annotated[ArrayLike, numpy.float32]) -> Strokes:
        """Strokes of which elision leaves (samples,) so much."""
    def seen_beside(self, offset_px: float) -> NDArray[numpy.uint8]:
        """(samples,) uint8: exactly seen so many pixels to the left of the line; see
        native/fovea/visibility/exact.h."""
    def polylines(self, drawn: bool=False) -> Polylines:
        """Polylines of what pens draw, without haloes and overshoot; takes the steps up to `thin`. drawn: as strokes
        have it, with these, and with what is seen in frames near by; up to `shape`."""
    def layouts(self, most_side: int, overlap_px: int=0) -> list[DepthLayout]:
        """DepthLayouts in at most so many texels along each axis; cores are looked out of by so many pixels."""
    @property
    def focus_function(self) -> Focus: ...
    @property
    def scene(self) -> Scene: ...
    @property
    def view(self) -> View: ...
    @property
    def options(self) -> Options: ...
    @property
    def cancel(self) -> Cancel: ...
    @property
    def paths(self) -> Paths: ...
    @property
    def clipped(self) -> ClippedPaths: ...
    @property
    def visible(self) -> Runs: ...
    @property
    def runs(self) -> Runs: ...
    @property
    def drawn(self) -> Runs:
        """Runs with haloes and overshoot"""
    @property
    def strokes(self) -> Strokes: ...
    @property
    def pens(self) -> list[Pen]: ...
    @property
    def textures(self) -> list[PenTexture]: ...
    @property
    def samples(self) -> NDArray[numpy.float32] | None:
        """(samples,) float32 visibility, or None"""
    @property
    def focus(self) -> NDArray[numpy.float32] | None:
        """(samples,) float32 in [0, 1], 0: in focus; or None"""
    @property
    def distance(self) -> NDArray[numpy.float32] | None:
        """(samples,) float32 in [0, 1], 0: near; or None"""
    @property
    def shown(self) -> NDArray[numpy.float32] | None:
        """(samples,) float32 that elision leaves; or None"""
    @property
    def visibility_in_words(self) -> str: ...
    @property
    def stages(self) -> dict[str, float]:
        """{stage: milliseconds}, in the order in which they ran"""

class NearLines:
    """Lines of a frame as neighboring frames need them."""
    @property
    def marks_content(self) -> int:
        """Hash of the lines that marks are handed on along; 0: there are none."""
    def own_marks(self) -> NDArray[numpy.float64]:
        """(n,) float64 places of marks along them, in pixels, as the frame alone has them."""
    def marks_handed_on(self, before: NearLines, marks: Annotated[ArrayLike, numpy.float64]) -> NDArray[numpy.float64]:
        """(n,) float64 marks, handed on from those of the NearLines of a frame beside it."""

class FoundLines:
    """What a frame has found of its lines, without neighboring frames."""
    @property
    def near_lines(self) -> NearLines: ...
    @property
    def shown_lines(self) -> ShownLines:
        """what elision leaves of them; None: there is no elision"""
    @property
    def bytes(self) -> int:
        """about"""

class Exposure:
    """The ink of moments while a shutter is open, averaged; see native/fovea/draw/exposure.h."""
    def __init__(self) -> None: ...
    def add(self, moment: Frame, weight: float) -> None:
        """Draws the ink of a moment's Frame, with this weight above 0, and takes it out of the frame."""
    def again(self, weight: float) -> None:
        """Once more the moment that was added last."""
    @property
    def empty(self) -> bool: ...

class Ahead:
    """Computes what frames of a style will need of surfaces, on other threads, while others are read. As a context: at
    its end what is not done is left."""
    def __init__(self, style: style.Style, cancel: Cancel) -> None:
        """cancel: a Cancel, or None"""
    def add(self, surface: Surface) -> None:
        """A surface that is not changed before the end."""

class Backend:
    """Who decides what a depth buffer hides, what crowds, and who puts strokes on paper."""
    def __init__(self) -> None: ...
    @property
    def name(self) -> str: ...
    def visibility(self, frame: Frame) -> NDArray[numpy.float32]:
        """(samples,) float32 in [0, 1] of a frame's atlas, by its sampled method."""
    def elide(self, frame: Frame, elision: Elision) -> NDArray[numpy.float32]:
        """(D, 2) float32 crowding of the samples that runs cover."""
    def draw(self, frame: Frame) -> NDArray[numpy.float32]:
        """(H, W, 4) float32: the frame's strokes alone, premultiplied, bottom row first."""

class CpuBackend(Backend):
    """The reference, all in software."""
    def __init__(self, most_side: int=6144) -> None:
        """texels of a tile of the depth buffer"""
    @property
    def most_side(self) -> int: ...
    @most_side.setter
    def most_side(self, value: int) -> None: ...

class Options:
    """Numbers of the method that are not the style's; see native/fovea/draw/options.h."""
    def __init__(self, **kwargs) -> None: ...
    def replace(self, **kwargs) -> Options:
        """The same with other values."""
    def __eq__(self, other: Options) -> bool: ...
    def __hash__(self) -> int: ...
    @property
    def visibility(self) -> str: ...
    @property
    def sample_step(self) -> float: ...
    @property
    def depth_scale(self) -> int: ...
    @property
    def probes(self) -> int: ...
    @property
    def layers(self) -> int: ...
    @property
    def gap(self) -> float: ...
    @property
    def spur(self) -> float: ...
    @property
    def contour_spur(self) -> float: ...
    @property
    def fold(self) -> float: ...
    @property
    def tip(self) -> float: ...
    @property
    def dot(self) -> float: ...
    @property
    def joint(self) -> float: ...
    @property
    def fair(self) -> float: ...
    @property
    def meet(self) -> float: ...
    @property
    def beside(self) -> float: ...
    @property
    def least_hidden(self) -> float: ...
    @property
    def outlines(self) -> tuple[tuple[int, list[str]], ...]: ...
    @property
    def all_paths(self) -> bool: ...
    @property
    def focus_step(self) -> int: ...
    @property
    def with_depth(self) -> bool: ...
    @property
    def with_focus(self) -> bool: ...
    @property
    def with_hidden(self) -> bool: ...
    @property
    def with_line_sets(self) -> bool: ...
    @property
    def with_line_depth(self) -> bool: ...
    @property
    def with_line_vector(self) -> bool: ...
    @property
    def with_line_id(self) -> bool: ...
    @property
    def boil_drawing(self) -> int: ...
    @property
    def matte_ranks(self) -> int: ...

VISIBILITY: list

def murmur_hash(name: str) -> int:
    """Cryptomatte's hash of a name."""

def cryptomatte_id(name: str) -> int:
    """Bits of the float that stands for a name in mattes."""

class Assets:
    """Pen textures and papers that ship, by name."""
    def __init__(self, folder: os.PathLike | str | bytes) -> None: ...

class ColorSources:
    """Where the colors of a scene come from."""
    def __init__(
        self,
        surfaces: Sequence[SurfaceColor],
        lights: Sequence[Light],
        world: Annotated[Sequence[float], 'FixedSize(3)'],
    ) -> None:
        """surfaces: a SurfaceColor or None per placement; world: radiance of the sky."""

class MaterialFilter:
    """Materials that have lines, by their number on a surface."""
    def __init__(
        self,
        mask_of_placement: Annotated[ArrayLike, numpy.uint32],
        masks: Sequence[Annotated[ArrayLike, numpy.uint8]],
    ) -> None:
        """mask_of_placement (n,) uint32; masks: uint8 by the material's number, 0: its faces have no lines."""

class Overrides:
    """What an artist has said of a scene's n placements."""
    def __init__(
        self,
        *,
        importance: Annotated[ArrayLike, numpy.float32] | None=None,
        painted: Mapping[tuple[str, str], Sequence[Annotated[ArrayLike, numpy.float32] | None]]={},
        painted_colors: Mapping[tuple[str, str], Sequence[Annotated[ArrayLike, numpy.float32] | None]]={},
        objects: Sequence[Sequence[str]]=[],
        names: Sequence[str]=[],
        objects_of_placement: Annotated[ArrayLike, numpy.uint32] | None=None,
        density_map: ColorTexture | None=None,
        placements: Sequence[Annotated[ArrayLike, numpy.uint8] | None]=[],
        materials: Sequence[MaterialFilter | None]=[],
        shown: Annotated[ArrayLike, numpy.uint32] | None=None,
        parameters: Mapping[str, Mapping[str, Annotated[ArrayLike, numpy.float64]]]={},
        lined: MaterialFilter | None=None,
    ) -> None:
        """importance: (n,) float32 in [0, 1]; painted: {(source of a pen's paint, name): n arrays (K,) float32 at the
        mesh's K corners (its vertices if it has no faces), for K materials or, of objects, 1, or None}, painted_colors:
        the same (K, 3); objects: lists of names, names: of each of these the object's own, for mattes, and
        objects_of_placement (n,) uint32: the list of each; density_map: over the camera's frame. By line set:
        placements (n,) uint8 whose lines are for it, and materials whose faces' lines are, None: all. Of all sets:
        shown (n,) uint32 registry bits of what each placement shows, parameters {definition: {parameter: (n,) float64
        that placements have instead, NaN: none}}, and lined: the materials that have lines at all."""

def content_of(scene: Scene, view: View, overrides: Overrides) -> int:
    """Hash of what the lines of a frame depend on, beside its style, options and backend."""

class CenterLines:
    """A frame's strokes as R polylines of M points in all, with what their pens make of them; takes the frame's steps
    up to `shape`."""
    def __init__(self, frame: Frame) -> None: ...
    def __len__(self) -> int: ...
    @property
    def offsets(self) -> NDArray[numpy.uint32]:
        """(R + 1,) uint32: points of line i are offsets[i] .. offsets[i + 1]"""
    @property
    def path_id(self) -> NDArray[numpy.uint64]:
        """(R,) uint64 persistent id of the path, ascending"""
    @property
    def pen(self) -> NDArray[numpy.uint32]:
        """(R,) uint32 of the style's pens, as Pens numbers them"""
    @property
    def line_set(self) -> NDArray[numpy.uint8]:
        """(R,) uint8"""
    @property
    def invisibility(self) -> NDArray[numpy.uint8]:
        """(R,) uint8 surfaces that hide it; 0: visible"""
    @property
    def closed(self) -> NDArray[numpy.uint8]:
        """(R,) uint8, 1: the last point is the first again"""
    @property
    def position_view(self) -> NDArray[numpy.float32]:
        """(M, 3) float32 view space: the eye at 0, looking along -z"""
    @property
    def color(self) -> NDArray[numpy.float32]:
        """(M, 3) float32 scene-linear"""
    @property
    def width_px(self) -> NDArray[numpy.float32]:
        """(M,) float32 of the whole stroke, in pixels"""
    @property
    def opacity(self) -> NDArray[numpy.float32]:
        """(M,) float32 in [0, 1]; of textures, the mean of their ink"""
    @property
    def strength(self) -> NDArray[numpy.float32]:
        """(M,) float32 in [0, 1] of the line"""
    @property
    def kinds(self) -> NDArray[numpy.uint32]:
        """(M,) uint32 bits of the line definitions of the segment around the point; see line_definitions()"""

class Titles:
    """What a title block says; see native/fovea/vector/titles.h."""
    def __init__(self, **kwargs) -> None: ...
    def replace(self, **kwargs) -> Titles:
        """The same with other values."""
    def __eq__(self, other: Titles) -> bool: ...
    def __hash__(self) -> int: ...
    @property
    def title(self) -> str: ...
    @property
    def document(self) -> str: ...
    @property
    def number(self) -> str: ...
    @property
    def revision(self) -> str: ...
    @property
    def sheet(self) -> str: ...
    @property
    def date(self) -> str: ...
    @property
    def creator(self) -> str: ...
    @property
    def approver(self) -> str: ...
    @property
    def owner(self) -> str: ...
    fields: ClassVar[tuple]

class VectorOptions:
    """What a drawing is like as vectors; see native/fovea/vector/options.h."""
    def __init__(self, **kwargs) -> None: ...
    def replace(self, **kwargs) -> VectorOptions:
        """The same with other values."""
    def __eq__(self, other: VectorOptions) -> bool: ...
    def __hash__(self) -> int: ...
    @property
    def sheet(self) -> str: ...
    @property
    def margin(self) -> float: ...
    @property
    def to_scale(self) -> bool: ...
    @property
    def tolerance(self) -> float: ...
    @property
    def widths(self) -> str: ...
    @property
    def dashes_apart(self) -> bool: ...
    @property
    def ground(self) -> bool: ...
    @property
    def colors(self) -> str: ...
    @property
    def plotter(self) -> bool: ...
    @property
    def title_block(self) -> bool: ...
    @property
    def titles(self) -> Titles: ...
    @property
    def unit_meters(self) -> float: ...
    fields: ClassVar[tuple]

SHEETS: list

WIDTHS: list

VECTORS: list

def sheet_size(sheet: str) -> dict:
    """{width, height} of an upright sheet of paper [mm]; 0: that of the picture."""

def room_on_sheet(options: VectorOptions, upright: bool) -> dict:
    """{width, height} of the largest picture within the margins of a sheet, without its title block [mm]."""

class Drawing:
    """A frame's strokes as layers of curves."""
    def __init__(self, frame: Frame, options: VectorOptions, kind: str='svg') -> None:
        """Takes the frame's steps up to `shape`; kind: of files, svg, pdf or dxf."""
    @property
    def figures(self) -> dict:
        """{what there is: how much}"""
    def file(self) -> bytes:
        """The bytes of a file."""

def layered_picture(frame: Frame) -> dict:
    """{layers: [(line set or '', name, PNG of a layer) from below], merged: PNG of the picture, thumbnail: PNG}; takes
    all steps of the frame."""

class Screen:
    """How a picture becomes black and white; see native/fovea/color/screentone.h."""
    def __init__(self, **kwargs) -> None: ...
    def replace(self, **kwargs) -> Screen:
        """The same with other values."""
    def __eq__(self, other: Screen) -> bool: ...
    def __hash__(self) -> int: ...
    @property
    def dpi(self) -> float: ...
    @property
    def lines_per_inch(self) -> float: ...
    @property
    def angle(self) -> float: ...
    @property
    def threshold(self) -> float: ...
    fields: ClassVar[tuple]
    def page_height(self, height_mm: float) -> int:
        """Height in pixels of a page."""

def one_bit(frame: Frame, screen: Screen) -> NDArray[numpy.uint8]:
    """(H, W) uint8, bottom row first: 1 is white, 0 black; takes all steps of the frame."""

class Bitmap:
    """A drawing as a set of pixels."""
    def __init__(self, pixels: Annotated[ArrayLike, numpy.uint8]) -> None:
        """pixels: (H, W) uint8, bottom row first; 0: not drawn."""
    @staticmethod
    def of_lines(
        px: Annotated[ArrayLike, numpy.float32],
        offsets: Annotated[ArrayLike, numpy.int64],
        width: int,
        height: int,
    ) -> Bitmap:
        """Of polylines with points px (M, 2) float32 from the lower left corner; line i has the points offsets[i] to
        offsets[i + 1]."""
    @staticmethod
    def of_svg(
        data: Sequence[str],
        transforms: Annotated[ArrayLike, numpy.float64],
        is_filled: Sequence[bool],
        width: int,
        height: int,
    ) -> Bitmap:
        """Of path data of SVG, with transforms (N, 6) as SVG has them, to pixels from the upper left corner; of filled
        paths the lines in their middle."""
    @property
    def pixels(self) -> NDArray[numpy.uint8]:
        """(H, W) uint8 of 1 and 0, bottom row first"""
    @property
    def usual_tolerance(self) -> float:
        """Distance [px] that counts as near in drawings of this size"""
    def distances(self) -> NDArray[numpy.float32]:
        """(H, W) float32 distances [px] to the nearest pixel that is drawn."""
    def measures(self, judge: Bitmap, tolerance: float) -> dict:
        """{measure: number} of this drawing judged by another Bitmap; see native/fovea/study/measures.h."""
    def registration(self, reference: Bitmap, tolerance: float) -> object:
        """{to_scan: (3, 3) from pixels of a reference Bitmap to those of this one, outer_share: share of its outer
        boundary that is within the tolerance [px]}, by their lines; None if one is empty."""

class Nearness:
    """How far the pixels of two drawings are from each other."""
    def __init__(self, a: Bitmap, b: Bitmap) -> None: ...
    def measures(self, tolerance: float) -> dict:
        """As Bitmap.measures."""
    @property
    def pixels(self) -> int:
        """of both"""
    def shares_within(self, distances: Sequence[float]) -> NDArray[numpy.float64]:
        """For each of the distances [px] the share of both drawings' pixels that are that near to the other one."""

LEAST_INK: float

class StrokeLooks:
    """How wide and dark strokes are; see native/fovea/study/stroke_look.h."""
    @property
    def pixel(self) -> NDArray[numpy.uint32]:
        """(N,) uint32 numbers of pixels, row by row from below"""
    @property
    def width(self) -> NDArray[numpy.float32]:
        """(N,) float32 [px]"""
    @property
    def darkness(self) -> NDArray[numpy.float32]:
        """(N,) float32 share of the paper's light that is missing in the stroke, [0, 1]; NaN on dark paper"""

class GrayImage:
    """A scan or picture of gray values."""
    def __init__(self, values: Annotated[ArrayLike, numpy.uint8]) -> None:
        """values: (H, W) uint8, bottom row first."""
    @staticmethod
    def of_png(file: bytes) -> GrayImage:
        """Of a PNG file's bytes; transparent parts lie on white."""
    @property
    def values(self) -> NDArray[numpy.uint8]:
        """(H, W) uint8, bottom row first"""
    def resampled(self, to_picture: Annotated[ArrayLike, numpy.float64], width: int, height: int) -> GrayImage:
        """A GrayImage of other pixels, which the matrix (3, 3) maps to those of this one."""
    def frame_by_marks(self, width: int, height: int) -> object:
        """The matrix (3, 3) from pixels of a picture to those of this scan of its prompt sheet; None: the marks are not
        found."""
    def prompt_sheet(self, title: str, sheet: str='a4') -> bytes:
        """A PDF file's bytes: a sheet to draw on after this picture; see native/fovea/study/sheet.h."""
    def lines(self) -> Bitmap:
        """The Bitmap of what is drawn, one pixel wide; see native/fovea/study/scan.h."""
    def stroke_looks(self, lines: Bitmap) -> StrokeLooks:
        """The StrokeLooks of this picture along the Bitmap of its lines."""

class PrecisionRecall:
    """Drawings of ever more lines, by the threshold of their strengths."""
    @property
    def threshold(self) -> NDArray[numpy.float32]:
        """(N,) float32 strengths from which on lines are drawn, descending; the first is infinite"""
    @property
    def precision(self) -> NDArray[numpy.float64]:
        """(N,) float64 of the drawing"""
    @property
    def recall(self) -> NDArray[numpy.float64]:
        """(N,) float64 of the drawing, ascending"""
    def best_at(self, precision: float) -> int:
        """The number of the one with the most recall of at least this precision; -1: there is none."""
    def recall_at(self, precision: float) -> float:
        """Its recall."""
    @property
    def area(self) -> float:
        """Mean recall at precisions of 0.5 to 1"""

class Strengths:
    """Strengths of lines at pixels."""
    def __init__(
        self,
        px: Annotated[ArrayLike, numpy.float32],
        offsets: Annotated[ArrayLike, numpy.int64],
        strength: Annotated[ArrayLike, numpy.float32],
        width: int,
        height: int,
    ) -> None:
        """Of polylines as for Bitmap.of_lines, with the strength (M,) at their points."""
    def above(self, threshold: float) -> Bitmap:
        """The Bitmap of pixels with at least a strength."""
    def curve(self, always: Bitmap, judge: Bitmap, tolerance: float) -> PrecisionRecall:
        """The PrecisionRecall of these lines, with the Bitmap of lines that are drawn in any case, judged by another
        one."""

class Evidence:
    """What a fit of thresholds depends on; see native/fovea/study/evidence.h and fit.h."""
    def __init__(self, definitions: Sequence[Strengths], judges: Sequence[Bitmap], tolerance: float) -> None:
        """Of the Strengths of D definitions and of the Bitmaps of drawings in the same view; `tolerance` [px]."""
    def fitted(self, thresholds: Annotated[ArrayLike, numpy.float32], beta: float=1.0) -> dict:
        """{thresholds: (D,) float32, infinite for what is not drawn, precision, recall, f1, score} with which the
        definitions draw what is most like all drawings together. `thresholds`: to start from."""
    def judged(self, thresholds: Annotated[ArrayLike, numpy.float32], beta: float=1.0) -> dict:
        """The same of the given thresholds."""
    def cross_validated(self, thresholds: Annotated[ArrayLike, numpy.float32], beta: float=1.0) -> dict:
        """The same without thresholds, of parts that are held out of the fit one after the other: each of the drawings,
        or of a single one blocks of the picture."""

class Salience:
    """How far places of a picture stand out of the rest."""
    usual_diagonal: ClassVar[float]
    @staticmethod
    def itti_koch(pixels: Annotated[ArrayLike, numpy.uint8]) -> Salience:
        """By the model of Itti, Koch and Niebur; pixels: (H, W, 3) uint8 as displayed, bottom row first."""
    @staticmethod
    def spectral_residual(pixels: Annotated[ArrayLike, numpy.uint8]) -> Salience:
        """By that of Hou and Zhang."""
    @property
    def map(self) -> numpy.ndarray:
        """(h, w) float32 of cells, bottom row first; all 0: nothing stands out"""
    def of_pixels(self, width: int, height: int) -> NDArray[numpy.float32]:
        """(H, W) float32 of a picture's pixels, as shares of the most."""
    def fixations(self, most: int) -> NDArray[numpy.float64]:
        """(n, 3) float64, at most `most`, in the order in which eyes go there: the place, 0 to 1 from the left and the
        bottom, and its salience as a share of the first one's."""
    def share(self, weights: Annotated[ArrayLike, numpy.float32]) -> float:
        """Share of all salience that lies where weights (H, W), 0 to 1, say."""

class StrokeCourses:
    """Where strokes run beside lines; see native/fovea/study/stroke_course.h."""
    @property
    def away(self) -> NDArray[numpy.float32]:
        """(S,) float32 [px] of strokes to the left of lines, a pixel apart along them; NaN: not told"""
    @property
    def first(self) -> NDArray[numpy.int64]:
        """(R + 1,) int64: line i has the samples first[i] to first[i + 1]"""
    @property
    def beyond(self) -> NDArray[numpy.float32]:
        """(R, 2) float32 [px] that strokes go on beyond starts and ends of lines, below 0: they stop before; NaN: not
        told"""
    @staticmethod
    def of(
        picture: GrayImage,
        px: Annotated[ArrayLike, numpy.float32],
        offsets: Annotated[ArrayLike, numpy.int64],
        is_free: Annotated[ArrayLike, numpy.uint8],
        every: Bitmap,
        reach: float,
        cap: float,
    ) -> StrokeCourses:
        """Of a GrayImage and polylines as for Bitmap.of_lines. is_free: (2 R,) uint8, whether their starts and ends are
        told; every: the Bitmap of all lines that may be drawn; reach [px]: farthest that strokes are from lines; cap:
        of a stroke's width, beyond its end."""

def wobble_of(
    away: Annotated[ArrayLike, numpy.float32],
    first: Annotated[ArrayLike, numpy.int64],
    longest: float,
) -> object:
    """(amount, wavelength) [px] of a pen's wobble, from `away` and `first` of StrokeCourses; 0, 0: none. longest: wave
    [px] that is looked for."""

class BasRelief:
    """A surface with its depth scaled and sheared along the view."""
    def __init__(self, depth: float=1.0, slope: Annotated[Sequence[float], 'FixedSize(2)']=(0.0, 0.0)) -> None: ...
    least_depth: ClassVar[float]
    most_depth: ClassVar[float]
    @staticmethod
    def fitted(normals: Annotated[ArrayLike, numpy.float64], onto: Annotated[ArrayLike, numpy.float64]) -> BasRelief:
        """The one that turns unit normals (n, 3) nearest to others, by the mean angle."""
    @property
    def depth(self) -> float: ...
    @property
    def slope(self) -> Annotated[list[float], 'FixedSize(2)']: ...
    def of_normals(self, normals: Annotated[ArrayLike, numpy.float64]) -> NDArray[numpy.float64]:
        """(n, 3) unit normals of the relief of (n, 3) of a surface."""
    def inverse(self) -> BasRelief:
        """The one that undoes it."""

class GaugePlaces:
    """What is seen at places of a picture; see native/fovea/study/gauges.h."""
    @property
    def placement(self) -> NDArray[numpy.uint32]:
        """(N,) uint32; 0xffffffff: not one surface, without creases and steps"""
    @property
    def normal(self) -> NDArray[numpy.float64]:
        """(N, 3) float64 as gauges show it: x to the right, y up, z towards the viewer"""
    @staticmethod
    def of(tracer: Tracer, px: Annotated[ArrayLike, numpy.float64], radius: float) -> GaugePlaces:
        """Of what a Tracer sees at (n, 2) pixels from the lower left; radius [px]: all within it is to be one
        surface."""

class LocalProperties:
    """What is known of each pixel of a scene alone."""
    def __init__(self, scene: Scene, view: View) -> None:
        """Of the pixels of a view; see native/fovea/study/local_properties.h."""
    names: ClassVar[tuple]
    @property
    def known(self) -> numpy.ndarray:
        """(H, W) uint8, bottom row first; 1: a surface is seen there or beside"""
    @property
    def values(self) -> NDArray[numpy.float32]:
        """(H, W, 15) float32, in the order of `names`, which are pairs of name and label"""

class LineModel:
    """How likely a line is at pixels, learned from drawings."""
    def __init__(
        self,
        kind: str,
        rows: Annotated[ArrayLike, numpy.float32],
        target: Annotated[ArrayLike, numpy.float32],
        weight: Annotated[ArrayLike, numpy.float32],
    ) -> None:
        """kind: one of `kinds`; rows (n, 15) of LocalProperties, target (n,) in [0, 1], weight (n,) positive."""
    kinds: ClassVar[tuple]
    @staticmethod
    def of_json(text: str) -> LineModel:
        """Of a model file's text."""
    def json(self) -> str:
        """The text of a model file, of which the same model is read."""
    @property
    def kind(self) -> str: ...
    @property
    def threshold(self) -> float:
        """Probability from which on there are lines"""
    @property
    def content(self) -> FileContent:
        """As FileContent of a line definition."""
    def with_threshold(self, threshold: float) -> LineModel:
        """The same with another one."""
    def __eq__(self, other: LineModel) -> bool: ...
    def values(self, rows: Annotated[ArrayLike, numpy.float32]) -> NDArray[numpy.float32]:
        """(n,) float32 probabilities of rows (n, 15)."""
    def probabilities(self, properties: LocalProperties) -> NDArray[numpy.float32]:
        """(H, W) float32, bottom row first; 0 where the properties are not known."""
    def importance(
        self,
        rows: Annotated[ArrayLike, numpy.float32],
        target: Annotated[ArrayLike, numpy.float32],
        weight: Annotated[ArrayLike, numpy.float32],
    ) -> dict:
        """{property: share of the target's variance by which the error grows without it}; see
        native/fovea/study/samples.h."""

def crests_of(probability: Annotated[ArrayLike, numpy.float32]) -> Strengths:
    """The Strengths of the crests of probabilities (H, W); see native/fovea/study/probable_lines.h."""

def lines_of(crests: Strengths, threshold: float) -> Bitmap:
    """The Bitmap of the crests that are as strong as the threshold somewhere, as far as they have half of it."""

notes: dict
