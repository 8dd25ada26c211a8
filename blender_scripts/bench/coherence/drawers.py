# SPDX-License-Identifier: GPL-3.0-or-later
"""The renderers whose strokes are measured, each set to draw the same lines; see bench/renderers.py. Each is made once
per scene: `lines(lines)` chooses what is drawn, `frame()` draws, `polylines(view)` are the Strokes of that frame, and
`trace()` is a hash of all that was drawn. Runs inside Blender."""

import hashlib
from pathlib import Path

import bpy
import numpy as np
from bl_ext.user_default.fovea import pipeline

from .. import renderers
from ..focus.world import kept_results
from . import BAKED, PERIOD
from .measures import MIDDLE
from .strokes import Strokes, arc_from_start, divided, mixed

STEP = 4.0  # pixels between points of a line, as between places on it (native/fovea/stroke/anchor.cpp)
DASHES = 8  # lengths of the dashes' texture in widths of the pen
REFERENCE = 1080  # pixels of the height that a pen's width is given for
OF_OBJECTS = 2  # planes of hatching


class Fovea(renderers.Fovea):
    def __init__(self, scene, anchor, window=0, marks=0):
        super().__init__(scene)
        self.anchor, self.window, self.marks = anchor, window, marks
        self.kept, self.image, self.dashed = None, None, True

    def lines(self, lines):
        from bl_ext.user_default.fovea.style import style_data

        scene = bpy.context.scene
        held = style_data.use(scene, "plain")
        style_data.choose_lines(held, lines.kinds)
        held.elision.enabled = False
        self.dashed = lines.dashed
        held.animation.visibility_frames = self.window
        if self.marks != BAKED:
            held.animation.marks_frames = self.marks
        for line_set in held.line_sets:
            line_set.kinds.crease_angle, line_set.kinds.hatching_planes = renderers.CREASE, OF_OBJECTS
            pen = line_set.pen
            pen.cap, pen.taper = "BUTT", 0.0
            if not self.dashed:
                continue
            pen.width = PERIOD / DASHES * REFERENCE / scene.render.resolution_y
            pen.texture, pen.texture_anchor = "dashes", self.anchor.upper()
        if self.marks == BAKED:
            held.animation.marks_baked = True
            bpy.ops.wm.save_as_mainfile(filepath=str(Path(bpy.app.tempdir) / "shot.blend"))
            bpy.ops.fovea.bake_marks()

    def frame(self):
        frames, images = [], []
        with kept_results(pipeline, "frame", frames), kept_results(pipeline, "draw", images):
            super().frame()
        self.kept, self.image = frames[-1], images[-1].combined

    def polylines(self, view):
        found = self.kept.polylines(drawn=True)
        drawn = np.asarray(found.invisibility) == 0
        sizes = np.diff(found.offsets)
        inside = np.repeat(drawn, sizes)
        offsets = np.concatenate([[0], np.cumsum(sizes[drawn])]).astype(np.int64)
        arc, px = np.asarray(found.arc_px)[inside], np.asarray(found.px)[inside]
        position = np.asarray(found.position_view, np.float64)[inside]
        # Places on a path are not linear in the image.
        offsets, point, t, s = divided(offsets, px, view.depth(position), STEP)
        arc, px, position = mixed(arc, point, t), mixed(px, point, t), mixed(position, point, s)
        piece = np.repeat(np.asarray(found.piece)[drawn], np.diff(offsets))
        strokes = self.kept.strokes
        opacity, *anchored = self.drawn_at(piece, arc, [np.asarray(strokes.opacity), *np.asarray(strokes.anchor).T])
        along, whole = arc / PERIOD, np.full(len(arc), float(PERIOD))
        fixed = self.dashed and self.anchor == "path"
        if not self.dashed:
            along = np.full(len(arc), MIDDLE)
        elif fixed:
            along, whole = anchored
        depth, lines = view.depth(position), len(self.kept.paths.ids)
        return Strokes(offsets, px, view.to_world(position), depth, along, whole, fixed, opacity, lines)

    def drawn_at(self, piece, arc, columns):
        """What columns of the drawn strokes have at arc lengths of pieces."""
        strokes = self.kept.strokes
        own, u = np.asarray(strokes.piece, np.float64), np.asarray(strokes.arc[:, 0], np.float64)
        if not len(own):  # there is no such line
            return [np.zeros(len(piece)) for _ in columns]
        reach = 2 * max(np.abs(u).max(initial=0), np.abs(arc).max(initial=0)) + 1
        axis = own * reach + u
        order = np.argsort(axis, kind="stable")
        return (np.interp(piece * reach + arc, axis[order], column[order]) for column in columns)

    def trace(self):
        return hashed(self.image)


class LineArt(renderers.LineArt):
    def lines(self, lines):
        self.modifier.use_contour = "contour" in lines.kinds  # includes the borders
        self.modifier.use_crease = "crease" in lines.kinds
        self.modifier.show_viewport = False
        bpy.context.view_layer.update()

    def polylines(self, view):
        drawn = self.drawer.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.layers[0].current_frame()
        count = len(drawn.drawing.strokes) if drawn else 0
        if not count:
            return from_start(np.zeros(1, np.int64), np.zeros((0, 3)), view)
        offsets = np.empty(count + 1, np.int32)
        drawn.drawing.curve_offsets.foreach_get("value", offsets)
        world = np.empty((offsets[-1], 3), np.float32)
        drawn.drawing.attributes["position"].data.foreach_get("vector", world.ravel())
        return from_start(offsets.astype(np.int64), world.astype(np.float64), view)


class Freestyle(renderers.Freestyle):
    """Its strokes are taken before it makes meshes of them, so that nothing of them is rendered. Its silhouettes cross
    faces that are shaded smooth if it is to take that into account."""

    def lines(self, lines):
        settings = bpy.context.view_layer.freestyle_settings
        settings.use_smoothness = "smooth_contour" in lines.kinds
        kinds = {"silhouette" if kind.endswith("contour") else kind for kind in lines.kinds}
        for kind in self.kinds:
            setattr(settings.linesets[0], f"select_{kind}", kind in kinds)

    def frame(self):
        self.found = None
        super().frame()
        if self.found is None:  # as of smooth silhouettes in 4.3, where meshes have borders
            raise RuntimeError("this Blender's Freestyle fails on these lines")

    def count(self, *arguments):
        from freestyle.types import Operators

        super().count(*arguments)
        self.found = [
            [tuple(vertex.point_3d) for vertex in Operators.get_stroke_from_index(i)]
            for i in range(Operators.get_strokes_size())
        ]
        Operators.reset(delete_strokes=True)

    def polylines(self, view):
        offsets = np.concatenate([[0], np.cumsum([len(stroke) for stroke in self.found])]).astype(np.int64)
        points = np.array([point for stroke in self.found for point in stroke], float).reshape(-1, 3)
        return from_start(offsets, view.to_world(points), view)


def from_start(offsets, world, view):
    """Strokes whose dashes begin at each one's start."""
    px, depth = view.to_pixels(world)
    along = arc_from_start(px, offsets) / PERIOD if len(px) else np.zeros(0)
    return Strokes(offsets, px, world, depth, along, np.full(len(px), float(PERIOD)), False, np.ones(len(px)))


def hashed(*arrays):
    found = hashlib.sha256()
    for array in arrays:
        found.update(np.ascontiguousarray(array).tobytes())
    return found.hexdigest()


def make(name, scene, anchor, window, marks):
    if name == "fovea":
        return Fovea(scene, anchor, window, marks)
    return {"line_art": LineArt, "freestyle": Freestyle}[name](scene)
