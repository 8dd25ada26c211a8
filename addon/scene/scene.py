# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads an evaluated depsgraph into a Snapshot: one native surface per mesh, and its placements."""

import hashlib
from functools import partial
from typing import NamedTuple

import bpy
import numpy as np

from .. import native
from . import (
    bare_shapes,
    cut_outs,
    detail,
    followed,
    instances,
    kept,
    lights,
    materials,
    own_lines,
    repair,
    section,
    shapes,
    subdivision,
)
from .mesh_arrays import is_edited
from .snapshot import Origin, Snapshot

DRAW, OCCLUDE, HOLDOUT = 1, 2, 4  # native/fovea/scene/scene.h
VIEWPORTS = 4  # factor on the number of passes after which unused surfaces are dropped, as viewports take turns
USAGE = {"BOTH": DRAW | OCCLUDE, "OCCLUDE": OCCLUDE, "DRAW": DRAW, "IGNORE": 0}


class _Met(NamedTuple):
    """An instance, and what is read of it more than once."""

    object: object  # a temporary copy, as are objects that Blender converted to meshes
    real: object  # its evaluated original, of which settings are read: reading them from a copy leaks memory
    settings: object
    owner: object  # whose visibility it has (instances.owner)
    name: str  # the object's full name
    parent: str  # full name of its instancer; "": none


class _Gathering:
    """Collects placements during the traversal of a depsgraph; one surface per distinct (evaluated mesh, materials,
    subdivision plan, repair, curvature settings, shape). `beside`: further Gatherings that get each surface; `ahead`: a
    native Ahead that does, or None."""

    def __init__(self, cache, depsgraph, viewport, with_marks, beside, images, sizes, ahead):
        self.beside, self.sizes, self.ahead = beside, sizes, ahead
        self.opacities = images and cut_outs.Opacities(images)
        self.cache, self.with_marks = cache, with_marks
        self.depsgraph, self.layer, self.viewport = depsgraph, followed.view_layer(depsgraph), viewport
        self.surfaces, self.slots = [], []
        self.known_materials, self.known_names, self.index_of = {}, {}, {}
        self.known_own, self.known_guides, self.left_out = {}, None, {}
        self.outlines = bare_shapes.outlines()
        self.together = None  # {object: collection with one outline}, by full names
        self.lights = {}  # kind of instances: its light and the hash of its names
        self.section, self.plane = section.of(depsgraph), section.plane_of(depsgraph)
        self.origins, self.origins_of_kind = [], []  # Origins; by kind of instances, its first and how many

    def meet(self, instance):
        """Adds the Origins of a kind of instances, by the first of them."""
        first, obj = len(self.origins), instance.object
        real, parent = obj.original.evaluated_get(self.depsgraph), instances.instancer(instance)
        met = _Met(obj, real, real.fovea, parent or obj, obj.name_full, parent.name_full if parent else "")
        if obj.type == "LIGHT" and instance.show_self:
            self.lights[len(self.origins_of_kind)] = obj.data, self.name_hash(met.name, met.parent)
        usage = self.usage(met)
        if usage and instance.show_self:
            self.add_data(met, usage)
        if usage and instance.show_particles:
            for shape in bare_shapes.of_particles(real, self.depsgraph):
                self.add_shape(shape, met, usage)
        self.origins_of_kind.append((first, len(self.origins) - first))

    def add_data(self, met, usage):
        """Adds what is drawn of an instance's own data."""
        obj, data = met.object, met.object.data
        if isinstance(data, bpy.types.Mesh):
            if is_edited(obj):
                # The arrays of an edited mesh are empty; to_mesh creates a mesh with them.
                self.add_mesh(obj.to_mesh(), _of_temporary(met), met, usage)
                obj.to_mesh_clear()
            else:
                self.add_mesh(data, data.as_pointer(), met, usage)
        # Objects that Blender converts to meshes appear twice: with their own data, and with the mesh, if it has faces.
        elif obj.type in bare_shapes.CURVES:
            self.add_wire(met, usage)
        elif shape := bare_shapes.of_data(obj, followed.of(self.depsgraph.scene)):
            self.add_shape(shape, met, usage)

    def usage(self, met):
        """Usage bits of an instance: those of its object and of its instancer (a collection instance, say) combined by
        and."""
        obj, owner = met.object, met.owner
        if self.section and self.section.original in (obj.original, owner.original):
            return 0  # it stands for a plane
        usage = USAGE[met.settings.usage]
        if obj == owner:
            owner = met.real
        else:
            owner = owner.original.evaluated_get(self.depsgraph)
            usage &= USAGE[owner.fovea.usage]
        if not met.real.visible_camera or owner.indirect_only_get(view_layer=self.layer):
            return 0
        if self.viewport is not None and not owner.visible_in_viewport_get(self.viewport):
            return 0
        holdout = met.real.is_holdout or owner.holdout_get(view_layer=self.layer)
        return OCCLUDE | HOLDOUT if holdout and usage & OCCLUDE else usage

    def surface_index(self, mesh, place, met):
        # The object is part of the key because it may have its own materials.
        obj, real = met.object, met.real
        known = (place, met.name)
        if known not in self.index_of:
            slots = materials.slots(obj, mesh, self.known_materials)
            plan, mend = subdivision.plan(real, mesh, self.depsgraph), repair.of(met.settings)
            curvature, shape = _curvature(met.settings), met.settings.shape.lower()
            shared = (place, slots, plan, mend, curvature, shape)
            if shared not in self.index_of:
                self.index_of[shared] = len(self.surfaces)
                cuts, remarks = self.cuts(met, mesh, slots, plan, mend)
                surface = self.surface(met, mesh, slots, plan if cuts is None else None, mend, cuts, shape)
                if self.cache.rebuilt[-1:] == [surface]:
                    told = [*repair.remarks_of_removed(obj), *remarks]
                    self.cache.remarks += [sentence for sentence in told if sentence not in self.cache.remarks]
                surface.set_field_options(*curvature)
                cage = partial(subdivision.cage, real, mesh, plan, self.depsgraph)
                self.add_surface(obj, mesh, surface, slots, cage, repaired=mend is not None)
            self.index_of[known] = self.index_of[shared]
        return self.index_of[known]

    def add_surface(self, obj, mesh, surface, slots, cage, *, repaired):
        """Adds a surface that nothing changes any more in this pass."""
        if self.ahead:
            self.ahead.add(surface)
        for gathering in self.beside:
            gathering.add_surface(obj, mesh, surface, cage, repaired=repaired)
        self.surfaces.append(surface)
        self.slots.append(slots)

    def cuts(self, met, mesh, slots, plan, mend):
        """(CutOuts of an evaluated mesh or None, remarks)."""
        untold = cut_outs.untold(slots)
        if self.opacities is None or not any(slot.cut for slot in slots):
            return None, untold
        obj = met.object
        if mend is not None:
            return None, [*untold, *cut_outs.remarks(cut_outs.REPAIRED, obj, slots)]
        found, remarks = cut_outs.of(self.opacities, obj, mesh, slots, self.sizes.get(met.name, 0.0))
        if found and plan is not None:
            remarks += cut_outs.remarks(cut_outs.REFINED, obj, slots)
        return found, [*untold, *remarks]

    def surface(self, met, mesh, slots, plan, mend, cuts, shape):
        """The native surface of an evaluated mesh, refined by `plan`, repaired by `mend`, cut by `cuts`; each may be
        None."""
        key, name, found = (met.name, mesh.name_full, slots), met.object.name, None
        words = {"with_marks": self.with_marks, "shape": shape, "rest": shapes.rest(met.real, mesh)}
        if plan is not None:
            cage = partial(subdivision.cage, met.real, mesh, plan, self.depsgraph)
            found = self.cache.refined(key, name, mesh, cage, slots, plan, mend, **words)
        if found is None:
            found = self.cache.surface(key, name, mesh, slots, mend, cuts, **words)
        return found

    def add_mesh(self, mesh, place, met, usage):
        """Adds the Origin of an evaluated mesh. Skips empty meshes. `place`: what identifies the mesh. Addresses do, as
        evaluated meshes keep them during a traversal, but not those of temporary meshes (`_of_temporary`)."""
        if len(mesh.edges):
            self.add_origin(self.surface_index(mesh, place, met), met, usage)

    def add_shape(self, shape, met, usage):
        """Adds the Origin of a bare_shapes.Shape, unless it is empty."""
        place = (*shape.place, met.name)
        if place not in self.index_of:
            slots = materials.slots(shape, shape, self.known_materials)
            surface = self.cache.bare((met.name, shape.name, slots), met.object.name, shape, slots)
            self.index_of[place] = None if surface is None else len(self.surfaces)
            if surface is not None:
                self.add_surface(shape, shape, surface, slots, None, repaired=True)
        if self.index_of[place] is not None:
            self.add_origin(self.index_of[place], met, usage, shape)

    def add_wire(self, met, usage):
        """Adds the Origin of a curve that has no faces, as the edges that Blender makes of it."""
        obj = met.object
        mesh = obj.to_mesh()
        if self.known_guides is None:
            self.known_guides = bare_shapes.guides(followed.of(self.depsgraph.scene).objects)
        if mesh is None:
            self.left_out[obj.name] = bare_shapes.NODE_CURVES
        elif len(mesh.polygons):
            pass  # they are an instance of their own
        elif obj.original in self.known_guides:
            self.left_out[obj.name] = bare_shapes.GUIDE
        else:
            self.add_mesh(mesh, _of_temporary(met), met, usage)
        obj.to_mesh_clear()

    def add_origin(self, surface, met, usage, shape=None):
        """Adds the Origin of placements of a surface (its index). `shape`: the Shape that it is made of, or None."""
        if usage & OCCLUDE and all(slot.holdout for slot in self.slots[surface]):
            usage = OCCLUDE | HOLDOUT
        owners = (met.name, met.parent) if met.parent else (met.name,)
        names, (color, priority, shown, *own) = (met.name, met.parent), self.own(met)
        if shape:
            names = (*names, shape.name) if shape.name else names
            shown &= self.outlines if shape.outlined else shown
        names, group = self.name_hash(*names), self.outline_group(met)
        self.origins.append(Origin(surface, names, usage, group, met.object.name, owners, priority, shown, color, own))

    def own(self, met):
        """(color, priority, *own_lines.of) of an instance's object."""
        if met.name not in self.known_own:
            color = tuple(met.real.color)[:3]
            self.known_own[met.name] = (color, met.settings.priority, *own_lines.of(met.settings))
        return self.known_own[met.name]

    def outline_group(self, met):
        """Number of the group that an object, or the instance of it by its parent, has one outline with; 0: of none."""
        if self.together is None:
            self.together = {
                member.name_full: collection.name_full
                for collection in bpy.data.collections
                if collection.fovea.one_outline
                for member in collection.all_objects
            }
        if group := met.settings.outline_group:
            return self.name_hash("", group)
        collection = self.together.get(met.name)
        return self.name_hash("collection", collection, met.parent) if collection else 0

    def name_hash(self, *names):
        if names not in self.known_names:
            digest = hashlib.blake2b("\0".join(names).encode(), digest_size=8).digest()
            self.known_names[names] = int.from_bytes(digest, "little")
        return self.known_names[names]

    def lamps(self, matrices, persistent, kinds):
        """The Lamps of all instances; arguments as for `snapshot`."""
        steps = np.flatnonzero(np.isin(kinds, list(self.lights)))
        of_steps = [self.lights[kind] for kind in kinds[steps].tolist()]
        ids = instances.ids(np.array([names for _, names in of_steps], np.uint64), persistent[steps])
        return [lights.lamp(data, matrices[step], of) for (data, _), step, of in zip(of_steps, steps, ids)]

    def snapshot(self, matrices, persistent, kinds):
        """The Snapshot. `matrices` (k, 4, 4), `persistent` (k, 8), `kinds` (k,): of all k instances of a depsgraph."""
        first, count = np.array(self.origins_of_kind, np.int64).reshape(-1, 2)[kinds].T
        before = np.cumsum(count) - count  # placements, of the instances before each
        steps = np.repeat(np.arange(len(kinds)), count)
        origin_of = (np.arange(len(steps)) + (first - before)[steps]).astype(np.uint32)
        names = np.array([origin.names for origin in self.origins], np.uint64)[origin_of]
        usage = np.array([origin.usage for origin in self.origins], np.uint8)[origin_of]
        ids = instances.ids(names, persistent[steps])
        lamps = self.lamps(matrices, persistent, kinds)
        told = (
            self.left_out,
            self.plane,
            lamps,
            [self.cache.at_rest.decided.get(id(surface)) for surface in self.surfaces],
        )
        return Snapshot(self.surfaces, self.slots, self.origins, origin_of, matrices[steps], ids, usage, *told)


def _of_temporary(met):
    """What identifies the temporary mesh that Blender makes of an instance's object."""
    return met.name, met.object.data.as_pointer()


def _curvature(settings):
    """Curvature settings of an object, as arguments of the native Surface.set_field_options."""
    rings = settings.curvature_rings if settings.curvature_estimator == "JETS" else 0
    return settings.curvature_estimator.lower(), 0, rings, settings.curvature_smoothing


def gather(
    depsgraph, cache, *, with_marks=True, viewport=None, images=None, colors=None, notes=None, cancel=None, ahead=None
):
    """The Snapshot of an evaluated depsgraph. `viewport`: its SpaceView3D; None for a final render. `images`: an
    ImageCache for opacity, None: nothing is cut out. `colors`: a color_sources.Gathering to fill, or None; `notes`: a
    notes.Gathering to fill, or None. `cancel`: a native Cancel, or None; `ahead`: a native Ahead, or None.

    Curves, text, surfaces and metaballs are read as the meshes that Blender converts them to; hair and point clouds by
    bare_shapes.py. Hidden objects and collections are not among the depsgraph's instances.
    """
    beside = [beside for beside in (colors, notes) if beside]
    sizes = _sizes(depsgraph, cancel) if images else {}
    gathering = _Gathering(cache, depsgraph, viewport, with_marks, beside, images, sizes, ahead)
    cache.begin()
    matrices, persistent, kinds = instances.read(depsgraph.object_instances, gathering.meet, cancel)
    # View layers and viewports may show different parts of a scene in alternating passes.
    cache.end(len(depsgraph.scene.view_layers) * (1 if viewport is None else VIEWPORTS))
    found = gathering.snapshot(matrices, persistent, kinds)
    kept.add_snapshot(found)
    return found


def _sizes(depsgraph, cancel):
    """How large objects are seen (detail.px_per_unit), in files in which some material is cut out."""
    if not bpy.data.images or not any(slot.cut for slot in materials.slots_of(bpy.data.materials, {})):
        return {}
    return detail.px_per_unit(depsgraph, cancel)


def placed(core, snapshot):
    """The native Scene of a Snapshot."""
    found = snapshot
    with native.refusals():
        return core.Scene(
            found.surfaces,
            found.surface_of_placement,
            found.object_to_world,
            found.persistent_id,
            found.usage,
            found.of_origins("group", np.uint64),
            found.section,
            found.native_lights(core),
        )


def seen(core, view):
    """The native View of a stages.View."""
    with native.refusals():
        return core.View(**vars(view))


def has_anything(scene):
    """Whether any object of the scene, hidden or not, is of a type that can have lines, or that Blender draws over the
    picture."""
    kinds = {"MESH", "CURVE", "SURFACE", "FONT", "META", "CURVES", "POINTCLOUD", "GREASEPENCIL", "GPENCIL"}
    return any(obj.type in kinds or obj.instance_type != "NONE" for obj in scene.objects)
