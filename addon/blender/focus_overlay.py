"""An overlay of 3D viewports that shows focus as colors: warm where it is, cool far from it.

The native module evaluates it at low resolution, when a viewport is drawn and its view, the focus or the scene has
changed since; idle viewports draw nothing. The scene is read for it only where Fovea does not draw the viewport anyway.
"""

import bpy
import numpy as np
from bpy.app.handlers import persistent

from .. import native, style
from ..backend import gpu_overlay
from . import camera, properties, reading, subdivision, viewport
from .problem import CannotDraw

SCALE = 0.25  # of the viewport's size
# Colours from focus 0 to 1, in the display's space; what they cover shows through.
STOPS = np.array([(0.95, 0.25, 0.1), (1.0, 0.8, 0.2), (0.3, 0.75, 0.6), (0.15, 0.3, 0.8)], np.float32)
OPACITY = 0.45

_shown = {}  # region's address -> _Shown, until the scene changes
_readers = []  # one, while it is needed


class _Shown:
    """What is kept for one region."""

    def __init__(self):
        self.read = self.found = self.key = self.veil = None

    def update(self, context):
        """Evaluates focus anew where something has changed."""
        depsgraph = context.evaluated_depsgraph_get()
        chosen, view = properties.style_of(depsgraph.scene_eval), camera.of_region(context, depsgraph)
        found = self._read(context, depsgraph, chosen)
        key = (chosen.focus, view.world_to_view.tobytes(), view.view_to_clip.tobytes(), view.width, view.height)
        if self.key == key and self.found is found:
            return
        self.key, self.found = key, found
        values = reading.focus_of_pixels(found, view, chosen.focus, SCALE)
        self.veil = None if values is None else gpu_overlay.Veil(colors(values))

    def _read(self, context, depsgraph, chosen):
        """What is there to be looked at: what Fovea draws in the region, or else what is read for this."""
        if chosen.focus.model == "image":  # is there whatever the scene holds
            return None
        if drawn := viewport.gathered(context):
            return drawn
        # Painted or an object's, focus asks more of a scene.
        if self.read is None or self.key is None or self.key[0] != chosen.focus:
            self.read = _reader().read(depsgraph, chosen, context.space_data)
        return self.read


def _reader():
    if not _readers:
        _readers.append(reading.Reader())
    return _readers[0]


def colors(values):
    """(H, W, 4) float32 of (H, W) focus."""
    at = np.clip(values, 0, 1) * (len(STOPS) - 1)
    below = np.minimum(at.astype(np.intp), len(STOPS) - 2)
    share = (at - below)[..., None]
    mixed = STOPS[below] * (1 - share) + STOPS[below + 1] * share
    return np.concatenate([mixed, np.full((*values.shape, 1), OPACITY)], axis=2, dtype=np.float32)


def _draw():
    """Called when Blender has drawn a 3D viewport."""
    context = bpy.context
    if not (context.window_manager.fovea_show_focus and context.space_data.overlay.show_overlays):
        return
    if context.scene.fovea.focus_model == "NONE":
        return
    try:
        shown = _shown.setdefault(context.region.as_pointer(), _Shown())
        shown.update(context)
    except (CannotDraw, native.Unavailable, style.StyleError):
        return  # the panels and the engine say what is wrong
    if shown.veil:
        shown.veil.show(context.region.width, context.region.height)


def _toggled(manager, _context):
    if not manager.fovea_show_focus:
        _forget()
    for window in manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


@persistent
def _changed(_scene, depsgraph):
    """Something in the scene changed, unless it was us who read a cage: it is read again when it is shown next."""
    if not subdivision.is_echo(depsgraph.updates):
        _shown.clear()


@persistent
def _forget(*_arguments):
    _shown.clear()
    _readers.clear()


def _in_popover(self, context):
    """In the viewport's overlays."""
    if context.engine == "FOVEA":
        self.layout.label(text="Fovea")
        self.layout.prop(context.window_manager, "fovea_show_focus")


_HANDLERS = (("depsgraph_update_post", _changed), ("frame_change_post", _changed), ("load_pre", _forget))
_handle = None


def register():
    global _handle
    bpy.types.WindowManager.fovea_show_focus = bpy.props.BoolProperty(
        name="Focus as Colors",
        description="Show in 3D viewports what is in focus (red) and out of it (blue), while overlays are shown",
        options={"SKIP_SAVE"},
        update=_toggled,
    )
    _handle = bpy.types.SpaceView3D.draw_handler_add(_draw, (), "WINDOW", "POST_PIXEL")
    for name, function in _HANDLERS:
        getattr(bpy.app.handlers, name).append(function)
    bpy.types.VIEW3D_PT_overlay.append(_in_popover)


def unregister():
    global _handle
    bpy.types.VIEW3D_PT_overlay.remove(_in_popover)
    for name, function in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(function)
    bpy.types.SpaceView3D.draw_handler_remove(_handle, "WINDOW")
    _handle = None
    del bpy.types.WindowManager.fovea_show_focus
    _forget()
