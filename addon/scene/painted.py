# SPDX-License-Identifier: GPL-3.0-or-later
"""What is painted on surfaces and used by a style: attributes, vertex groups, colors of materials and objects."""

import math
from typing import NamedTuple

import numpy as np

from . import color_nodes, materials
from .color_corners import Corners
from .scene import DRAW

MEMBERS = ("width", "opacity", "color")  # of pens, that may be painted
SHOWN = 3  # most objects that a remark names
NOWHERE = (math.nan,) * 3  # color of a slot without a material


class Paint(NamedTuple):
    """As the native style::Paint."""

    source: str
    name: str = ""

    @property
    def any(self):
        return self.source in {"material", "object"} or bool(self.name)


def of_pen(pen, member):
    """The Paint that a Pen takes a member from."""
    source = getattr(pen, f"paint_{member}")
    return Paint(source, getattr(pen, f"paint_{member}_name") if source in {"vertex_group", "attribute"} else "")


def pens(line_set):
    """All Pens of a LineSet."""
    owners = (line_set, *line_set.hidden)
    return [pen for owner in owners for pen in (owner.pen, owner.pen_away) if pen]


def asked(style):
    """The Paints that a Style uses: (those as numbers, those as colors), each sorted."""
    numbers = {Paint("attribute", style.focus.attribute)}
    if style.elision.enabled:
        numbers |= {
            Paint("attribute", name) for name in (style.elision.priority_attribute, style.elision.density_attribute)
        }
    every = [pen for line_set in style.line_sets for pen in pens(line_set)]
    numbers |= {of_pen(pen, member) for pen in every for member in ("width", "opacity")}
    colors = {of_pen(pen, "color") for pen in every}
    return tuple(tuple(sorted(paint for paint in paints if paint.any)) for paints in (numbers, colors))


class Gathering:
    """Collects, during the traversal of a scene, the arrays of each Paint that a Style uses: one per native surface, in
    order; None where nothing is painted."""

    def __init__(self, core, cache, style):
        self._core, self._cache, self._line_sets = core, cache, style.line_sets
        numbers, colors = asked(style)
        self._numbers, self._colors = {paint: [] for paint in numbers}, {paint: [] for paint in colors}
        self._of_material = {}  # color by material
        self._bare = []  # per surface: whether it has no corners that could be painted

    def add_surface(self, obj, mesh, surface, cage, repaired):
        """Adds a surface; arguments as in color_sources.Gathering. A repaired surface has no attributes and no vertex
        groups, as its corners are not those of the painted mesh."""
        corners = None if repaired else Corners(self._core, obj, mesh, surface, cage, self._cache)
        self._bare.append(repaired)
        slots = materials.of(obj, mesh)
        for paint, found in self._numbers.items():
            found.append(_mean(self._of(slots)) if paint.source == "material" else _numbers(paint, corners))
        for paint, found in self._colors.items():
            found.append(self._of(slots) if paint.source == "material" else _colors(paint, corners))

    def _of(self, slots):
        """(S, 3) colors of the materials in slots; NaN for an empty one."""
        for material in slots:
            if material not in self._of_material:
                self._of_material[material] = color_nodes.source(material).plain if material else NOWHERE
        return np.array([self._of_material[material] for material in slots], np.float32)

    def arguments(self, snapshot):
        """The arguments of native Overrides for a Snapshot's placements."""
        of_objects = np.array([origin.color for origin in snapshot.origins], np.float32).reshape(-1, 1, 3)
        return {
            "painted": _placed(self._numbers, snapshot, _mean(of_objects)),
            "painted_colors": _placed(self._colors, snapshot, of_objects),
        }

    def remarks(self, snapshot, masks):
        """A list with a sentence for each Paint that some objects lack, whose lines a pen with it draws. `masks`: per
        line set (n,) of the placements that it applies to, or None: all."""
        lacking = {}  # (Paint, member, whether the surface is bare) -> names of objects
        draws = snapshot.usage & DRAW != 0
        for line_set, mask in zip(self._line_sets, masks, strict=True):
            named = {(of_pen(pen, member), member) for pen in pens(line_set) for member in MEMBERS}
            named = {(paint, member) for paint, member in named if paint.name}
            if not named:
                continue
            drawn = np.unique(snapshot.origin_of_placement[draws if mask is None else draws & (mask != 0)]).tolist()
            for paint, member in named:
                arrays = (self._colors if member == "color" else self._numbers)[paint]
                for origin in (snapshot.origins[i] for i in drawn):
                    if arrays[origin.surface] is None:
                        key = paint, member, self._bare[origin.surface]
                        lacking.setdefault(key, set()).add(origin.object)
        return [_remark(*key, sorted(lacking[key])) for key in sorted(lacking)]


def _remark(paint, member, bare, names):
    """A sentence about objects that lack a Paint. `bare`: because what they are has none."""
    what = "vertex group" if paint.source == "vertex_group" else "float or color attribute of points or face corners"
    more = f" and {len(names) - SHOWN} more" if len(names) > SHOWN else ""
    objects = ", ".join(f"'{name}'" for name in names[:SHOWN]) + more
    own = f"the {member} of lines is the pen's own"
    if bare:
        return (
            f"{objects}: repaired meshes, hair and points are not painted, so {own}: choose Material or Object for it"
        )
    return f"{objects}: no {what} is named '{paint.name}', so {own}: add it to the mesh, or choose another for the pen"


def _numbers(paint, corners):
    """What a mesh has of a named Paint at its corners; None without, and without `corners`."""
    if corners is None or not paint.name:
        return None
    return corners.values(paint.name) if paint.source == "attribute" else corners.weights(paint.name)


def _colors(paint, corners):
    """The same as colors; numbers are grays."""
    if corners is not None and paint.source == "attribute":
        return corners.colors(paint.name)
    weights = _numbers(paint, corners)
    return None if weights is None else np.repeat(weights[:, None], 3, axis=1)


def _placed(arrays, snapshot, of_origins):
    """{Paint: n arrays} of placements. `arrays`: {Paint: an array per surface}, but of objects, which have one per
    origin."""
    surfaces, origins = snapshot.surface_of_placement.tolist(), snapshot.origin_of_placement.tolist()
    return {
        tuple(paint): [of_origins[i] for i in origins] if paint.source == "object" else [found[i] for i in surfaces]
        for paint, found in arrays.items()
    }


def _mean(colors):
    return colors.mean(axis=-1)
