# SPDX-License-Identifier: GPL-3.0-or-later
"""Per-placement overrides: priorities, painted attributes, the density map, and filters of lines."""

import numpy as np

from . import line_filters
from .color_corners import Corners


class Gathering:
    """Collects painted attributes during the traversal of a scene: for each attribute that the style names, one entry
    per native surface, in order."""

    def __init__(self, core, cache, style):
        self._core, self._cache, self._line_sets = core, cache, style.line_sets
        self._painted = {name: [] for name in attributes(style)}

    def add_surface(self, obj, mesh, surface, cage, repaired):
        """Adds a surface; arguments as in color_sources.Gathering. A repaired surface gets None, as its corners are not
        those of the painted mesh."""
        corners = None
        if not repaired and len(mesh.loops):
            corners = Corners(self._core, obj, mesh, surface, cage, self._cache.refined)
        for name, found in self._painted.items():
            found.append(corners and corners.values(name))

    def notes(self, image, snapshot):
        """The native Overrides of a Snapshot's placements. `image`: the density map (bpy.types.Image), or None."""
        surfaces = snapshot.surface_of_placement.tolist()
        painted = {name: [values[i] for i in surfaces] for name, values in self._painted.items()}
        return self._core.Overrides(
            importance=snapshot.of_origins("importance", np.float32),
            painted=painted,
            objects=[origin.owners for origin in snapshot.origins],
            names=[origin.object for origin in snapshot.origins],
            objects_of_placement=snapshot.origin_of_placement,
            density_map=image and self._cache.images.texture(image),
            **line_filters.of(self._core, self._line_sets, snapshot),
        )


def attributes(style):
    """Names of the painted attributes that a Style uses."""
    wanted = {style.focus.attribute}
    if style.elision.enabled:
        wanted |= {style.elision.priority_attribute, style.elision.density_attribute}
    return sorted(wanted - {""})


def asked(style, image):
    """Key of everything in a style that the Overrides depend on, to be compared: attributes, density map, filters.
    `image`: the density map (bpy.types.Image), or None."""
    return attributes(style), image and image.name_full, line_filters.asked(style.line_sets)
