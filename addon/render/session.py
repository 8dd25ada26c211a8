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
from functools import partial

import numpy as np

from .. import native, pipeline, style
from ..scene import camera, kept, scene, surfaces
from ..scene.operator import TOLD
from ..scene.problem import CannotDraw
from . import methods, near_frames, properties, reading

_log = logging.getLogger(__package__)
readers = {}  # depsgraph mode -> Reader
_statistics = {}
_remarked = set()  # what has been said of styles

PASSES = {  # besides the picture: channels, their names and kind
    "Lines": (4, "RGBA", "COLOR"),
    "Color": (4, "RGBA", "COLOR"),
    "Focus": (1, "X", "VALUE"),
    "Depth": (1, "Z", "VALUE"),
}


def last_statistics():
    """Of the last picture: stages {name: ms}, backend, visibility (the method in words), strokes, triangles, curvature
    {object: how it was estimated, and why; where a line needed it}, and lines_s: the seconds from Blender's evaluated
    meshes (reading them and building what rays need included) to visible runs."""
    return dict(_statistics)


def register_passes(engine, scene_, layer):
    chosen = _style_of(scene_)
    wanted = {
        "Lines": True,
        "Color": chosen and chosen.has_color(),
        "Focus": chosen and chosen.focus.active(),
        "Depth": layer.use_pass_z,
    }
    engine.register_pass(scene_, layer, "Combined", 4, "RGBA", "COLOR")
    for name, channels in PASSES.items():
        if wanted[name]:
            engine.register_pass(scene_, layer, name, *channels)


def _style_of(scene_):
    """A scene's Style; None where there is none: drawing will say what is wrong."""
    try:
        return properties.style_of(scene_)
    except TOLD:
        return None


def render(engine, depsgraph):
    """Draws one view layer of a final render. Without a result Blender writes no file."""
    what = f"a picture of {engine.resolution_x} x {engine.resolution_y} pixels"
    with reported(lambda message: engine.report({"ERROR"}, message), what):
        image = final_image(engine, depsgraph)
        if image is not None:
            passes = {"Combined": image.combined, "Lines": image.lines, "Depth": image.depth}
            passes |= {"Color": image.color, "Focus": image.focus}
            del image
            _hand_over(engine, depsgraph.view_layer, passes)
        kept.trim()


@contextmanager
def reported(tell, what="this view"):
    """Turns what goes wrong while `what` is drawn into one sentence for the user."""
    try:
        yield
    except TOLD as problem:
        tell(str(problem))
    except MemoryError:  # numpy's, and std::bad_alloc of the native module
        tell(f"Memory is too small for {what}: make it smaller, or hide or simplify the largest objects")
    except Exception as error:
        _log.exception("drawing failed")
        tell(f"Fovea could not draw this: {type(error).__name__}: {error}")


def gather(engine, depsgraph, chosen, viewport=None, with_colors=True):
    """What is Read of the depsgraph's scene for a Style. `viewport`: its SpaceView3D; None for a final render."""
    if depsgraph.mode not in readers:
        readers[depsgraph.mode] = reading.Reader(refit=depsgraph.mode == "VIEWPORT")
    found = readers[depsgraph.mode].read(depsgraph, chosen, viewport, with_colors)
    if not found.snapshot.surfaces and not scene.has_anything(depsgraph.scene):
        raise CannotDraw("The scene is empty: there is nothing that has lines")
    report_skipped(engine, found.built, found.remarks)
    report_unknown(engine, chosen)
    kept.trim()
    return found


def draw(found, seen, chosen, backend, options, progress, cancel, near=None):
    """The Image of what was Read as a native View sees it; touches nothing of Blender's unless the backend does.
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
    """What is Read for a final render of the depsgraph's scene, what `make` makes of it (arguments as those of
    `draw`), and the seconds that other frames took; or None when the user stopped it. `lines_alone`: without what is
    under them, focus and depth. `tell(share, stage)` hears how far it is; None: Blender does."""
    view, tell = camera.of_render(engine, depsgraph), tell or partial(_progress, engine)
    core, settings, chosen = native.load(), depsgraph.scene.fovea, properties.style_of(depsgraph.scene_eval)
    backend, visibility = methods.choose(engine, settings, in_viewport=False)
    asked = {} if lines_alone else {"with_depth": depsgraph.view_layer.use_pass_z, "with_focus": True}
    options = pipeline.options(visibility=visibility, **asked, **methods.quality(settings))
    cancel = core.Cancel()
    with watched(engine, cancel):
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
def watched(engine, cancel):
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


def report_skipped(engine, built, remarks=()):
    """Says once per mesh what of it was left out or looks wrong."""
    for sentence in remarks:
        engine.report({"INFO"}, sentence)
    for surface in built:
        if found := surfaces.remark(surface.name, surface.report):
            engine.report({"INFO"}, found)


def report_unknown(engine, chosen):
    """Says once what a style has that nothing here reads."""
    remark = style.remark(chosen)
    if remark and remark not in _remarked:
        _remarked.add(remark)
        engine.report({"INFO"}, remark)


def note_statistics(found, image, near_s=0.0):
    """Keeps what `last_statistics` tells of the Image of what was Read. `near_s`: the seconds that other frames
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
    for name, (count, channels, _) in PASSES.items():
        if passes[name] is not None:
            engine.add_pass(name, count, channels, layer=layer.name)
    height, width = passes["Combined"].shape[:2]
    result = engine.begin_result(0, 0, width, height, layer=layer.name, view=engine.active_view_get())
    for render_pass in result.layers[0].passes:
        pixels = passes.pop(render_pass.name, None)
        if pixels is not None:
            render_pass.rect.foreach_set(np.ascontiguousarray(pixels, np.float32).ravel())
    del pixels
    engine.end_result(result)


def forget():
    """Another file: nothing that is kept belongs to it."""
    readers.clear()
    _statistics.clear()
    _remarked.clear()
