# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulated mouse and key events; need a Blender started with event simulation."""

import bpy
from window import screen


def event(kind, value, place, **keys):
    """One event, and time for Blender to handle it."""
    bpy.context.window_manager.windows[0].event_simulate(type=kind, value=value, x=place[0], y=place[1], **keys)
    yield from screen.rest(0.03)


def press(kind, place):
    yield from event(kind, "PRESS", place)
    yield from event(kind, "RELEASE", place)


def drag(button, start, end, steps=10):
    yield from event("MOUSEMOVE", "NOTHING", start)
    yield from event(button, "PRESS", start)
    for i in range(1, steps + 1):
        place = tuple(round(a + (b - a) * i / steps) for a, b in zip(start, end))
        yield from event("MOUSEMOVE", "NOTHING", place)
    yield from event(button, "RELEASE", end)
