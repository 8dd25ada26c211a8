# SPDX-License-Identifier: GPL-3.0-or-later
"""What has no faces in Blender and is drawn all the same: hair, of curves and of particles, and point clouds.

Bare curves are not among them: Blender itself turns them into meshes of loose edges.
"""

from dataclasses import dataclass
from functools import partial

import bpy
import numpy as np

from . import line_kinds, materials

CURVES = {"CURVE", "FONT", "SURFACE"}  # types of objects that Blender converts to meshes
RADIUS = 0.01  # of points without one, as in Blender
POLY = 1  # a type of curve that is not rounded
SEGMENTS = 8  # of a strand of few points, which is rounded: as many as viewports of Blender show
GUIDE = "is a curve that other objects or nodes use, and is not drawn: a bevel, or a copy of it, makes it visible"
NODE_CURVES = (
    "has curves of geometry nodes, which engines are not given: the node Curve to Mesh makes them visible, "
    "or As Instance of the node Object Info"
)


@dataclass(frozen=True, eq=False)
class Strands:
    """Polylines as ShapeMesh.strands takes them."""

    points: np.ndarray  # (P, 3) float32
    radii: np.ndarray  # (P,) float32
    offsets: np.ndarray  # (S + 1,) int32
    steps: int
    ribbons: bool

    def topology(self):
        return self.steps, self.ribbons, self.offsets.tobytes()

    def mesh(self, core, name, hides):
        how = {"steps": self.steps, "ribbons": self.ribbons, "occludes": hides}
        return core.ShapeMesh.strands(name, self.points, self.radii, self.offsets, **how)


@dataclass(frozen=True, eq=False)
class Points:
    """A point cloud as ShapeMesh.spheres takes it."""

    points: np.ndarray  # (P, 3) float32
    radii: np.ndarray  # (P,) float32

    def topology(self):
        return len(self.points)

    def mesh(self, core, name, hides):
        return core.ShapeMesh.spheres(name, self.points, self.radii, occludes=hides)


@dataclass(frozen=True, eq=False)
class Shape:
    """Something without faces that an object has. It stands for the object and for its mesh where materials and colors
    are read: its only material is that of all its faces."""

    place: tuple  # tells it from others in one traversal of a depsgraph
    name: str  # of the particle system, else ""
    materials: list
    outlined: bool  # whether it has `outlines` alone
    read: object  # () -> Strands or Points, not empty; None if there is nothing of it

    material_slots = ()


def of_data(obj, scene):
    """The Shape of an instance's own data, or None. `obj`: the instance's object, `scene`: the depsgraph's."""
    data = obj.data
    if isinstance(data, bpy.types.PointCloud):
        outlined, read = True, partial(_points, data)
    elif isinstance(data, bpy.types.Curves) and obj.original.fovea.hair != "OFF":
        outlined = obj.original.fovea.hair == "RIBBONS"
        read = partial(_strands, data, scene.render.hair_subdiv, outlined)
    else:
        return None
    return Shape((data.as_pointer(),), "", materials.of(obj, data)[:1], outlined, read)


def of_particles(real, depsgraph):
    """The Shapes of an instance's particle hair. `real`: the evaluated original of its object."""
    if real.fovea.hair == "OFF":
        return
    shown, ribbons = "show_render" if depsgraph.mode == "RENDER" else "show_viewport", real.fovea.hair == "RIBBONS"
    for modifier in real.modifiers:
        if modifier.type != "PARTICLE_SYSTEM" or not getattr(modifier, shown):
            continue
        system = modifier.particle_system
        if is_hair(system):
            slots = real.material_slots
            slot = min(system.settings.material, len(slots)) - 1
            material = slots[slot].material if slots else None
            read = partial(_particles, real, system, depsgraph.mode, ribbons)
            yield Shape((real.name_full, system.name), system.name, [material], ribbons, read)


def is_hair(system):
    """Whether a particle system has strands that renders show."""
    return system.settings.type == "HAIR" and system.settings.render_type == "PATH"


def outlines():
    """The bits of the lines that ribbons and spheres have: contours along edges, which are those with a twin on smooth
    surfaces. What else their small faces have is no shape."""
    return sum(1 << bit for bit, definition in enumerate(line_kinds.definitions()) if definition["smooth_twin"])


def guides(objects):
    """Those of these curve objects that other objects, curves or nodes use: paths to follow, profiles, what geometry
    nodes work on. Being a parent is no such use."""
    curves = [obj for obj in objects if obj.type in CURVES]
    users = bpy.data.user_map(subset=curves, value_types={"OBJECT", "CURVE", "NODETREE"}) if curves else {}
    return {obj for obj, by in users.items() if any(getattr(user, "parent", None) != obj for user in by - {obj})}


def _points(data):
    points, radii = _vectors(data.attributes["position"].data), _radii(data)
    good = np.isfinite(points).all(axis=1) & (radii > 0.0)
    return Points(points[good], radii[good]) if good.any() else None


def _strands(data, subdivision, ribbons):
    """The Strands of a Curves datablock."""
    offsets = np.empty(len(data.curves) + 1, np.int32)
    data.curve_offset_data.foreach_get("value", offsets)
    kinds = data.attributes.get("curve_type")
    is_poly = kinds is not None and (_read(kinds.data, "value", np.int32) == POLY).all()
    points, radii = _vectors(data.position_data), _radii(data)
    cyclic = data.attributes.get("cyclic")
    if cyclic is not None:
        points, radii, offsets = _closed(points, radii, offsets, _read(cyclic.data, "value", np.bool_))
    segments = int(np.diff(offsets).max(initial=2)) - 1
    steps = 1 if is_poly else max(1, (SEGMENTS << subdivision) // max(segments, 1))
    return _useful(points, radii, offsets, min(steps, 64), ribbons)


def _closed(points, radii, offsets, cyclic):
    """Strands whose first point is repeated at the end where they are `cyclic` (S,) bool."""
    counts = np.diff(offsets)
    longer = counts + (cyclic & (counts > 0))
    ends = _offsets(longer)
    within = np.arange(ends[-1]) - np.repeat(ends[:-1], longer)
    index = np.repeat(offsets[:-1], longer) + within % np.repeat(counts, longer)
    return points[index], radii[index], ends


def _particles(obj, system, mode, ribbons):
    """The Strands of a particle system, in the space of its emitter. Blender gives their points one by one."""
    settings = system.settings
    steps = 2 ** (settings.render_step if mode == "RENDER" else settings.display_step) + 1
    parents, children = len(system.particles), len(system.child_particles)
    first = parents if children and settings.child_type != "NONE" and not settings.use_parent_particles else 0
    count, point = parents + children - first, system.co_hair
    flat = [point(obj, particle_no=i, step=k) for i in range(first, first + count) for k in range(steps)]
    world = np.array(flat, np.float64).reshape(-1, 3)
    to_object = np.linalg.inv(np.array(obj.matrix_world))
    points = (world @ to_object[:3, :3].T + to_object[:3, 3]).astype(np.float32)
    radii = np.tile(_tapered(settings, np.linspace(0.0, 1.0, steps)), count).astype(np.float32)
    return _useful(points, radii, np.arange(count + 1, dtype=np.int32) * steps, 1, ribbons)


def _tapered(settings, along):
    """Radii of particle hair along a strand, from 0 at its root to 1: diameters by the panel Hair Shape, as Cycles has
    them."""
    if settings.shape:
        along = along ** (1.0 + settings.shape if settings.shape < 0.0 else 1.0 / (1.0 - min(settings.shape, 0.999)))
    radii = settings.root_radius + (settings.tip_radius - settings.root_radius) * along
    if settings.use_close_tip:
        radii[-1] = 0.0
    return 0.5 * settings.radius_scale * radii


def _useful(points, radii, offsets, steps, ribbons):
    """Strands without those of one point, of no extent, with points that are nowhere or, as ribbons, of no radius; None
    if none is left."""
    counts = np.diff(offsets)
    rows = np.repeat(np.arange(len(counts)), counts)
    moves, wide, kept = np.zeros(len(counts), bool), np.zeros(len(counts), bool), counts > 1
    moves[rows[(points != points[offsets[rows]]).any(axis=1)]] = True
    wide[rows[radii > 0.0] if ribbons else rows] = True
    kept[rows[~np.isfinite(points).all(axis=1)]] = False
    kept &= moves & wide
    if not kept.any():
        return None
    if not kept.all():
        of_kept, counts = kept[rows], counts[kept]
        points, radii = points[of_kept], radii[of_kept]
        offsets = _offsets(counts)
    return Strands(points, np.maximum(radii, 0.0), offsets, steps, ribbons)


def _offsets(counts):
    return np.concatenate([[0], np.cumsum(counts)]).astype(np.int32)


def _radii(data):
    attribute = data.attributes.get("radius")
    return np.full(len(data.points), RADIUS, np.float32) if attribute is None else _read(attribute.data, "value")


def _vectors(values):
    return _read(values, "vector", columns=3).reshape(-1, 3)


def _read(values, name, dtype=np.float32, columns=1):
    array = np.empty(len(values) * columns, dtype)
    values.foreach_get(name, array)
    return array
