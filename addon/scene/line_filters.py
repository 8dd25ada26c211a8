# SPDX-License-Identifier: GPL-3.0-or-later
"""Which lines a scene's placements have: as the line sets of a style, objects and materials say."""

import bpy
import numpy as np

from ..style import FILTERS
from . import own_lines


def of(core, line_sets, snapshot):
    """What native Overrides say of a style's line sets on a Snapshot's placements, by name."""
    shown = snapshot.shown
    by_material = [_slots_of(line_set, snapshot.slots) for line_set in line_sets]

    def materials(masks):
        return core.MaterialFilter(snapshot.surface_of_placement, masks) if masks else None

    return {
        "placements": [_placements(*words, snapshot) for words in zip(line_sets, by_material)],
        "materials": [materials(masks) for masks in by_material],
        "shown": None if (shown == own_lines.ALL_KINDS).all() else shown,
        "parameters": _own_parameters(snapshot.own_values),
        "lined": materials(_lined(snapshot)),
    }


def _own_parameters(own_values):
    """{definition: {parameter: (n,) values}} of those that some placement has of its own."""
    found = {}
    for (definition, parameter), values in zip(own_lines.parameters(), own_values):
        if not np.isnan(values).all():
            found.setdefault(definition["name"], {})[parameter["name"]] = values
    return found


def asked(line_sets):
    """What line sets ask of objects and materials; where this is the same, so is what `of` gives for a Snapshot."""
    return [[(getattr(s, name), getattr(s, others)) for name, others in FILTERS.items()] for s in line_sets]


def _placements(line_set, by_material, snapshot):
    """(n,) uint8 whether a LineSet is for each placement: its object, or what made an instance of it, and some of its
    materials must be what the set draws; None: it is for all. Names that nothing has are of nothing."""
    chosen = np.ones(len(snapshot.owners), np.uint8)
    if line_set.collection:
        collection = bpy.data.collections.get(line_set.collection)
        inside = {obj.name_full for obj in collection.all_objects} if collection else set()
        chosen &= _owned(inside, snapshot.owners) != line_set.outside
    if line_set.object:
        obj = bpy.data.objects.get(line_set.object)
        chosen &= _owned({obj.name_full} if obj else set(), snapshot.owners) != line_set.other_objects
    if by_material:
        some = np.array([mask.any() for mask in by_material], np.uint8)
        chosen &= some[snapshot.surface_of_placement]
    return None if chosen.all() else chosen


def _owned(names, owners):
    """(n,) bool whether placements are of objects of these full names."""
    return np.array([not names.isdisjoint(of_placement) for of_placement in owners], bool)


def _slots_of(line_set, slots):
    """Per surface the mask of the materials that a LineSet is for; None: it is for all."""
    if not line_set.material:
        return None
    material = bpy.data.materials.get(line_set.material)
    name = material.name_full if material else None
    return [np.array([(slot.name == name) != line_set.other_materials for slot in of], np.uint8) for of in slots]


def _lined(snapshot):
    """Per surface the mask of the materials that have lines; None where all have."""
    masks = [np.array([slot.lines for slot in of_surface], np.uint8) for of_surface in snapshot.slots]
    return None if all(mask.all() for mask in masks) else masks
