# SPDX-License-Identifier: GPL-3.0-or-later
"""Final renders, and what they share with viewports: caches between pictures, statistics, and error messages.

Surfaces are cached per depsgraph mode (final renders and viewports may have different meshes and run concurrently) and
identified by content.
"""

import logging
import threading
import time
from contextlib import contextmanager
from dataclasses import replace
from functools import partial

import numpy as np

from .. import line_files, native, pipeline, style
from ..scene import camera, followed, kept, scene, surfaces
from ..scene.operator import TOLD
from ..scene.problem import CannotDraw
from ..style import freestyle
from . import (
    baked_marks,
    holds,
    lines_scenes,
    methods,
    motion_blur,
    near_frames,
    passes,
    properties,
    reading,
    stage_labels,
)

_log = logging.getLogger(__package__)
readers = {}  # depsgraph mode -> Reader
NOT_BAKED = "Frames lack baked marks of their lines: marks are handed on from frames around them; Bake Marks bakes them"
_statistics, _remarked = {}, set()  # and remarks that were reported already


def last_statistics():
    """Statistics of the last picture: stages {name: ms}; backend; visibility, the method in words; strokes and
    triangles, counts; curvature {object: which estimator, and why}, only of objects whose curvature was needed; and
    lines_s, seconds from Blender's evaluated meshes to visible runs, including reading them and building the BVH."""
    return dict(_statistics)


def wanted_passes(scene_, layer):
    """{Pass: names that it has in renders of a view layer, or []}."""
    drawn = followed.of(scene_)
    chosen = _style_of(drawn)
    line_sets = properties.line_set_names(drawn) if chosen else ()
    return passes.wanted(layer, chosen, line_sets, followed.follows(scene_))


def register_passes(engine, scene_, layer):
    engine.register_pass(scene_, layer, "Combined", 4, "RGBA", "COLOR")
    for each, names in wanted_passes(scene_, layer).items():
        for name in names:
            engine.register_pass(scene_, layer, name, len(each.channels), each.channels, each.kind)


def _style_of(scene_):
    """A scene's Style; None on an error, which is reported when the scene is drawn."""
    try:
        return properties.style_of(scene_)
    except TOLD:
        return None


def render(engine, depsgraph, also=None):
    """Draws one view layer of a final render. On an error no result is passed on, so Blender writes no file. `also`: as
    for `pipeline.draw`."""
    report_once(engine, freestyle.OVER if freestyle.is_on(depsgraph.scene) else None)
    what = f"a picture of {engine.resolution_x} x {engine.resolution_y} pixels"
    if followed.follows(depsgraph.scene):
        lines_scenes.note(depsgraph.scene, None)

    def tell(message):
        engine.report({"ERROR"}, message)
        if followed.follows(depsgraph.scene):
            lines_scenes.note(depsgraph.scene, message)

    with reported(tell, what):
        if made := final(engine, depsgraph, make=partial(draw, also=also), in_time=True):
            note_statistics(*made)
            layer, objects = depsgraph.view_layer, made[0].snapshot.drawn
            filled = passes.filled(made[1], layer, properties.line_set_names(followed.of(depsgraph.scene)))
            del made
            _hand_over(engine, layer, filled)
            if layer.use_pass_cryptomatte_object:
                passes.tell_names(engine, layer, objects, native.load())
        kept.trim()


@contextmanager
def reported(tell, what="this view"):
    """Context that passes errors to tell(sentence) instead of raising them. `what`: what is drawn, for messages."""
    try:
        yield
    except TOLD as problem:
        tell(str(problem))
    except MemoryError:  # numpy's, and std::bad_alloc of the native module
        tell(f"Memory is too small for {what}: make it smaller, or hide or simplify the largest objects")
    except Exception as error:
        _log.exception("drawing failed")
        tell(f"Fovea could not draw this: {type(error).__name__}: {error}")


def gather(engine, depsgraph, chosen, viewport=None, with_colors=True, cancel=None):
    """The Read of the depsgraph's scene for a Style, reported and cached. `viewport`: its SpaceView3D; None for a final
    render. `cancel`: a native Cancel, or None. CannotDraw if the scene is empty."""
    if depsgraph.mode not in readers:
        readers[depsgraph.mode] = reading.Reader(refit=depsgraph.mode == "VIEWPORT")
    found = readers[depsgraph.mode].read(depsgraph, chosen, viewport, with_colors, cancel)
    if not found.snapshot.surfaces and not scene.has_anything(followed.of(depsgraph.scene)):
        raise CannotDraw("The scene is empty: there is nothing that has lines")
    report_skipped(engine, found.built, found.remarks)
    for remark in (style.remark(chosen), *line_files.remarks(chosen)):
        report_once(engine, remark)
    kept.trim()
    return found


def draw(found, seen, chosen, backend, options, progress, cancel, near=None, also=None, **in_time):
    """The Image of a Read scene in a native View; accesses no Blender data unless the backend does. `near`: a
    pipeline.Near, for lines that answer to frames near this one. `also`, `in_time`: as for `pipeline.draw`."""
    beside = {"colors": found.colors, "notes": found.notes, "near": near, "also": also, **in_time}
    return pipeline.draw(found.placed, seen, chosen, backend, options, **beside, progress=progress, cancel=cancel)


def final_image(engine, depsgraph, **how):
    """The Image of a final render of the depsgraph's scene, or None if the user canceled it; `how` as for `final`."""
    if made := final(engine, depsgraph, **how):
        note_statistics(*made)
    return made and made[1]


def final(engine, depsgraph, make=draw, *, chosen=None, lines_alone=False, in_time=False, tell=None):
    """(Read, result of `make`, seconds spent on other frames) for a final render of the depsgraph's scene, or None if
    the user canceled it. `make`: called with the arguments of `draw`; if `in_time`, with `exposure` where the scene has
    motion blur of lines, and with `poses` where it has line vectors. `chosen`: a Style in place of the scene's own.
    `lines_alone`: without colors and without passes but Lines. `tell(share, stage)` receives the progress; None:
    Blender's progress bar does."""
    core, settings, tell = native.load(), followed.of(depsgraph.scene).fovea, tell or partial(_progress, engine)
    styled = partial(properties.style_drawn, given=chosen)
    animation = styled(depsgraph).animation
    backend, visibility = methods.choose(engine, settings, in_viewport=False)
    report_once(engine, engine.note)
    asked = {} if lines_alone else passes.options(depsgraph.view_layer, followed.follows(depsgraph.scene))
    lines_alone = lines_alone or followed.follows(depsgraph.scene)
    options = pipeline.options(visibility=visibility, **asked, **methods.quality(settings))
    cancel = core.Cancel()
    drawn = options.replace(boil_drawing=animation.boil_drawing(depsgraph.scene.frame_current))
    exposed = in_time and motion_blur.is_on(depsgraph, animation)

    def read(chosen):
        near, others = lines_near(engine, depsgraph, styled, backend, options, cancel, moments=exposed), {}
        if exposed:
            look = partial(_moment, engine, depsgraph, styled, backend, drawn, cancel, near)
            others["exposure"] = motion_blur.exposure(engine, depsgraph, animation.motion_samples, look)
        if in_time and options.with_line_vector:
            others["poses"] = near_frames.beside(engine, depsgraph, partial(_pose, engine, depsgraph, styled, cancel))
        # After other frames, because cached surfaces have the positions of the frame gathered last.
        return near, others, gather(engine, depsgraph, chosen, with_colors=not lines_alone, cancel=cancel)

    with watched(engine, cancel), cancel:
        try:
            with holds.held(engine, depsgraph, animation):
                chosen, seen = styled(depsgraph), scene.seen(core, camera.of_render(engine, depsgraph))
                start = time.perf_counter()
                near, others, found = read(chosen)
                if near:
                    content = near_frames.content(found, seen, chosen, options, backend)
                    if near_frames.changed(engine, depsgraph, content):
                        near, others, found = read(chosen)
                    near = near_frames.with_itself(engine, depsgraph, near, content)
                other_s = time.perf_counter() - start - found.seconds if near or others else 0.0
            return found, make(found, seen, chosen, backend, drawn, tell, cancel, near, **others), other_s
        except core.Cancelled:
            return None


def lines_near(engine, depsgraph, styled, backend, options, cancel=None, moments=False):
    """The pipeline.Near of a final render, for lines that answer to frames near it; else None. `styled(depsgraph)`: its
    Style, with the animated values of the frame that it is evaluated at. `moments`: moments of it are drawn with it."""
    chosen, frame = styled(depsgraph), depsgraph.scene.frame_current
    look = partial(_look, engine, depsgraph, styled, backend, options, cancel)

    def near(**asked):
        offsets = pipeline.frames_near(chosen, options, frame, **asked)
        kept = pipeline.frames_near(chosen, options, frame)
        return near_frames.near(engine, depsgraph, offsets, look, kept) if offsets else None

    if chosen.animation.marks_baked and (found := near(itself=True, keys=False)):
        baked = baked_marks.of(followed.of(depsgraph.scene), depsgraph.view_layer, frame)
        lines = found.lines.get(0)
        if not lines or not lines.marks_content:
            return found
        if baked and lines.marks_content == baked[0] and len(lines.own_marks()) == len(baked[1]):
            return replace(found, marks=baked[1])
        report_once(engine, NOT_BAKED)
    found = near(itself=moments)
    return found and replace(found, since_key=chosen.animation.since_key(frame))


def lines_now(engine, depsgraph, styled, backend, options, cancel):
    """The native FoundLines of the frame that a final render's depsgraph is evaluated at; None if they do not answer to
    frames near it."""
    return _look(engine, depsgraph, styled, backend, options, cancel).found


def _look(engine, depsgraph, styled, backend, options, cancel):
    """The near_frames.Looked of the frame that a final render's depsgraph is evaluated at."""
    where = f"Frame {depsgraph.scene.frame_current}"
    content, frame = _frame_now(engine, depsgraph, styled, backend, options, cancel, where)
    return near_frames.Looked(content, frame.found_lines() if frame.answers() else None)


def _moment(engine, depsgraph, styled, backend, options, cancel, near, number):
    """(content, native Frame) of the moment of a final render's shutter that the depsgraph is evaluated at."""
    of_ink = options.replace(with_line_depth=False, with_line_vector=False, with_line_id=False, matte_ranks=0)
    return _frame_now(engine, depsgraph, styled, backend, of_ink, cancel, f"Moment {number}", near)


def _pose(engine, depsgraph, styled, cancel):
    """The native Pose of the frame that a final render's depsgraph is evaluated at."""
    _, found, seen = _read_now(engine, depsgraph, styled, cancel)
    return native.load().Pose(found.placed, seen)


def _read_now(engine, depsgraph, styled, cancel):
    """(Style, Read without colors, native View) of what a final render's depsgraph is evaluated at."""
    chosen = styled(depsgraph)
    found = gather(engine, depsgraph, chosen, with_colors=False, cancel=cancel)
    return chosen, found, scene.seen(native.load(), camera.of_render(engine, depsgraph))


def _frame_now(engine, depsgraph, styled, backend, options, cancel, where, near=None):
    """(content as of near_frames, native Frame without colors) of what a final render's depsgraph is evaluated at.
    `where`: what that is called in the header."""
    chosen, found, seen = _read_now(engine, depsgraph, styled, cancel)

    def progress(_, stage):
        stage_labels.show(engine, f"{where}: {stage_labels.label(stage)}")

    beside = {"notes": found.notes, "near": near, "progress": progress, "cancel": cancel}
    frame = pipeline.frame(found.placed, seen, chosen, backend, options, **beside)
    return near_frames.content(found, seen, chosen, options, backend), frame


@contextmanager
def watched(engine, cancel):
    """Context that cancels native work when the user cancels the render; polls every 50 ms in a thread."""
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
    stage_labels.show(engine, stage_labels.label(text))


def forget_weights(updates=None):
    """Forgets weights of vertex groups in viewports, as vertex_groups.Weights.forget does."""
    if "VIEWPORT" in readers:
        readers["VIEWPORT"].colors.weights.forget(updates)


def report_skipped(engine, built, remarks=()):
    """Reports remarks and, once per newly built surface, what of its mesh was left out or looks wrong."""
    for sentence in (*remarks, *surfaces.remarks(built)):
        engine.report({"INFO"}, sentence)


def report_once(engine, remark):
    """Reports a remark, unless it is None, empty, or was reported before."""
    if remark and remark not in _remarked:
        _remarked.add(remark)
        engine.report({"INFO"}, remark)


def note_statistics(found, image, other_s=0.0):
    """Stores the `last_statistics` of an Image and its Read. `other_s`: seconds spent on other frames, or 0."""
    snapshot, stages = found.snapshot, {"ingest": 1000 * found.seconds, **image.statistics["stages"]}
    if other_s:
        stages["near_frames"] = 1000 * other_s
    names = list(stages)
    until_runs = names[: names.index("visibility") + 1]
    reasons = [surface.fields_reason for surface in snapshot.surfaces]
    shapes = [rest or surface.known_shape for surface, rest in zip(snapshot.surfaces, snapshot.at_rest)]
    placed = [(origin.object, origin.surface) for origin in snapshot.origins]
    _statistics.clear()
    _statistics.update(
        curvature={name: reasons[i] for name, i in placed if reasons[i]},
        shape={name: shapes[i] for name, i in placed if shapes[i]},
        stages=stages,
        strokes=image.statistics["strokes"],
        backend=image.statistics["backend"],
        visibility=image.statistics["visibility"],
        triangles=snapshot.triangle_count,
        lines_s=sum(stages[name] for name in until_runs) / 1000,
    )


def _hand_over(engine, layer, filled):
    """Passes {name: (channels, pixels)} of one view layer to Blender: (H, W) or (H, W, 4). Empties the dict to save
    memory: Blender holds each pass twice until it has merged them."""
    height, width = filled["Combined"][1].shape[:2]
    for name, (channels, _) in filled.items():
        if name != "Combined":
            engine.add_pass(name, len(channels), channels, layer=layer.name)
    result = engine.begin_result(0, 0, width, height, layer=layer.name, view=engine.active_view_get())
    for render_pass in result.layers[0].passes:
        if render_pass.name in filled:
            _, pixels = filled.pop(render_pass.name)
            render_pass.rect.foreach_set(np.ascontiguousarray(pixels, np.float32).ravel())
            del pixels
    engine.end_result(result)


def forget():
    """Clears all caches, as another file is loaded."""
    readers.clear()
    near_frames.forget()
    _statistics.clear()
    _remarked.clear()
