# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps renders and draws of regions apart, where Blender has one flag for all threads that forbids Python to write
data while a region is drawn. A callback of a render that Blender enters while such a draw has given up Python's lock
puts the flag back as it was found, when all else is done: nothing can be edited, saved or quit from then on.

Thus viewports wait for a render, and while one runs in a thread of its own, Python's lock goes to another thread only
within its callbacks: a draw that has begun is done before Blender enters the next one. What remains are draws that give
the lock up by themselves, as they read files."""

import sys
import threading
import time
from contextlib import contextmanager

import bpy
from bpy.app.handlers import persistent

SHARED = bpy.app.version < (5, 2, 0) and not bpy.app.background  # whether the flag is at risk
DRAW = 10.0  # seconds, longer than any draw of a region
MOMENT = 0.001  # seconds in which a thread that waits for Python's lock gets it
LOOK = 1.0  # seconds between looks for renders that have ended without a word

_interval = None  # seconds after which Python's lock goes to a thread that waits for it, before a render changed that


def render_runs():
    """Whether a render runs beside which a viewport must not draw."""
    return SHARED and bpy.app.is_job_running("RENDER")


@contextmanager
def callback():
    """The body of a callback of a render engine: the interface may draw meanwhile."""
    if _interval is None or _is_interface():
        yield
        return
    sys.setswitchinterval(_interval)
    try:
        yield
    finally:
        if _interval is not None:
            _keep_draws_whole()


def _keep_draws_whole():
    """From here on a draw keeps the lock to its end; one that waits for it now gets it first."""
    sys.setswitchinterval(DRAW)
    time.sleep(MOMENT)


def _is_interface():
    return threading.current_thread() is threading.main_thread()


@persistent
def _begin(*_):
    global _interval
    if _is_interface() or _interval is not None or all(scene.render.engine != "FOVEA" for scene in bpy.data.scenes):
        return
    _interval = sys.getswitchinterval()
    _keep_draws_whole()


@persistent
def _end(*_):
    if not _is_interface():
        _restore()


def _restore():
    global _interval
    if _interval is not None:
        sys.setswitchinterval(_interval)
        _interval = None


def _look():
    """Timer callback: a render that cannot begin to write its movie calls no handler at its end."""
    if not render_runs():
        _restore()
    return LOOK


HANDLERS = {"render_init": _begin, "render_complete": _end, "render_cancel": _end}


def register():
    if SHARED:
        for name, handler in HANDLERS.items():
            getattr(bpy.app.handlers, name).append(handler)
        bpy.app.timers.register(_look, persistent=True)


def unregister():
    if SHARED:
        for name, handler in HANDLERS.items():
            getattr(bpy.app.handlers, name).remove(handler)
        bpy.app.timers.unregister(_look)
    _restore()
