# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks after viewports between their draws, by a timer that is there only while something is under way."""

import time

import bpy

REST = 0.2  # seconds without a change after which pictures are refined
MOVEMENT = 1.0  # most seconds between two changes of one movement
TICK = 0.02  # seconds between looks

_pending = {}  # Viewport that has something under way -> its engine


class Movement:
    """Changes that follow each other, and whether they have come to an end."""

    def __init__(self):
        self._changed_at = 0.0
        self._rest = REST  # longer where changes come slowly

    def note_change(self):
        gap, self._changed_at = time.monotonic() - self._changed_at, time.monotonic()
        self._rest = max(REST, 1.5 * gap) if gap < MOVEMENT else REST

    def rests(self):
        return time.monotonic() > self._changed_at + self._rest


_movement = Movement()  # of all viewports
note_change = _movement.note_change  # a viewport has to show something else
rests = _movement.rests  # whether nothing changes in any viewport


def look_after(viewport, engine):
    """Calls `viewport.look_after(engine)` again and again while it returns True; `viewport.stop()` if Blender lets go
    of the engine before."""
    _pending[viewport] = engine
    if not bpy.app.timers.is_registered(tick):
        bpy.app.timers.register(tick, first_interval=TICK)


def tick():
    for viewport, engine in list(_pending.items()):
        if not _exists(engine):
            viewport.stop()
        elif viewport.look_after(engine):
            continue
        _pending.pop(viewport, None)
    return TICK if _pending else None


def stop():
    _pending.clear()
    if bpy.app.timers.is_registered(tick):
        bpy.app.timers.unregister(tick)


def _exists(engine):
    """Whether Blender still has the engine of a viewport."""
    try:
        return engine.is_preview is not None
    except ReferenceError:
        return False
