# SPDX-License-Identifier: GPL-3.0-or-later
"""What the artist has said of a scene's placements: priorities, what is painted on meshes, a map of density, and which
lines they have."""

from . import line_filters
from .color_corners import Corners


class Gathering:
    """What is painted, as a scene is walked over: for each attribute that a style names one entry per native surface,
    in the scene's order."""

    def __init__(self, core, cache, style):
        self._core, self._cache, self._line_sets = core, cache, style.line_sets
        self._painted = {name: [] for name in attributes(style)}

    def add_surface(self, obj, mesh, surface, cage, repaired):
        """As color_sources.Gathering has it. A repaired mesh's corners are no longer those that were painted."""
        corners = None
        if not repaired and len(mesh.loops):
            corners = Corners(self._core, obj, mesh, surface, cage, self._cache.refined)
        for name, found in self._painted.items():
            found.append(corners and corners.values(name))

    def notes(self, image, snapshot):
        """The native Overrides of a Snapshot's placements; `image`: Blender's, of the density, or None."""
        surfaces = snapshot.surface_of_placement
        painted = {name: [values[i] for i in surfaces] for name, values in self._painted.items()}
        return self._core.Overrides(
            importance=snapshot.importance,
            painted=painted,
            objects=snapshot.owners,
            density_map=image and self._cache.images.texture(image),
            **line_filters.of(self._core, self._line_sets, snapshot),
        )


def attributes(style):
    """Names of the attributes that a Style asks for."""
    wanted = {style.focus.attribute}
    if style.elision.enabled:
        wanted |= {style.elision.priority_attribute, style.elision.density_attribute}
    return sorted(wanted - {""})


def asked(style, image):
    """What is asked of a scene besides what its objects and materials say; where this is the same, so are the notes.
    `image`: Blender's, of the density, or None."""
    return attributes(style), image and image.name_full, line_filters.asked(style.line_sets)
