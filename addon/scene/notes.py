# SPDX-License-Identifier: GPL-3.0-or-later
"""Per-placement overrides: priorities, what is painted, the density map, and filters of lines."""

import numpy as np

from . import line_filters, painted


class Gathering(painted.Gathering):
    """Collects what is painted during the traversal of a scene, and makes the overrides."""

    def notes(self, image, snapshot):
        """The native Overrides of a Snapshot's placements, and a list of sentences about what is not painted. `image`:
        the density map (bpy.types.Image), or None."""
        filters = line_filters.of(self._core, self._line_sets, snapshot)
        made = self._core.Overrides(
            importance=snapshot.of_origins("importance", np.float32),
            objects=[origin.owners for origin in snapshot.origins],
            names=[origin.object for origin in snapshot.origins],
            objects_of_placement=snapshot.origin_of_placement,
            density_map=image and self._cache.images.texture(image),
            **self.arguments(snapshot),
            **filters,
        )
        return made, self.remarks(snapshot, filters["placements"])


def asked(style, image):
    """Key of everything in a style that the Overrides depend on, to be compared: what is painted, density map, filters.
    `image`: the density map (bpy.types.Image), or None."""
    return painted.asked(style), image and image.name_full, line_filters.asked(style.line_sets)
