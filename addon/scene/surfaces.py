# SPDX-License-Identifier: GPL-3.0-or-later
"""Cache of native surfaces between frames; validated by content hashes, never by pointers or update flags."""

from dataclasses import dataclass
from functools import partial

import numpy as np

from . import kept, mesh_arrays
from . import repair as repairs
from .shapes import AUTOMATIC, HARD, REST, AtRest

BYTES, BYTES_WITH_CURVATURE = 145, 250  # per triangle: edges, planes, BVH, lines of the mesh

REMARKS = {  # counts of a surface's report -> text
    "non_finite_vertices": "vertices have no position and were left out",
    "degenerate_polygons": "faces have no area and were left out",
    "duplicate_polygons": "faces repeat others and were left out",
    "inconsistent_edges": "edges lie between faces that disagree about which side is out",
}


@dataclass
class _Entry:
    surface: object  # native Surface; None: a cage without a limit surface
    topology: tuple  # number of vertices, and content hashes of all arrays but the positions
    positions: tuple  # content hashes; None: it has only some of them
    ngons: tuple  # content hashes of the n-gons' triangulation
    rest: tuple | None = None  # (shape, reason) as decided of the mesh at rest
    undeformed: int = 0  # content hash of the positions at rest; 0: those that it has
    seen: tuple = ()  # for a refined surface: content hashes of Blender's subdivided mesh
    age: int = 0  # passes since its last use
    used: int = 0  # logical time of its last use (kept.now)


class SurfaceCache:
    """Surfaces by a key that identifies the mesh's source; content hashes decide whether an entry is valid."""

    def __init__(self, core, *, refit=False):
        """`core`: the native module. `refit`: refit BVHs of deforming meshes, which is faster than rebuilding, but then
        it depends on earlier frames which of two triangles a ray through their side hits. Not for final renders, whose
        frames must be independent."""
        self._core, self._refit = core, refit
        self.entries = {}
        self._asked = {}  # key -> number of its uses in this pass
        self.buffers = mesh_arrays.Buffers()
        self.at_rest = AtRest(core, self.buffers)
        self.rebuilt = []  # surfaces built in this pass
        self.moved = []  # surfaces whose positions changed in this pass
        self.remarks = []  # sentences for the user about surfaces built in this pass
        kept.add_cache(self, core)

    def begin(self):
        """Starts a pass over a depsgraph."""
        self._asked, self.rebuilt, self.moved, self.remarks = {}, [], [], []
        self.at_rest.begin()
        for entry in self.entries.values():
            entry.age += 1

    def end(self, kept_passes):
        """Ends a pass: drops surfaces that were not used in the last `kept_passes` passes."""
        if self.rebuilt:
            self.buffers.make_room()
        self.entries = {key: entry for key, entry in self.entries.items() if entry.age < kept_passes}

    def items(self, needed):
        """The surfaces as kept.Items; those whose id is in `needed` are pinned."""
        found = []
        for key, entry in self.entries.items():
            let_go = None if id(entry.surface) in needed else partial(self._drop, key)
            found.append(kept.Item(entry.used, _size(entry.surface), let_go))
        return found

    def _drop(self, key):
        gone = self.entries.pop(key).surface
        self.rebuilt = [surface for surface in self.rebuilt if surface is not gone]
        self.moved = [surface for surface in self.moved if surface is not gone]

    def surface(self, key, name, mesh, slots, repair=None, cuts=None, *, with_marks, shape=AUTOMATIC, rest=None):
        """The native surface of an evaluated mesh: cached, or with new positions, or built. `slots`: its materials;
        `name`: for messages; `cuts`: CutOuts of a mesh that is not repaired, or None; `shape`: what its polygons stand
        for; `rest`: its mesh at rest, which decides that, or None."""
        key = self._ordered((key, repair))
        arrays, static, topology, positions = self._read(mesh, slots, with_marks)
        topology += cuts.key if cuts else ()
        entry = self.entries.get(key)
        changed = entry is None or (entry.topology, entry.positions) != (topology, positions)
        if changed:
            triangles = mesh_arrays.ngon_triangles(mesh, arrays.polygon_offsets, self.buffers)
            ngons = self._hashes(triangles.values())
            if entry is not None and repair is None and (entry.topology, entry.ngons) == (topology, ngons):
                self._move(entry, arrays, positions)
            else:
                whole = self._core.Mesh(positions=arrays.positions, **static, **triangles)
                if cuts:
                    surface = cuts.surface(self._core, name, whole, arrays)
                else:
                    surface = self._core.Surface(name, self._repaired(name, whole, repair))
                entry = self.entries[key] = _Entry(surface, topology, positions, ngons)
                self.rebuilt.append(entry.surface)
            if repair is None and not cuts:
                self._set_rest(entry, mesh, rest)
        self.at_rest.set_shape(entry, shape, rest, changed)
        entry.age, entry.used = 0, kept.now()
        return entry.surface

    def bare(self, key, name, shape, slots):
        """The native surface of a bare_shapes.Shape, or None if there is nothing of it: as `surface`."""
        if (read := shape.read()) is None:
            return None
        key, hides = self._ordered(key), slots[0].hides
        topology = (hides, type(read), read.topology())
        positions = (self._hash(read.points), self._hash(read.radii))
        entry = self.entries.get(key)
        if entry is None or (entry.topology, entry.positions) != (topology, positions):
            made = read.mesh(self._core, name, hides)
            if entry is not None and entry.topology == topology:
                self._move(entry, made, positions)
            else:
                entry = self.entries[key] = _Entry(self._core.Surface(name, made.mesh), topology, positions, ())
                entry.surface.set_shape(HARD)  # its outlines are those of its faces
                self.rebuilt.append(entry.surface)
        entry.age, entry.used = 0, kept.now()
        return entry.surface

    def refined(self, key, name, mesh, cage, slots, plan, repair=None, *, with_marks, shape=AUTOMATIC, rest=None):
        """The native surface on the limit of a cage's subdivision; None if it has no limit surface, with one remark.

        `mesh`: Blender's subdivided mesh, whose hashes show whether the cage has changed; `cage()`: a context with the
        cage; `rest`: the mesh before modifiers, or None.
        """
        key = self._ordered((key, plan, repair))
        _, _, topology, positions = self._read(mesh, slots, with_marks)
        seen = (*topology, *self._hashes(mesh_arrays.creases(mesh, self.buffers)), positions)
        entry = self.entries.get(key)
        if entry is None or entry.seen != seen:
            with cage() as mesh:
                entry = self.entries[key] = self._refined(entry, name, mesh, slots, plan, repair, with_marks)
                if entry.surface is not None and repair is None:
                    self._set_rest(entry, mesh, rest)
            entry.seen = seen
        if entry.surface is not None:
            entry.surface.set_shape(shape)
        entry.age, entry.used = 0, kept.now()
        return entry.surface

    def _refined(self, entry, name, cage, slots, plan, repair, with_marks):
        """The entry for a cage: `entry`, with new positions if only these differ, or a new one.

        A repaired cage has different edges, so creases are dropped.
        """
        arrays, static, topology, positions = self._read(cage, slots, with_marks)
        creases = mesh_arrays.creases(cage, self.buffers) if plan.use_creases and not repair else (None, None)
        topology += self._hashes(creases)
        moved = entry is not None and entry.positions != positions
        if entry is None or entry.topology != topology or (moved and repair):
            entry = _Entry(None, topology, positions, ())
            # OpenSubdiv needs no triangulation, but a repair does.
            triangles = mesh_arrays.ngon_triangles(cage, arrays.polygon_offsets, self.buffers) if repair else {}
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
        """Sets the positions of an entry's surface; `positions`: their content hashes."""
        entry.positions = None  # until it has all of them: setting them may be cancelled
        entry.surface.set_positions(arrays.positions, refit=self._refit)
        entry.positions = positions
        self.moved.append(entry.surface)

    def _set_rest(self, entry, mesh, base):
        """Tells an entry's surface where the vertices of `mesh` are at rest, as far as that is known; see AtRest."""
        positions = self.at_rest.positions(mesh, base, entry.topology)
        known = self._hash(positions)
        if known == entry.positions[0]:
            positions, known = None, 0
        if entry.undeformed != known:
            entry.surface.set_rest(positions)
            entry.undeformed = known

    def _repaired(self, name, mesh, repair):
        """A native Mesh, repaired if `repair` is not None; adds a remark on what was repaired."""
        if not repair:
            return mesh
        repaired = self._core.RepairedMesh(name, mesh, **repair.words(), most_triangles=repairs.MOST_TRIANGLES)
        if told := remark(name, repaired.report, repairs.REMARKS):
            self.remarks.append(told)
        return repaired.mesh

    def _ordered(self, key):
        """(key, n): the n-th use of this key in the current pass."""
        self._asked[key] = self._asked.get(key, 0) + 1
        return key, self._asked[key]

    def _read(self, mesh, slots, with_marks):
        """(MeshArrays, keyword arguments of a native Mesh without the positions, topology hashes of these, content
        hashes of the positions and of those at rest that the mesh has)."""
        arrays = mesh_arrays.read(self._core, mesh, self.buffers, with_marks=with_marks)
        static = {**vars(arrays), **_per_polygon(arrays, slots)}
        del static["positions"]
        topology = (len(arrays.positions), *self._hashes(static.values()))
        at_rest = mesh_arrays.vectors(mesh, REST, self.buffers)
        return arrays, static, topology, self._hashes((arrays.positions, at_rest))

    def _hashes(self, arrays):
        return tuple(self._hash(array) for array in arrays)

    def _hash(self, array):
        return 0 if array is None else self._core.content_hash(array)


def remark(name, report, words=REMARKS):
    """One sentence about the nonzero counts of a native report (elements left out or wrong), or None."""
    found = [f"{count} {told}" for what, told in words.items() if (count := getattr(report, what))]
    return f"'{name}': {'; '.join(found)}" if found else None


def remarks(found):
    """A sentence about each of these native surfaces of whose mesh something was left out or looks wrong."""
    return [told for surface in found if (told := remark(surface.name, surface.report))]


def _size(surface):
    """Estimated bytes of a surface with its fields and lines; measured on meshes of quads."""
    if surface is None:
        return 0
    return len(surface.triangles) * (BYTES_WITH_CURVATURE if surface.fields_reason else BYTES)


def _per_polygon(arrays, slots):
    """Arrays that depend on material slots, as arguments of a native Mesh: {name: (F,) array}; None: the same material
    for all polygons, or all occlude, or all have two sides.

    Slots with the same material count as one.
    """
    names, count = [slot.name for slot in slots], len(arrays.polygon_offsets) - 1
    found = {"material": None, "occluding": None, "one_sided": None}
    if arrays.material is None or len(slots) == 1:
        number = np.zeros(count, np.int32)
        slots = slots[:1]
    else:
        number = np.clip(arrays.material, 0, len(slots) - 1)
        found["material"] = np.array([names.index(name) for name in names], np.int32)[number]
    if not all(slot.hides for slot in slots):
        found["occluding"] = np.array([slot.hides for slot in slots], np.bool_)[number]
    if any(slot.one_sided for slot in slots):
        found["one_sided"] = np.array([slot.one_sided for slot in slots], np.bool_)[number]
    return found
