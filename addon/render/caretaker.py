# SPDX-License-Identifier: GPL-3.0-or-later
"""Timer that updates viewports between their draws; registered only while a viewport has pending work."""

import time

import bpy

REST = 0.2  # seconds without a change after which pictures are refined
MOVEMENT = 1.0  # changes less than this many seconds apart belong to one movement
TICK = 0.02  # seconds between ticks of the timer

_pending = {}  # Viewport with pending work -> its engine


class Movement:
    """Detects when a series of changes has ended."""

    def __init__(self):
        self._changed_at = 0.0
        self._rest = REST  # seconds; longer if the changes are far apart

    def note_change(self):
        gap, self._changed_at = time.monotonic() - self._changed_at, time.monotonic()
        self._rest = max(REST, 1.5 * gap) if gap < MOVEMENT else REST

    def rests(self):
        return time.monotonic() > self._changed_at + self._rest


_movement = Movement()  # shared by all viewports
note_change = _movement.note_change  # call it when a viewport has to show something else
rests = _movement.rests  # whether no viewport has changed recently


def look_after(viewport, engine):
    """Calls `viewport.look_after(engine)` every TICK while it returns True; `viewport.stop()` if Blender frees the
    engine first."""
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
    """Whether Blender has not freed a viewport's engine."""
    try:
        return engine.is_preview is not None
    except ReferenceError:
        return False
