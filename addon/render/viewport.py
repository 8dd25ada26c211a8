# SPDX-License-Identifier: GPL-3.0-or-later
"""A 3D viewport in Rendered shading: drawn within a time budget while something changes, refined when it rests.

The cpu backend draws in a thread (worker.py) from the scene as read, which is read again only when Blender reports a
relevant change (changes.py). A draw of the region waits a moment for its picture, then shows the last one;
caretaker.py redraws the region later. The gpu backend needs Blender's GPU context, so it draws synchronously.
"""

import time
import weakref

from .. import budget, line_files, moved_picture, native, pipeline
from ..gpu import program as gpu_program
from ..gpu import viewport as gpu_viewport
from ..scene import camera, scene
from . import caretaker, changes, methods, properties, session, stage_labels, worker, write_flag
from .wanted import Picture, Wanted, seen

WORD = 0.3  # seconds between progress messages in the header
DRAWING = "Fovea: drawing…"  # in the middle of a viewport until its first picture is there
LETTERS = 16  # height of its letters in pixels of Blender's interface

_of_region = weakref.WeakValueDictionary()  # address of a region -> its Viewport


def update(engine, depsgraph):
    """Callback: Blender has updated the depsgraph of a viewport."""
    _viewport(engine).changes.note(depsgraph.updates)


def draw(engine, context, depsgraph):
    """Callback: Blender draws the region of a viewport."""
    viewport = _of_region[context.region.as_pointer()] = _viewport(engine)
    with session.reported(lambda message: engine.update_stats("Fovea", message)):
        try:
            viewport.draw(engine, context, depsgraph)
        except Exception:
            viewport.forget()
            raise


def gathered(context):
    """The Read scene of the picture that the context's viewport wants now; None if Fovea does not draw there."""
    if context.engine != "FOVEA" or context.space_data.shading.type != "RENDERED":
        return None
    viewport = _of_region.get(context.region.as_pointer())
    return viewport.wanted.scene.gathered if viewport and viewport.wanted else None


def _viewport(engine):
    if engine.viewport is None:
        engine.viewport = Viewport()
    return engine.viewport


class Viewport:
    """State of one viewport. `style_of(depsgraph)`: the Style that it draws."""

    patience = 0.25  # seconds that a draw of the region waits for its picture

    def __init__(self, style_of=properties.style_drawn):
        self.changes = changes.Changes(style_of)
        self.budget = budget.Budget()
        self.programs = gpu_program.Programs()
        self.wanted = self.shown = self.job = None
        self._warm = None  # Read scene of the last finished picture
        self._begun = False  # whether it was said that the first picture is on its way
        self.playing = False
        self._said_at = 0.0

    def draw(self, engine, context, depsgraph):
        """Draws the region."""
        view, job, start = camera.of_region(context, depsgraph), worker.running(), time.monotonic()
        if write_flag.render_runs():
            self.wanted = None  # found anew after the render
            engine.update_stats("Fovea", "The viewport waits for the render")
        elif not self._begun:
            self._begun = True  # seen before the scene is read, which may take long
        # A slow draft is finished, not restarted: else nothing new would be shown until the view rests.
        elif job is None or not job.draft or job.wait(job.started + self.patience - start):
            self._take(engine)
            if (before := self.wanted) is None:
                stage_labels.show(engine)
            self._want(engine, context, depsgraph, view)
            self._draw(engine, depsgraph.scene.fovea_viewport.budget_ms, start + self.patience)
            if self.wanted is not before:
                caretaker.note_change()
        if not self.is_final():
            caretaker.look_after(self, engine)
        self.show(engine, context, depsgraph, view)

    def show(self, engine, context, depsgraph, view):
        """Draws the picture shown, as it is seen in a View."""
        size = context.region.width, context.region.height
        if self.shown:
            self.shown.image.show(self.programs, engine, depsgraph.scene, *size, self.moved(context, view))
            if self.is_left_behind() and (context.space_data.overlay.show_overlays or context.space_data.show_gizmo):
                gpu_viewport.veil(*size)
        else:
            gpu_viewport.say(DRAWING, *size, LETTERS * context.preferences.system.ui_scale)

    def moved(self, context, view):
        """Where the picture shown is seen now, for Picture.show, if it was drawn from another view; else None."""
        before = self.shown.wanted.view
        if seen(before) == seen(view):
            return None
        depth = moved_picture.depth_of(before, context.region_data.view_location)
        return moved_picture.on_plane(before, view, depth), moved_picture.PLACES

    def is_left_behind(self):
        """Whether objects are in other places than in the picture shown."""
        return self.shown.wanted.scene.moves != self.changes.moves

    def is_final(self):
        """Whether the picture shown is current and needs no refinement now."""
        return self._is_current() and (self.playing or self.shown.quality == 0)

    def forget(self):
        """Drops the wanted and the shown picture."""
        self.wanted = self.shown = None

    def _is_current(self):
        return self.shown is not None and self.wanted is not None and self.shown.wanted.key == self.wanted.key

    def _want(self, engine, context, depsgraph, view):
        """Updates `wanted` and `playing` from the context."""
        self.playing = context.screen.is_animation_playing
        scene = self.changes.read(engine, depsgraph, context.space_data)
        backend, visibility = methods.choose(engine, depsgraph.scene.fovea, in_viewport=True)
        session.report_once(engine, engine.note)
        drawing = scene.style.animation.boil_drawing(depsgraph.scene.frame_current)
        quality = methods.quality(depsgraph.scene.fovea)
        options = pipeline.options(visibility=visibility, boil_drawing=drawing, **quality)
        key = (scene.version, line_files.stamp(scene.style), seen(view), options, backend.name)
        if self.wanted is None or self.wanted.key != key:
            self.wanted = Wanted(key, view, scene, options, backend)

    def _draw(self, engine, budget_ms, deadline):
        """Starts the next draft or refinement, if any, and shows it if it is done before the deadline (monotonic s)."""
        if not self._is_current():
            cold = self._is_cold(self.wanted)
            self._start(self.budget.choose(budget_ms, self.shown and self.shown.quality, cold=cold), draft=True)
            if self.job.wait(deadline - time.monotonic()):
                self._take(engine)
        elif self.job is None and not self._in_thread() and not self.is_final() and caretaker.rests():
            self._start(self.budget.next_at_rest(self.shown.quality), draft=False)
            self._take(engine)

    def _is_cold(self, wanted):
        """Whether a picture is the first one of a changed scene."""
        return wanted.scene.gathered.changed and wanted.scene.gathered is not self._warm

    def _in_thread(self):
        return self.wanted.backend.name == "cpu"

    def _start(self, quality, *, draft):
        core, wanted = native.load(), self.wanted
        cancel = core.Cancel()
        self.job = worker.Job(lambda tell: _made(wanted, quality, tell, cancel), cancel, core.Cancelled, draft=draft)
        if self._in_thread():
            worker.start(self.job)
        else:
            worker.stop()
            self.job.run()

    def _take(self, engine):
        """Shows the result of the job if it is done; raises its error."""
        if self.job is None or not self.job.done:
            return
        job, self.job = self.job, None
        if job.error is not None:
            raise job.error
        if job.result is not None:
            start, made = time.perf_counter(), job.result
            self.shown = Picture(made.wanted, made.quality, gpu_viewport.Picture(made.image.combined))
            show = 1000 * (time.perf_counter() - start)
            stages = {**made.image.statistics["stages"], "show": show}
            self.budget.note(made.quality, stages, cold=self._is_cold(made.wanted))
            self._warm = made.wanted.scene.gathered
            session.note_statistics(made.wanted.scene.gathered, made.image)
            stage_labels.show(engine)

    def look_after(self, engine):
        """Timer callback between draws of the region: starts refinements and requests redraws. Returns whether to call
        it again."""
        job = self.job
        if write_flag.render_runs():
            return True
        if job is None:
            if self.is_final():
                return False
            if worker.running() or (self._is_current() and not caretaker.rests()):
                return True
            if self._is_current() and self._in_thread():
                self._start(self.budget.next_at_rest(self.shown.quality), draft=False)
                return True
        elif not job.done:
            self.tell(engine, job)
            return True
        elif job.result is None and job.error is None:
            self.job = None  # canceled
            return True
        engine.tag_redraw()
        return False

    def tell(self, engine, job):
        """Shows a job's progress in the header, at most every WORD seconds."""
        now = time.monotonic()
        if now > max(job.started, self._said_at) + WORD:
            share, text = job.told
            stage_labels.show(engine, f"{stage_labels.label(text)} {100 * share:.0f}%")
            engine.tag_redraw()
            self._said_at = now

    def stop(self):
        """Cancels its job when the viewport is closed."""
        if self.job:
            self.job.stop()


def _made(wanted, quality, tell, cancel):
    """Draws the Picture for a Wanted in a quality (index)."""
    chosen = budget.QUALITIES[quality]
    style = budget.simplified(wanted.scene.style, chosen)
    outlines = budget.outlines(wanted.scene.style, chosen)
    options = budget.coarser(wanted.options, chosen).replace(outlines=outlines)
    view = scene.seen(native.load(), wanted.view).smaller(chosen.scale)
    image = session.draw(wanted.scene.gathered, view, style, wanted.backend, options, tell, cancel)
    return Picture(wanted, quality, image)


def stop():
    """Cancels all jobs and timers, before another file is loaded or the add-on is unregistered."""
    worker.stop()
    caretaker.stop()
