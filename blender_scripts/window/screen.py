# SPDX-License-Identifier: GPL-3.0-or-later
"""Access to the window of Blender under Xvfb from inside: its 3D viewports, and the pixels on the screen.

Xvfb stores the screen in a file (an XWD dump: a header, then rows of BGRX); bpy's own screenshots are black there."""

import os
import struct
import time
from pathlib import Path

import bpy
import numpy as np


def area(index=0):
    """The 3D viewport area of that index in the window."""
    return [a for a in bpy.context.window_manager.windows[0].screen.areas if a.type == "VIEW_3D"][index]


def space():
    return area().spaces.active


def region(of=None):
    return next(r for r in (of or area()).regions if r.type == "WINDOW")


def override(**more):
    window = bpy.context.window_manager.windows[0]
    place = {"window": window, "screen": window.screen, "area": area(), "region": region()}
    return bpy.context.temp_override(**{**place, **more})


def fill():
    """Maximizes the 3D viewport and hides overlays, gizmos and regions. Use with `yield from`."""
    yield from rest(0.2)
    with override():
        bpy.ops.screen.screen_full_area(use_hide_panels=True)
    yield from rest(0.2)
    one, size = space(), bpy.context.window_manager.windows[0].width
    one.overlay.show_overlays = one.show_gizmo = one.show_region_hud = False
    # Moves the pointer, which the screen dump includes, to the lower right corner.
    bpy.context.window_manager.windows[0].cursor_warp(size - 1, 0)


def swap():
    """Redraws the window and swaps its buffers."""
    with override():
        bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1)


def picture(of=None):
    """(H, W, 3) float32 in [0, 1], bottom row first: screen pixels of a viewport's region."""
    where = region(of)
    return whole()[where.y : where.y + where.height, where.x : where.x + where.width]


def whole():
    """(H, W, 3) float32, as `picture`: the whole screen, which the window fills."""
    return _screen()[::-1]


def _screen():
    data = (Path(os.environ["FOVEA_SCREEN"]) / "Xvfb_screen0").read_bytes()
    header = struct.unpack(">25I", data[:100])
    size, width, height, line, colors = header[0], header[4], header[5], header[12], header[19]
    start = size + 12 * colors
    rows = np.frombuffer(data, np.uint8, line * height, start).reshape(height, line)
    return rows[:, : 4 * width].reshape(height, width, 4)[:, :, 2::-1].astype(np.float32) / 255


def until(done, seconds=60.0):
    """Yields to Blender until done() is true; TimeoutError after `seconds`. Use with `yield from`."""
    end = time.monotonic() + seconds
    while not done():
        if time.monotonic() > end:
            raise TimeoutError(f"waited {seconds} s in vain")
        yield


def rest(seconds):
    """Yields to Blender for so many seconds. Use with `yield from`."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        yield
