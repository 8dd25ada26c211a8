# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene read for operators and overlays, as the depsgraph that they have holds it."""

from dataclasses import dataclass

from .. import catalogue, native, pipeline, style
from ..scene import color_sources, notes, scene, surfaces
from ..stages import Notes
from . import properties


@dataclass(frozen=True)
class Read:
    """What a Style draws of a scene; nothing in it is Blender's."""

    snapshot: scene.Snapshot
    placed: object  # native Scene
    notes: Notes
    remarks: tuple  # sentences about meshes that could not be taken as they are


class Reader:
    """Reads scenes; keeps what has not changed from one time to the next."""

    def __init__(self):
        core = native.load()
        self._surfaces, self._colors = surfaces.SurfaceCache(core), color_sources.ColorCache(core)

    def read(self, depsgraph, chosen, viewport=None):
        """`viewport`: the SpaceView3D whose local view counts, or None."""
        core = native.load()
        with_marks = catalogue.read_edge_marks(chosen.line_sets)
        noted = notes.Gathering(core, self._colors, chosen)
        found = scene.gather(depsgraph, self._surfaces, with_marks=with_marks, viewport=viewport, notes=noted)
        placed, told = scene.placed(core, found), noted.notes(properties.density_map(depsgraph.scene_eval), found)
        return Read(found, placed, told, tuple(self._surfaces.remarks))


def focus_of_pixels(read, view, focus, scale):
    """(H, W) float32 in [0, 1]: focus of what each pixel of a View shows, at `scale` of its size; or None: all is in
    focus. `read`: what was Read, None where focus is a place in the image."""
    seen = scene.seen(native.load(), view).smaller(scale)
    placed, noted = (read.placed, read.notes) if read else (None, Notes())
    chosen = style.Style(focus=focus)
    return pipeline.frame(placed, seen, chosen, None, pipeline.options(), notes=noted).focus_of_pixels()
