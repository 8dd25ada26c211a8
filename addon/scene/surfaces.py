# SPDX-License-Identifier: GPL-3.0-or-later
"""Native surfaces of meshes, kept from frame to frame; content tells them apart, never a pointer or an update flag."""

from dataclasses import dataclass
from functools import partial

import numpy as np

from . import kept, mesh_arrays
from . import repair as repairs

BYTES, BYTES_WITH_CURVATURE = 145, 250  # per triangle: edges, planes, BVH, lines of the mesh


REMARKS = {  # what a surface's report counts
    "non_finite_vertices": "vertices have no position and were left out",
    "degenerate_polygons": "faces have no area and were left out",
    "duplicate_polygons": "faces repeat others and were left out",
    "loose_edges": "edges belong to no face and have no lines",
    "inconsistent_edges": "edges lie between faces that disagree about which side is out",
}


@dataclass
class _Entry:
    surface: object  # None: a cage without a limit surface
    topology: tuple  # content hashes of everything but the positions
    positions: int
    ngons: tuple
    seen: tuple = ()  # of a refined one: content hashes of what Blender made of the cage
    age: int = 0  # passes since it was last asked for
    used: int = 0  # when it was last asked for


class SurfaceCache:
    """Surfaces by a key that names where a mesh comes from; the content decides whether one is still good."""

    def __init__(self, core, *, refit=False):
        """`refit`: what moves is followed faster, by rays whose last bits depend on where it was before. Not for final
        renders, whose frames depend on nothing but themselves."""
        self._core, self._refit = core, refit  # the native module
        self.entries = {}
        self._asked = {}  # how often each key came up in this pass
        self._buffers = mesh_arrays.Buffers()
        self.rebuilt = []  # surfaces built in this pass
        self.moved = []  # surfaces whose positions changed in this pass
        self.remarks = []  # sentences for the user about what was built in this pass
        kept.add_cache(self)

    def begin(self):
        """Starts a pass over a depsgraph."""
        self._asked, self.rebuilt, self.moved, self.remarks = {}, [], [], []
        for entry in self.entries.values():
            entry.age += 1

    def end(self, kept_passes):
        """Ends it: lets go of surfaces that none of the last `kept_passes` passes asked for."""
        self.entries = {key: entry for key, entry in self.entries.items() if entry.age < kept_passes}

    def items(self, needed):
        """The kept.Items: surfaces; those that are needed, by their ids, stay."""
        found = []
        for key, entry in self.entries.items():
            let_go = None if id(entry.surface) in needed else partial(self._drop, key)
            found.append(kept.Item(entry.used, _size(entry.surface), let_go))
        return found

    def _drop(self, key):
        gone = self.entries.pop(key).surface
        self.rebuilt = [surface for surface in self.rebuilt if surface is not gone]
        self.moved = [surface for surface in self.moved if surface is not gone]

    def surface(self, key, name, mesh, slots, repair=None, *, with_marks):
        """The native surface of an evaluated mesh. `slots`: its materials; `name` is for messages."""
        key = self._ordered((key, repair))
        arrays, static, topology, positions = self._read(mesh, slots, with_marks)
        entry = self.entries.get(key)
        if entry is None or (entry.topology, entry.positions) != (topology, positions):
            triangles = mesh_arrays.ngon_triangles(mesh, arrays.polygon_offsets, self._buffers)
            ngons = self._hashes(triangles.values())
            if entry is not None and repair is None and (entry.topology, entry.ngons) == (topology, ngons):
                self._move(entry, arrays, positions)
            else:
                whole = self._core.Mesh(positions=arrays.positions, **static, **triangles)
                surface = self._core.Surface(name, self._repaired(name, whole, repair))
                entry = self.entries[key] = _Entry(surface, topology, positions, ngons)
                self.rebuilt.append(entry.surface)
        entry.age, entry.used = 0, kept.now()
        return entry.surface

    def refined(self, key, name, mesh, cage, slots, plan, repair=None, *, with_marks):
        """The native surface on the limit of a cage's subdivision; None where it has no limit surface, said once.

        `mesh`: what Blender made of the cage, which tells whether it has changed; `cage()`: a context with the cage.
        """
        key = self._ordered((key, plan, repair))
        _, _, topology, positions = self._read(mesh, slots, with_marks)
        seen = (*topology, *self._hashes(mesh_arrays.creases(mesh, self._buffers)), positions)
        entry = self.entries.get(key)
        if entry is None or entry.seen != seen:
            with cage() as mesh:
                entry = self.entries[key] = self._refined(entry, name, mesh, slots, plan, repair, with_marks)
            entry.seen = seen
        entry.age, entry.used = 0, kept.now()
        return entry.surface

    def _refined(self, entry, name, cage, slots, plan, repair, with_marks):
        """The entry for a cage: the one there is, moved when only positions differ, or a new one.

        A repaired cage has other edges, and so no creases.
        """
        arrays, static, topology, positions = self._read(cage, slots, with_marks)
        creases = mesh_arrays.creases(cage, self._buffers) if plan.use_creases and not repair else (None, None)
        topology += self._hashes(creases)
        moved = entry is not None and entry.positions != positions
        if entry is None or entry.topology != topology or (moved and repair):
            entry = _Entry(None, topology, positions, ())
            # OpenSubdiv needs no triangles, a repair does.
            triangles = mesh_arrays.ngon_triangles(cage, arrays.polygon_offsets, self._buffers) if repair else {}
            whole = self._core.Mesh(positions=arrays.positions, **static, **triangles)
            whole = self._repaired(name, whole, repair)
            try:
                entry.surface = self._core.RefinedSurface(name, whole, plan.level, plan.round_corners, *creases)
                self.rebuilt.append(entry.surface)
            except ValueError as error:
                self.remarks.append(f"{error}; drawn as Blender subdivides it")
        elif entry.surface is not None and moved:
            self._move(entry, arrays, positions)
        return entry

    def _move(self, entry, arrays, positions):
        """Gives the surface of an entry the positions of a mesh, whose content hash is given."""
        entry.surface.set_positions(arrays.positions, refit=self._refit)
        entry.positions = positions
        self.moved.append(entry.surface)

    def _repaired(self, name, mesh, repair):
        """A native Mesh, repaired where the user wants it."""
        if not repair:
            return mesh
        repaired = self._core.RepairedMesh(name, mesh, **repair.words())
        if told := remark(name, repaired.report, repairs.REMARKS):
            self.remarks.append(told)
        return repaired.mesh

    def _ordered(self, key):
        """The key, and which of those with it in this pass it is."""
        self._asked[key] = self._asked.get(key, 0) + 1
        return key, self._asked[key]

    def _read(self, mesh, slots, with_marks):
        """The mesh's arrays, those that do not move by their names in a native Mesh, and content hashes of the latter and
        of the positions."""
        arrays = mesh_arrays.read(mesh, self._buffers, with_marks=with_marks)
        material, occluding = _per_polygon(arrays, slots)
        static = {**vars(arrays), "material": material, "occluding": occluding}
        del static["positions"]
        topology = (len(arrays.positions), *self._hashes(static.values()))
        return arrays, static, topology, self._hash(arrays.positions)

    def _hashes(self, arrays):
        return tuple(self._hash(array) for array in arrays)

    def _hash(self, array):
        return 0 if array is None else self._core.content_hash(array)


def remark(name, report, words=REMARKS):
    """One sentence about what a native report counts (what of a Surface was left out or looks wrong), or None."""
    found = [f"{count} {told}" for what, told in words.items() if (count := getattr(report, what))]
    return f"'{name}': {'; '.join(found)}" if found else None


def _size(surface):
    """Bytes that a surface takes with what was found on it, about; measured of quads."""
    if surface is None:
        return 0
    return len(surface.triangles) * (BYTES_WITH_CURVATURE if surface.fields_reason else BYTES)


def _per_polygon(arrays, slots):
    """(F,) int32 material and (F,) bool whether it hides what lies behind; None where all polygons are alike.

    Slots that hold the same material count as one.
    """
    names = [slot.name for slot in slots]
    if arrays.material is None or len(slots) == 1:
        return None, None if slots[0].hides else np.zeros(len(arrays.polygon_offsets) - 1, np.bool_)
    slot = np.clip(arrays.material, 0, len(slots) - 1)
    material = np.array([names.index(name) for name in names], np.int32)[slot]
    if all(s.hides for s in slots):
        return material, None
    return material, np.array([s.hides for s in slots], np.bool_)[slot]
