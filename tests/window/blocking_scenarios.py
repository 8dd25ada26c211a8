# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenarios of the interface while a picture takes very long. Tests check what a scenario returns."""

import bpy
import numpy as np
from showing import calm, opened, threads, turn
from slow import held
from the_addon import part
from window import screen

viewport, worker = part("render.viewport"), part("render.worker")


class Waits:
    """What each draw of the region is ready to wait for pictures, in seconds, and what the header says."""

    def __init__(self):
        self._old = worker.Job.wait, viewport.draw, viewport.Viewport.tell
        self.of_draws, self.said = [], []
        waits, told = self.of_draws, self.said

        def draw(*arguments):
            waits.append(0.0)
            self._old[1](*arguments)

        def wait(job, seconds):
            if waits:
                waits[-1] += max(0.0, seconds)
            return self._old[0](job, seconds)

        def tell(one, engine, job):
            self._old[2](one, Header(engine, told), job)

        worker.Job.wait, viewport.draw, viewport.Viewport.tell = wait, draw, tell

    def end(self):
        worker.Job.wait, viewport.draw, viewport.Viewport.tell = self._old


class Header:
    """An engine that also keeps what it is told to say."""

    def __init__(self, engine, said):
        self.tag_redraw, self._engine, self._said = engine.tag_redraw, engine, said

    def update_stats(self, title, text):
        self._said.append(text)
        self._engine.update_stats(title, text)


def long_pictures(folder):
    """While a picture is held up for as long as it takes: the view turns, things move, settings change, and every draw
    comes back; then the picture comes."""
    watch = yield from opened("boxes:2")
    told = {"patience": viewport.Viewport.patience}
    for name, act in (("turned", lambda: turn(4)), ("moved", nudge), ("restyled", restyle)):
        waits = Waits()
        with held() as drawing:
            for _ in range(4):
                act()
                screen.swap()
                yield from screen.rest(0.1)
            yield from screen.until(lambda: waits.said)
            told[name] = {"begun": drawing.begun, "threads": len(threads())}
            told[name] |= {"said": waits.said, "waits": waits.of_draws}
        waits.end()
        yield from watch.refined()
    shown = screen.picture()[16:]
    turn(90)
    yield from watch.refined()
    turn(-90)
    yield from watch.refined()
    told["back"] = float(np.abs(screen.picture()[16:] - shown).mean())
    # What refines a picture gives way at once to what changes.
    told["gave way"] = yield from gave_way(watch)
    return told | {"quality": watch.of(screen.area()).shown.quality, "calm": (yield from calm())}


def gave_way(watch):
    """A refinement is held up, then a thing moves: drafts that came meanwhile, and what was drawn in the end."""
    old, caught = viewport.budget.Budget.choose, []
    viewport.budget.Budget.choose = lambda *_, **__: 3  # so that there is something to refine
    nudge()
    screen.swap()
    yield from screen.until(lambda: watch.of(screen.area()).job is None)
    with held() as drawing:
        yield from screen.until(lambda: drawing.begun)
        caught.append(worker.running() is not None and not worker.running().draft)
        nudge()
        screen.swap()
        caught.append(worker.running() is None or worker.running().draft)
    viewport.budget.Budget.choose = old
    yield from watch.refined()
    return caught


def nudge():
    bpy.context.scene.objects["Boxes"].location.x += 0.1


def restyle():
    bpy.context.scene.fovea.focus_model = "NONE"
    held_style = part("style.style_data").own(bpy.context.scene)
    held_style.line_sets[0].pen.width += 0.5
