# SPDX-License-Identifier: GPL-3.0-or-later
"""Filters of lines per placement, from line sets, objects and materials."""

import bpy
import numpy as np

from ..style import FILTERS
from . import own_lines


def of(core, line_sets, snapshot):
    """The keyword arguments of native Overrides that filter the lines of a style's line sets on a Snapshot's
    placements."""
    shown = snapshot.of_origins("shown", np.uint32)
    by_material = [_slots_of(line_set, snapshot.slots) for line_set in line_sets]

    def materials(masks):
        return core.MaterialFilter(snapshot.surface_of_placement, masks) if masks else None

    return {
        "placements": [_placements(*words, snapshot) for words in zip(line_sets, by_material)],
        "materials": [materials(masks) for masks in by_material],
        "shown": None if (shown == own_lines.ALL_KINDS).all() else shown,
        "parameters": _own_parameters(snapshot),
        "lined": materials(_lined(snapshot)),
    }


def _own_parameters(snapshot):
    """{definition: {parameter: (n,) values, NaN: not overridden}} of the parameters that any placement overrides."""
    found, known = {}, own_lines.parameters()
    own = np.array([origin.own for origin in snapshot.origins], np.float64).reshape(-1, len(known))
    for (definition, parameter), values in zip(known, own.T):
        if not np.isnan(values).all():
            of_placement = values[snapshot.origin_of_placement]
            found.setdefault(definition["name"], {})[parameter["name"]] = of_placement
    return found


def asked(line_sets):
    """The filters of line sets, to be compared: while they are equal, `of` gives the same for the same Snapshot."""
    return [[(getattr(s, name), getattr(s, others)) for name, others in FILTERS.items()] for s in line_sets]


def _placements(line_set, by_material, snapshot):
    """(n,) uint8 mask of the placements that a LineSet applies to; None: all. The placement's object or its instancer
    must pass the collection and object filters, and any of its materials the material filter. A filter by a name that
    does not exist matches nothing."""
    chosen = np.ones(len(snapshot.origin_of_placement), np.uint8)
    if line_set.collection:
        collection = bpy.data.collections.get(line_set.collection)
        inside = {obj.name_full for obj in collection.all_objects} if collection else set()
        chosen &= _owned(inside, snapshot) != line_set.outside
    if line_set.object:
        obj = bpy.data.objects.get(line_set.object)
        chosen &= _owned({obj.name_full} if obj else set(), snapshot) != line_set.other_objects
    if by_material:
        some = np.array([mask.any() for mask in by_material], np.uint8)
        chosen &= some[snapshot.surface_of_placement]
    return None if chosen.all() else chosen


def _owned(names, snapshot):
    """(n,) bool: whether any owner of each placement has one of these full names."""
    owned = [not names.isdisjoint(origin.owners) for origin in snapshot.origins]
    return np.array(owned, bool)[snapshot.origin_of_placement]


def _slots_of(line_set, slots):
    """Per surface, a uint8 mask of the material slots that a LineSet applies to; None: all."""
    if not line_set.material:
        return None
    material = bpy.data.materials.get(line_set.material)
    name = material.name_full if material else None
    return [np.array([(slot.name == name) != line_set.other_materials for slot in of], np.uint8) for of in slots]


def _lined(snapshot):
    """Per surface, a uint8 mask of the material slots that have lines; None if all have."""
    masks = [np.array([slot.lines for slot in of_surface], np.uint8) for of_surface in snapshot.slots]
    return None if all(mask.all() for mask in masks) else masks
