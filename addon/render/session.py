# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders, and what they share with viewports: what is kept between pictures, and what the user hears when one cannot
be drawn.

Surfaces are kept per kind of depsgraph (final renders and viewports may hold different meshes and run side by side) and
told apart by content.
"""

import logging
import threading
import time
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial

import bpy
import numpy as np
from bpy.app.handlers import persistent

from .. import catalogue, native, pipeline, style
from ..scene import camera, color_sources, kept, notes, scene, surfaces
from ..scene.problem import CannotDraw
from . import methods, near_frames, properties

_log = logging.getLogger(__package__)
_caches = {}  # depsgraph mode -> SurfaceCache
_color_caches = {}  # depsgraph mode -> ColorCache
_statistics = {}
_remarked = set()  # what has been said of styles

REMARKS = {  # what a surface's report counts
    "non_finite_vertices": "vertices have no position and were left out",
    "degenerate_polygons": "faces have no area and were left out",
    "duplicate_polygons": "faces repeat others and were left out",
    "loose_edges": "edges belong to no face and have no lines",
    "inconsistent_edges": "edges lie between faces that disagree about which side is out",
}


def last_statistics():
    """Of the last picture: stages {name: ms}, backend, visibility (the method in words), strokes, triangles, curvature
    {object: how it was estimated, and why; where a line needed it}, and lines_s: the seconds from Blender's evaluated
    meshes (reading them and building what rays need included) to visible runs."""
    return dict(_statistics)


def register_passes(engine, scene_, layer):
    engine.register_pass(scene_, layer, "Combined", 4, "RGBA", "COLOR")
    engine.register_pass(scene_, layer, "Lines", 4, "RGBA", "COLOR")
    chosen = _style_of(scene_)
    if chosen and chosen.has_color():
        engine.register_pass(scene_, layer, "Colour", 4, "RGBA", "COLOR")
    if chosen and chosen.focus.active():
        engine.register_pass(scene_, layer, "Focus", 1, "X", "VALUE")
    if layer.use_pass_z:
        engine.register_pass(scene_, layer, "Depth", 1, "Z", "VALUE")


def _style_of(scene_):
    """A scene's Style; None where there is none: drawing will say what is wrong."""
    try:
        return properties.style_of(scene_)
    except (native.Unavailable, style.StyleError):
        return None


def render(engine, depsgraph):
    """Draws one view layer of a final render. Without a result Blender writes no file."""
    what = f"a picture of {engine.resolution_x} x {engine.resolution_y} pixels"
    with reported(lambda message: engine.report({"ERROR"}, message), what):
        image = final_image(engine, depsgraph)
        if image is not None:
            passes = {"Combined": image.combined, "Lines": image.lines, "Depth": image.depth}
            passes |= {"Colour": image.color, "Focus": image.focus}
            del image
            _hand_over(engine, depsgraph.view_layer, passes)
        kept.trim()


@contextmanager
def reported(tell, what="this view"):
    """Turns what goes wrong while `what` is drawn into one sentence for the user."""
    try:
        yield
    except (CannotDraw, native.Unavailable, style.StyleError) as problem:
        tell(str(problem))
    except MemoryError:  # numpy's, and std::bad_alloc of the native module
        tell(f"Memory is too small for {what}: make it smaller, or hide or simplify the largest objects")
    except Exception as error:
        _log.exception("drawing failed")
        tell(f"Fovea could not draw this: {type(error).__name__}: {error}")


@dataclass(frozen=True)
class Gathered:
    """A scene as it is drawn, whatever the view; nothing in it is Blender's."""

    snapshot: scene.Snapshot
    placed: object  # native Scene
    colors: object  # ColorSources, or None where there is no colour layer to draw
    notes: object  # stages.Notes
    changed: bool  # surfaces were made or moved for it
    seconds: float  # that reading it took


def gather(engine, depsgraph, chosen, viewport=None, with_colors=True):
    """Reads what a Style draws of the depsgraph's scene. `viewport`: its SpaceView3D; None for a final render."""
    start, core = time.perf_counter(), native.load()
    cache = _caches.setdefault(depsgraph.mode, surfaces.SurfaceCache(core, refit=depsgraph.mode == "VIEWPORT"))
    with_marks = catalogue.read_edge_marks(chosen.line_sets)
    colors_cache = _color_caches.setdefault(depsgraph.mode, color_sources.ColorCache(core))
    colors = color_sources.Gathering(core, colors_cache) if with_colors and chosen.has_color() else None
    noted = notes.Gathering(core, colors_cache, chosen)
    beside = {"colors": colors, "notes": noted}
    snapshot = scene.gather(depsgraph, cache, with_marks=with_marks, viewport=viewport, **beside)
    if not snapshot.surfaces and not scene.has_anything(depsgraph.scene):
        raise CannotDraw("The scene is empty: there is nothing that has lines")
    placed = scene.placed(core, snapshot)
    sources = colors and colors.sources(depsgraph.scene, snapshot.surface_of_placement)
    told = noted.notes(properties.density_map(depsgraph.scene_eval), snapshot)
    seconds = time.perf_counter() - start

    _report_skipped(engine, cache.rebuilt, cache.remarks)
    _report_unknown(engine, chosen)
    kept.trim()
    if colors and (remark := colors.remark()):
        engine.report({"INFO"}, remark)
    return Gathered(snapshot, placed, sources, told, bool(cache.rebuilt or cache.moved), seconds)


def draw(found, seen, chosen, backend, options, progress, cancel, near=None):
    """The Image of what was Gathered as a native View sees it; touches nothing of Blender's unless the backend does.
    `near`: the lines of the frames around it, for elision smoothed in time."""
    beside = {"colors": found.colors, "notes": found.notes, "near": near}
    return pipeline.draw(found.placed, seen, chosen, backend, options, **beside, progress=progress, cancel=cancel)


def final_image(engine, depsgraph, **how):
    """The Image of a final render of the depsgraph's scene, or None when the user stopped it; `how` as for `final`."""
    made = final(engine, depsgraph, **how)
    if made:
        note_statistics(*made)
    return made and made[1]


def final(engine, depsgraph, make=draw, *, lines_alone=False, tell=None):
    """What is Gathered for a final render of the depsgraph's scene, what `make` makes of it (arguments as those of
    `draw`), and the seconds that other frames took; or None when the user stopped it. `lines_alone`: without what is
    under them, focus and depth. `tell(share, stage)` hears how far it is; None: Blender does."""
    view, tell = camera.of_render(engine, depsgraph), tell or partial(_progress, engine)
    core, settings, chosen = native.load(), depsgraph.scene.fovea, properties.style_of(depsgraph.scene_eval)
    backend, visibility = methods.choose(engine, settings, in_viewport=False)
    asked = {} if lines_alone else {"with_depth": depsgraph.view_layer.use_pass_z, "with_focus": True}
    options = pipeline.options(visibility=visibility, **asked, **methods.quality(settings))
    cancel = core.Cancel()
    with _watched(engine, cancel):
        try:
            start = time.perf_counter()
            near = lines_near(engine, depsgraph, chosen, backend, options, cancel)
            near_s = time.perf_counter() - start if near else 0.0
            # After the others: surfaces that move are as they were gathered last.
            found = gather(engine, depsgraph, chosen, with_colors=not lines_alone)
            return found, make(found, scene.seen(core, view), chosen, backend, options, tell, cancel, near), near_s
        except core.Cancelled:
            return None


def lines_near(engine, depsgraph, chosen, backend, options, cancel=None):
    """What elision smoothed in time needs to know of the frames around a final render's, if the Style wants it."""
    frames = pipeline.frames_near(chosen, options)
    look = partial(_shown_lines, engine, depsgraph, backend, options, cancel)
    return near_frames.shown_lines(engine, depsgraph, frames, look) if frames else {}


def _shown_lines(engine, depsgraph, backend, options, cancel):
    """What elision leaves of the lines of the frame at which a final render's depsgraph is now, in its own style."""
    chosen = properties.style_of(depsgraph.scene_eval)  # only this has what is keyed as it is at that frame
    found = gather(engine, depsgraph, chosen, with_colors=False)
    seen = scene.seen(native.load(), camera.of_render(engine, depsgraph))

    def progress(_, stage):
        engine.update_stats("Fovea", f"frame {depsgraph.scene.frame_current}: {stage}")

    beside = {"notes": found.notes, "progress": progress, "cancel": cancel}
    frame = pipeline.frame(found.placed, seen, chosen, backend, options, **beside)
    return frame.shown_lines() if frame.thins() else None


@contextmanager
def _watched(engine, cancel):
    """Stops what runs natively soon after the user asks for it."""
    done = threading.Event()

    def watch():
        while not done.wait(0.05):
            if engine.test_break():
                cancel.cancel()
                return

    thread = threading.Thread(target=watch, daemon=True)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()


def _progress(engine, share, text):
    engine.update_progress(share)
    engine.update_stats("Fovea", text)


def _report_skipped(engine, built, remarks=()):
    """Says once per mesh what of it was left out or looks wrong."""
    for sentence in remarks:
        engine.report({"INFO"}, sentence)
    for surface in built:
        if found := remark(surface):
            engine.report({"INFO"}, found)


def remark(surface):
    """One sentence about what of a native Surface was left out or looks wrong, or None."""
    found = [f"{count} {words}" for what, words in REMARKS.items() if (count := getattr(surface.report, what))]
    return f"'{surface.name}': {'; '.join(found)}" if found else None


def _report_unknown(engine, chosen):
    """Says once what a style has that nothing here reads."""
    remark = style.remark(chosen)
    if remark and remark not in _remarked:
        _remarked.add(remark)
        engine.report({"INFO"}, remark)


def note_statistics(found, image, near_s=0.0):
    """Keeps what `last_statistics` tells of the Image of what was Gathered. `near_s`: the seconds that other frames
    took, if any were asked."""
    snapshot, stages = found.snapshot, {"ingest": 1000 * found.seconds, **image.statistics["stages"]}
    if near_s:
        stages["near_frames"] = 1000 * near_s
    names = list(stages)
    until_runs = names[: names.index("visibility") + 1]
    reasons = [surface.fields_reason for surface in snapshot.surfaces]
    placed = zip(snapshot.objects, snapshot.surface_of_placement)
    _statistics.clear()
    _statistics.update(
        curvature={name: reasons[i] for name, i in placed if reasons[i]},
        stages=stages,
        strokes=image.statistics["strokes"],
        backend=image.statistics["backend"],
        visibility=image.statistics["visibility"],
        triangles=sum(len(snapshot.surfaces[i].triangles) for i in snapshot.surface_of_placement),
        lines_s=sum(stages[name] for name in until_runs) / 1000,
    )


def _hand_over(engine, layer, passes):
    """Gives the passes {name: (H, W) or (H, W, 4)} of one view layer to Blender. Empties the dict as it goes: Blender
    holds each pass twice until it has merged them."""
    engine.add_pass("Lines", 4, "RGBA", layer=layer.name)
    if passes["Colour"] is not None:
        engine.add_pass("Colour", 4, "RGBA", layer=layer.name)
    if passes["Focus"] is not None:
        engine.add_pass("Focus", 1, "X", layer=layer.name)
    if layer.use_pass_z:
        engine.add_pass("Depth", 1, "Z", layer=layer.name)
    height, width = passes["Combined"].shape[:2]
    result = engine.begin_result(0, 0, width, height, layer=layer.name, view=engine.active_view_get())
    for render_pass in result.layers[0].passes:
        pixels = passes.pop(render_pass.name, None)
        if pixels is not None:
            render_pass.rect.foreach_set(np.ascontiguousarray(pixels, np.float32).ravel())
    del pixels
    engine.end_result(result)


@persistent
def _forget(*_arguments):
    """Another file: nothing that is kept belongs to it."""
    _caches.clear()
    _color_caches.clear()
    _statistics.clear()
    _remarked.clear()


def register():
    bpy.app.handlers.load_pre.append(_forget)


def unregister():
    bpy.app.handlers.load_pre.remove(_forget)
    _forget()
