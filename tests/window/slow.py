# SPDX-License-Identifier: GPL-3.0-or-later
"""A drawing whose duration a test controls, in any thread."""

import threading
import time
from contextlib import contextmanager

from the_addon import part

session, viewport, worker = part("render.session"), part("render.viewport"), part("render.worker")


class Held:
    """Drawings that are held up at their first stage, until they are let go or cancelled."""

    def __init__(self):
        self.begun = 0  # drawings
        self.go = threading.Event()

    def draw(self, old, *arguments, progress, cancel, **options):
        self.begun += 1
        progress(0.25, "held up")
        while not self.go.wait(0.01):
            if cancel.requested:
                raise session.native.load().Cancelled("cancelled")
        return old(*arguments, progress=progress, cancel=cancel, **options)


@contextmanager
def held():
    """A Held, through which all pictures of viewports and renders go meanwhile."""
    one, old = Held(), session.pipeline.draw
    session.pipeline.draw = lambda *arguments, **options: one.draw(old, *arguments, **options)
    try:
        yield one
    finally:
        session.pipeline.draw = old
        one.go.set()


@contextmanager
def slower(viewport, render):
    """Pictures of viewports, and what a render asks of the engine, take these seconds longer meanwhile."""

    def after(old):
        def later(*arguments, **options):
            time.sleep(viewport if threading.current_thread().name == worker.NAME else render)
            return old(*arguments, **options)

        return later

    old = session.pipeline.draw, session.register_passes
    session.pipeline.draw, session.register_passes = map(after, old)
    try:
        yield
    finally:
        session.pipeline.draw, session.register_passes = old


@contextmanager
def busy(seconds):
    """Each draw of a viewport computes in Python for these seconds more meanwhile."""

    def show(*arguments):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            pass
        old(*arguments)

    old = viewport.Viewport.show
    viewport.Viewport.show = show
    try:
        yield
    finally:
        viewport.Viewport.show = old
