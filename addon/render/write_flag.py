# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps renders and draws of regions apart, where Blender has one flag for all threads that forbids Python to write
data while a region is drawn. A callback of a render that Blender enters while such a draw has given up Python's lock
puts the flag back as it was found, when all else is done: nothing can be edited, saved or quit from then on.

Thus viewports wait for a render, and while one runs, Python's lock goes to another thread only within its callbacks: a
draw that has begun is done before Blender enters the next one."""

import sys
import threading
from contextlib import contextmanager

import bpy
from bpy.app.handlers import persistent

SHARED = bpy.app.version < (5, 2, 0) and not bpy.app.background  # whether the flag is at risk
DRAW = 10.0  # seconds, longer than any draw of a region

_interval = None  # seconds after which Python's lock goes to a thread that waits for it, before a render changed that


def render_runs():
    """Whether a render runs beside which a viewport must not draw."""
    return SHARED and bpy.app.is_job_running("RENDER")


@contextmanager
def callback():
    """The body of a callback of a render engine: the interface may draw meanwhile."""
    if _interval is None or threading.current_thread() is threading.main_thread():
        yield
        return
    sys.setswitchinterval(_interval)
    try:
        yield
    finally:
        if _interval is not None:
            sys.setswitchinterval(DRAW)


@persistent
def _begin(*_):
    global _interval
    if _interval is None:
        _interval = sys.getswitchinterval()
        sys.setswitchinterval(DRAW)


@persistent
def _end(*_):
    global _interval
    if _interval is not None:
        sys.setswitchinterval(_interval)
        _interval = None


HANDLERS = {"render_init": _begin, "render_complete": _end, "render_cancel": _end}


def register():
    if SHARED:
        for name, handler in HANDLERS.items():
            getattr(bpy.app.handlers, name).append(handler)


def unregister():
    if SHARED:
        for name, handler in HANDLERS.items():
            getattr(bpy.app.handlers, name).remove(handler)
    _end()
