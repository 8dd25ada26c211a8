# SPDX-License-Identifier: GPL-3.0-or-later
"""Decides which objects are drawn on the limit surface of a Catmull-Clark subdivision, and evaluates their cages."""

from contextlib import contextmanager
from dataclasses import dataclass

import bpy
import numpy as np

from .mesh_arrays import is_edited

MOST_LEVELS = 7  # native/fovea/mesh/refine.h


@dataclass(frozen=True)
class Plan:
    """How a mesh is refined."""

    level: int
    round_corners: bool = True
    use_creases: bool = True
    modifier: int | None = None  # index of the modifier that the limit surface replaces; None: the mesh is the cage


def plan(real, mesh, depsgraph):
    """The Plan for an evaluated mesh of an object, or None if it is drawn as it is. `real`: the object's evaluated
    original.

    If the last active modifier is a Catmull-Clark subdivision, the mesh before it is the cage. Other objects are
    refined only if their setting Refine is on. Modifiers with Use Limit Surface off, and objects in edit mode, are left
    to Blender.
    """
    settings = real.fovea
    wanted = settings.refine_level if settings.refine else 0
    if len(real.modifiers) and real.data == mesh and not is_edited(real):
        index = _last_modifier(real, depsgraph.mode)
        modifier = None if index is None else real.modifiers[index]
        if modifier is not None and modifier.type == "SUBSURF" and modifier.subdivision_type == "CATMULL_CLARK":
            level = _level(modifier, depsgraph)
            if 0 < level <= MOST_LEVELS and modifier.use_limit_surface:
                round_corners = modifier.boundary_smooth == "ALL"
                return Plan(max(level, wanted), round_corners, modifier.use_creases, index)
    return Plan(wanted) if wanted else None


@contextmanager
def cage(real, mesh, chosen, depsgraph):
    """Context with the mesh that a Plan refines, valid inside the `with`.

    Blender evaluates the object's modifiers again without the last one, which is switched off temporarily on the
    evaluated copy of the object; the user's object is not modified. Blender still reports an update of the object, with
    no changed parts (`is_echo`).
    """
    if chosen.modifier is None:
        yield mesh
        return
    switches = _switched_off(real.modifiers, chosen.modifier)
    try:
        # Only with preserve_all_data_layers does Blender evaluate again instead of copying the result it has.
        result = real.to_mesh(preserve_all_data_layers=True, depsgraph=depsgraph)
    finally:
        for name, values in switches.items():
            real.modifiers.foreach_set(name, values)
    try:
        yield result
    finally:
        real.to_mesh_clear()


def is_echo(updates):
    """Whether a depsgraph's updates were all caused by reading a `cage`: objects without changed parts."""
    parts = ("is_updated_geometry", "is_updated_transform", "is_updated_shading")
    return len(updates) > 0 and all(
        isinstance(u.id, bpy.types.Object) and not any(getattr(u, part) for part in parts) for u in updates
    )


def _last_modifier(obj, mode):
    """Index of the last modifier that is enabled in the depsgraph's mode, or None."""
    shown = "show_render" if mode == "RENDER" else "show_viewport"
    return next((i for i in reversed(range(len(obj.modifiers))) if getattr(obj.modifiers[i], shown)), None)


def _level(modifier, depsgraph):
    """The modifier's subdivision level as Blender evaluates it, including the scene's Simplify."""
    in_render = depsgraph.mode == "RENDER"
    level = modifier.render_levels if in_render else modifier.levels
    settings = depsgraph.scene.render
    if settings.use_simplify:
        level = min(level, settings.simplify_subdivision_render if in_render else settings.simplify_subdivision)
    return level


def _switched_off(modifiers, index):
    """Switches one of n modifiers off; returns the previous switches of all: {property: (n,) bool}."""
    before = {}
    for name in ("show_viewport", "show_render"):
        before[name] = np.empty(len(modifiers), np.bool_)
        modifiers.foreach_get(name, before[name])
        modifiers.foreach_set(name, before[name] & (np.arange(len(modifiers)) != index))
    return before
