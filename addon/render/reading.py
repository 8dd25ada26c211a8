# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene read for pictures, operators and overlays, as the depsgraph that they have holds it."""

import time
from dataclasses import dataclass

from .. import catalogue, native, pipeline, style
from ..scene import color_sources, notes, scene, surfaces
from . import properties


@dataclass(frozen=True)
class Read:
    """What a Style draws of a scene, whatever the view; nothing in it is Blender's."""

    snapshot: scene.Snapshot
    placed: object  # native Scene
    colors: object  # native ColorSources, or None where there is no color layer to draw
    notes: object  # native Overrides
    built: tuple  # native Surfaces that were made for it
    changed: bool  # surfaces were made or moved for it
    remarks: tuple  # sentences about what could not be taken as it is
    seconds: float  # that reading it took


class Reader:
    """Reads scenes; keeps what has not changed from one time to the next. `refit` as for a SurfaceCache."""

    def __init__(self, *, refit=False):
        core = native.load()
        self.surfaces, self.colors = surfaces.SurfaceCache(core, refit=refit), color_sources.ColorCache(core)

    def read(self, depsgraph, chosen, viewport=None, with_colors=False):
        """What a Style draws. `viewport`: the SpaceView3D whose local view counts, or None."""
        start, core, cache = time.perf_counter(), native.load(), self.surfaces
        with_marks = catalogue.read_edge_marks(chosen.line_sets)
        colors = color_sources.Gathering(core, self.colors) if with_colors and chosen.has_color() else None
        noted = notes.Gathering(core, self.colors, chosen)
        beside = {"colors": colors, "notes": noted}
        found = scene.gather(depsgraph, cache, with_marks=with_marks, viewport=viewport, **beside)
        placed, told = scene.placed(core, found), noted.notes(properties.density_map(depsgraph.scene_eval), found)
        sources = colors and colors.sources(depsgraph.scene, found.surface_of_placement)
        remarks = (*cache.remarks, *(colors.remarks() if colors else ()))
        seconds = time.perf_counter() - start
        changed = bool(cache.rebuilt or cache.moved)
        return Read(found, placed, sources, told, tuple(cache.rebuilt), changed, remarks, seconds)


def focus_of_pixels(read, view, focus, scale):
    """(H, W) float32 in [0, 1]: focus of what each pixel of a View shows, at `scale` of its size; or None: all is in
    focus. `read`: what was Read, None where focus is a place in the image."""
    seen = scene.seen(native.load(), view).smaller(scale)
    placed, noted = (read.placed, read.notes) if read else (None, None)
    chosen = style.Style(focus=focus)
    return pipeline.frame(placed, seen, chosen, None, pipeline.options(), notes=noted).focus_of_pixels()
