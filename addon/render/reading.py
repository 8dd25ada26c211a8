# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the scene of a depsgraph for pictures, operators and overlays."""

import time
from dataclasses import dataclass

from .. import catalogue, native, pipeline, style
from ..scene import color_sources, notes, scene, snapshot, surfaces
from . import properties


@dataclass(frozen=True)
class Read:
    """Everything that a Style draws of a scene, independent of the view; references no Blender data."""

    snapshot: snapshot.Snapshot
    placed: object  # native Scene
    colors: object  # native ColorSources, or None without a color layer
    notes: object  # native Overrides
    built: tuple  # native Surfaces built in this read
    changed: bool  # whether surfaces were built or moved in this read
    remarks: tuple  # sentences about data that could not be used as it is
    seconds: float  # duration of the read


class Reader:
    """Reads scenes and caches surfaces and colors between reads. `refit` as for a SurfaceCache."""

    def __init__(self, *, refit=False):
        core = native.load()
        self.surfaces, self.colors = surfaces.SurfaceCache(core, refit=refit), color_sources.ColorCache(core)

    def read(self, depsgraph, chosen, viewport=None, with_colors=False, cancel=None):
        """The Read of a depsgraph for a Style. `viewport`: the SpaceView3D whose local view applies, or None. `cancel`:
        a native Cancel that is polled, or None."""
        start, core, cache = time.perf_counter(), native.load(), self.surfaces
        with_marks = catalogue.read_edge_marks(chosen.line_sets)
        colors = color_sources.Gathering(core, self.colors) if with_colors and chosen.has_color() else None
        noted = notes.Gathering(core, self.colors, chosen)
        self.colors.weights.begin(depsgraph)
        with native.refusals():
            ahead = core.Ahead(chosen, cancel)
        with ahead:
            beside = {"colors": colors, "notes": noted, "cancel": cancel, "ahead": ahead}
            found = scene.gather(
                depsgraph, cache, with_marks=with_marks, viewport=viewport, images=self.colors.images, **beside
            )
            placed = scene.placed(core, found)
            told, unpainted = noted.notes(properties.density_map(depsgraph), found)
            sources = colors and colors.sources(depsgraph.scene, found)
        remarks = (*cache.remarks, *unpainted, *(colors.remarks() if colors else ()))
        seconds = time.perf_counter() - start
        changed = bool(cache.rebuilt or cache.moved)
        return Read(found, placed, sources, told, tuple(cache.rebuilt), changed, remarks, seconds)


def focus_of_pixels(read, view, focus, scale):
    """(H, W) float32 in [0, 1]: focus (0: in focus) of the surface at each pixel of a View, at `scale` times its
    resolution; None if everything is in focus. `read`: the Read scene; None if the focus is a place in the image."""
    seen = scene.seen(native.load(), view).smaller(scale)
    placed, noted = (read.placed, read.notes) if read else (None, None)
    chosen = style.Style(focus=focus)
    return pipeline.frame(placed, seen, chosen, None, pipeline.options(), notes=noted).focus_of_pixels()
