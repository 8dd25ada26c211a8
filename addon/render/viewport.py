# SPDX-License-Identifier: GPL-3.0-or-later
"""A 3D viewport in Rendered shading: drawn within a budget while something changes, refined when it rests.

Pictures are drawn beside the interface (worker.py) from what was read of the scene, which is read again only when
Blender reports that something of it has changed (changes.py). A draw of the region waits a little for its picture, then
shows the last one there is; the rest is up to caretaker.py. The gpu backend needs Blender's context, so it draws while
the region is drawn.
"""

import time
import weakref
from dataclasses import dataclass

import numpy as np

from .. import budget, native, pipeline
from ..gpu import program as gpu_program
from ..gpu import viewport as gpu_viewport
from ..scene import camera, scene
from . import caretaker, changes, methods, session, worker

PATIENCE = 0.25  # seconds that draws of the region wait for a picture
WORD = 0.3  # seconds between words in the header about what is under way

_of_region = weakref.WeakValueDictionary()  # region's address -> Viewport


@dataclass(frozen=True)
class _Wanted:
    """What a viewport is to show; with equal keys it looks the same."""

    key: tuple
    view: object  # stages.View
    scene: changes.Scene
    options: object  # native Options
    backend: object


@dataclass(frozen=True)
class _Picture:
    """What it shows, or is about to."""

    wanted: _Wanted
    quality: int  # index of budget.QUALITIES
    image: object  # stages.Image, later a gpu_viewport.Picture


def update(engine, depsgraph):
    """Blender has updated the scene that a viewport shows."""
    _viewport(engine).changes.note(depsgraph.updates)


def draw(engine, context, depsgraph):
    """Blender draws the region of a viewport."""
    viewport = _of_region[context.region.as_pointer()] = _viewport(engine)
    with session.reported(lambda message: engine.update_stats("Fovea", message)):
        try:
            viewport.draw(engine, context, depsgraph)
        except Exception:
            viewport.forget()
            raise


def gathered(context):
    """What the context's viewport shows, as it was Read for the picture that was drawn last; None where Fovea draws
    none there."""
    if context.engine != "FOVEA" or context.space_data.shading.type != "RENDERED":
        return None
    viewport = _of_region.get(context.region.as_pointer())
    return viewport.wanted.scene.gathered if viewport and viewport.wanted else None


def _viewport(engine):
    if engine.viewport is None:
        engine.viewport = Viewport()
    return engine.viewport


class Viewport:
    """What is kept for one viewport."""

    def __init__(self):
        self.changes = changes.Changes()
        self.budget = budget.Budget()
        self._programs = gpu_program.Programs()
        self.wanted = self.shown = self.job = None
        self._warm = None  # what was Read for the picture that was made last
        self.playing = False
        self._said_at = 0.0

    def draw(self, engine, context, depsgraph):
        """Draws the region."""
        view, job, start = camera.of_region(context, depsgraph), worker.running(), time.monotonic()
        # A draft that takes its time is let finish: else nothing new would be seen before all comes to rest.
        if job is None or not job.draft or job.wait(job.started + PATIENCE - start):
            self._take(engine)
            before = self.wanted
            self._want(engine, context, depsgraph, view)
            self._draw(engine, depsgraph.scene.fovea_viewport.budget_ms, start + PATIENCE)
            if self.wanted is not before:
                caretaker.note_change()
        if not self.is_final():
            caretaker.look_after(self, engine)
        if self.shown:
            size = context.region.width, context.region.height
            self.shown.image.show(self._programs, engine, depsgraph.scene, *size)

    def is_final(self):
        """Whether nothing better can be shown for now."""
        return self._is_current() and (self.playing or self.shown.quality == 0)

    def forget(self):
        """Lets go of what is shown and wanted."""
        self.wanted = self.shown = None

    def _is_current(self):
        return self.shown is not None and self.wanted is not None and self.shown.wanted.key == self.wanted.key

    def _want(self, engine, context, depsgraph, view):
        """Finds out what is to be seen."""
        self.playing = context.screen.is_animation_playing
        scene = self.changes.read(engine, depsgraph, context.space_data)
        backend, visibility = methods.choose(engine, depsgraph.scene.fovea, in_viewport=True)
        options = pipeline.options(visibility=visibility, **methods.quality(depsgraph.scene.fovea))
        key = (scene.version, _seen(view), options, backend.name)
        if self.wanted is None or self.wanted.key != key:
            self.wanted = _Wanted(key, view, scene, options, backend)

    def _draw(self, engine, budget_ms, deadline):
        """Begins what is to be drawn next, and takes it if it is made before the deadline."""
        if not self._is_current():
            cold = self._is_cold(self.wanted)
            self._start(self.budget.choose(budget_ms, self.shown and self.shown.quality, cold=cold), draft=True)
            if self.job.wait(deadline - time.monotonic()):
                self._take(engine)
        elif self.job is None and not self._in_thread() and not self.is_final() and caretaker.rests():
            self._start(self.budget.next_at_rest(self.shown.quality), draft=False)
            self._take(engine)

    def _is_cold(self, wanted):
        """Whether a picture is the first one of a scene that has changed."""
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
        """Shows what the job has made, if it is done."""
        if self.job is None or not self.job.done:
            return
        job, self.job = self.job, None
        if job.error is not None:
            raise job.error
        if job.result is not None:
            start, made = time.perf_counter(), job.result
            self.shown = _Picture(made.wanted, made.quality, gpu_viewport.Picture(made.image.combined))
            show = 1000 * (time.perf_counter() - start)
            stages = {**made.image.statistics["stages"], "show": show}
            self.budget.note(made.quality, stages, cold=self._is_cold(made.wanted))
            self._warm = made.wanted.scene.gathered
            session.note_statistics(made.wanted.scene.gathered, made.image)
            engine.update_stats("", "")

    def look_after(self, engine):
        """What is to be done between draws of the region; whether to come again."""
        job = self.job
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
            self.job = None  # stopped
            return True
        engine.tag_redraw()
        return False

    def tell(self, engine, job):
        """A word to the user now and then."""
        now = time.monotonic()
        if now > max(job.started, self._said_at) + WORD:
            share, text = job.told
            engine.update_stats("Fovea", f"{text} {100 * share:.0f}%")
            engine.tag_redraw()
            self._said_at = now

    def stop(self):
        """The viewport is no more."""
        if self.job:
            self.job.stop()


def _made(wanted, quality, tell, cancel):
    """The _Picture that is wanted, in this quality."""
    chosen = budget.QUALITIES[quality]
    style = budget.simplified(wanted.scene.style, chosen)
    outlines = budget.outlines(wanted.scene.style, chosen)
    options = budget.coarser(wanted.options, chosen).replace(outlines=outlines)
    seen = scene.seen(native.load(), wanted.view).smaller(chosen.scale)
    image = session.draw(wanted.scene.gathered, seen, style, wanted.backend, options, tell, cancel)
    return _Picture(wanted, quality, image)


def _seen(view):
    """A View, to be compared."""
    return tuple(value.tobytes() if isinstance(value, np.ndarray) else value for value in vars(view).values())


def stop():
    """Ends all that is under way: another file comes, or the add-on goes."""
    worker.stop()
    caretaker.stop()
