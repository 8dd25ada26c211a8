# SPDX-License-Identifier: GPL-3.0-or-later
"""An overlay of 3D viewports, the focus heat map: warm in focus, cool out of focus.

When a viewport is drawn after a change of its view, the focus or the scene, the native module evaluates focus per pixel
at a low resolution that fits into the time budget; when changes have stopped, once more at SCALE. Idle viewports are
not redrawn. The scene is read separately only if Fovea does not draw the viewport itself.
"""

import time

import bpy
import numpy as np
from bpy.app.handlers import persistent

from .. import heat_map
from ..focus import focus_kinds
from ..gpu import overlay as gpu_overlay
from ..render import caretaker, properties, reading, viewport
from ..scene import camera, subdivision
from ..scene.operator import TOLD

SCALE = 0.25  # resolution at rest, as a fraction of the viewport's
LEAST = SCALE / 4  # lowest resolution while something changes
OPACITY = 0.45

in_regions = {}  # address of a region -> its _Shown
readers = []  # at most one Reader, created on demand


class _Shown:
    """State of the overlay of one region."""

    def __init__(self):
        self.veil = None
        self.scale = SCALE  # resolution of the overlay shown
        self.movement = caretaker.Movement()
        self._took = None  # (scale, ms) of the last evaluation
        self.forget()

    def forget(self):
        """Invalidates it after a change of the scene."""
        self.read = self.found = self.key = None

    def update(self, context):
        """Evaluates focus again after a change, or at SCALE once changes have stopped."""
        depsgraph = context.evaluated_depsgraph_get()
        chosen, view = properties.style_of(depsgraph.scene_eval), camera.of_region(context, depsgraph)
        found = self._read(context, depsgraph, chosen)
        key = (chosen.focus, view.world_to_view.tobytes(), view.view_to_clip.tobytes(), view.width, view.height)
        if self.key != key or self.found is not found:
            budget_ms = depsgraph.scene.fovea_viewport.budget_ms
            self.key, self.found = key, found
            self.scale = affordable(*self._took, budget_ms) if self._took else LEAST
            self.movement.note_change()
        elif self.scale < SCALE and self.movement.rests():
            self.scale = SCALE
        else:
            return
        start = time.perf_counter()
        values = reading.focus_of_pixels(found, view, chosen.focus, self.scale)
        self._took = self.scale, 1000 * (time.perf_counter() - start)
        self.veil = None if values is None else gpu_overlay.Veil(colors(values))

    def _read(self, context, depsgraph, chosen):
        """The Read scene: that of Fovea's picture in the region, or else one read for the overlay; None if focus is a
        place in the image."""
        if focus_kinds.KINDS[chosen.focus.model.upper()].in_frame:  # does not depend on the scene
            return None
        if drawn := viewport.gathered(context):
            return drawn
        # Read again if the focus changed, because painted and object focus need additional data.
        if self.read is None or self.key is None or self.key[0] != chosen.focus:
            self.read = _reader().read(depsgraph, chosen, context.space_data)
        return self.read


def _reader():
    if not readers:
        readers.append(reading.Reader())
    return readers[0]


def affordable(scale, ms, budget_ms):
    """The scale that fits into a budget, if `scale` took `ms`: cost is taken to be proportional to the pixels."""
    return min(max(scale * (budget_ms / max(ms, 1e-3)) ** 0.5, LEAST), SCALE)


def colors(values):
    """(H, W, 4) float32 RGBA in display space, straight alpha, from (H, W) focus."""
    opacity = np.full((*values.shape, 1), OPACITY)
    return np.concatenate([heat_map.colors(values), opacity], axis=2, dtype=np.float32)


def _draw():
    """Draw handler: called after Blender has drawn a 3D viewport."""
    context = bpy.context
    if not (context.window_manager.fovea_show_focus and context.space_data.overlay.show_overlays):
        return
    if not focus_kinds.of(context.scene.fovea).is_on:
        return
    try:
        shown = in_regions.setdefault(context.region.as_pointer(), _Shown())
        shown.update(context)
    except TOLD:
        return  # the panels and the engine report the error
    if shown.veil:
        shown.veil.show(context.region.width, context.region.height)
    if shown.scale < SCALE and not bpy.app.timers.is_registered(_refine):
        bpy.app.timers.register(_refine, first_interval=caretaker.REST)


def _refine():
    """Timer: redraws coarse overlays once changes have stopped, then ends."""
    coarse = [shown for shown in in_regions.values() if shown.scale < SCALE]
    if not all(shown.movement.rests() for shown in coarse):
        return caretaker.TICK
    if coarse:
        _redraw(bpy.context.window_manager)
    return None


def _toggled(manager, _context):
    if not manager.fovea_show_focus:
        _forget()
    _redraw(manager)


def _redraw(manager):
    for window in manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


@persistent
def _changed(_scene, depsgraph):
    """Handler: invalidates all overlays after a depsgraph update, unless reading a cage caused it."""
    if in_regions and not subdivision.is_echo(depsgraph.updates):
        for shown in list(in_regions.values()):
            shown.forget()


@persistent
def _forget(*_arguments):
    in_regions.clear()
    readers.clear()
    if bpy.app.timers.is_registered(_refine):
        bpy.app.timers.unregister(_refine)


def _in_popover(self, context):
    """Entry in the viewport's Overlays popover."""
    if context.engine == "FOVEA":
        self.layout.label(text="Fovea")
        self.layout.prop(context.window_manager, "fovea_show_focus")


MENUS = {"VIEW3D_PT_overlay": _in_popover}
_HANDLERS = (("depsgraph_update_post", _changed), ("frame_change_post", _changed), ("load_pre", _forget))
handle = None


def register():
    global handle
    bpy.types.WindowManager.fovea_show_focus = bpy.props.BoolProperty(
        name="Focus Heat Map",
        description="Show in 3D viewports what is in focus (red) and out of it (blue), while overlays are shown",
        options={"SKIP_SAVE"},
        update=_toggled,
    )
    handle = bpy.types.SpaceView3D.draw_handler_add(_draw, (), "WINDOW", "POST_PIXEL")
    for name, function in _HANDLERS:
        getattr(bpy.app.handlers, name).append(function)


def unregister():
    global handle
    for name, function in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(function)
    bpy.types.SpaceView3D.draw_handler_remove(handle, "WINDOW")
    handle = None
    del bpy.types.WindowManager.fovea_show_focus
    _forget()
