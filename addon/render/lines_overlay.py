# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines over what other engines show in 3D viewports, of scenes that have lines over their renders: drafts while
something changes and refined at rest, as viewports of Fovea itself are (viewport.py)."""

from functools import partial

import bpy
from bpy.app.handlers import persistent

from ..gpu import viewport as gpu_viewport
from ..style import style_data, style_read
from . import lines_over, lines_scenes, properties, session, viewport

SHADINGS = {"SOLID", "MATERIAL", "RENDERED"}
LETTERS = 11  # height of those that say why there are no lines, in pixels of Blender's interface
EVERYWHERE = 0.0, 0.0, 1e6, 1e6

_of_region = {}  # address of a region -> _Lines


class _Engine:
    """Stands in for the render engine of a viewport (engine.py), whose region another engine draws."""

    backend, note = None, ""

    def __init__(self, region):
        self._region = region.as_pointer()

    @property
    def is_preview(self):
        if self._region not in _regions():
            raise ReferenceError("The region has been closed")
        return False

    def report(self, _kinds, _sentence):
        """Remarks are told by renders and by the report."""

    def update_stats(self, _title, _words):
        """The header is that of the other engine."""

    def tag_redraw(self):
        if region := _regions().get(self._region):
            region.tag_redraw()


class _Lines(viewport.Viewport):
    """The lines over one region."""

    patience = 0.05

    def __init__(self, context):
        super().__init__(_style)
        self.engine, self.of = _Engine(context.region), _drawn(context)
        self.problem = ""  # why there are no lines

    def show(self, engine, context, depsgraph, view):
        """Draws the lines, if they are of what is there now: others would lie over objects elsewhere."""
        if self.shown and not self.is_left_behind():
            size = context.region.width, context.region.height
            look = self.moved(context, view), _inside(context, view), _opacity(context)
            self.shown.image.show_over(self.programs, *size, *look)


def _drawn(context):
    """Whose lines a region shows; to be compared."""
    return context.scene.name_full, context.view_layer.name


def _style(depsgraph):
    """The Style of the lines over a depsgraph's view layer."""
    lines = lines_scenes.of(depsgraph.scene, depsgraph.view_layer)
    own = style_data.of(lines) if lines else None
    return properties.style_drawn(depsgraph, given=own and style_read.read(own), lines_alone=True)


def _opacity(context):
    scene, layer = context.scene, context.view_layer
    over = lines_over.node(scene, lines_over.OVER, layer if lines_scenes.of(scene, layer) else None)
    return over.inputs["Opacity"].default_value if over else 1.0


def _inside(context, view):
    """(left, bottom, right, top) of the other engine's picture in pixels of the region."""
    space = context.space_data
    of_camera = context.region_data.view_perspective == "CAMERA"
    owner, prefix = (context.scene.render, "") if of_camera else (space, "render_")
    if space.shading.type != "RENDERED" or not (owner.use_border if of_camera else space.use_render_border):
        return EVERYWHERE
    left, bottom, width, height = view.frame if of_camera else (0, 0, view.width, view.height)
    sides = (getattr(owner, f"{prefix}border_{side}") for side in ("min_x", "min_y", "max_x", "max_y"))
    low_x, low_y, high_x, high_y = sides
    return left + width * low_x, bottom + height * low_y, left + width * high_x, bottom + height * high_y


def _is_wanted(context):
    scene = context.scene
    if context.engine == lines_scenes.ENGINE or context.space_data.shading.type not in SHADINGS:
        return False
    if not scene.fovea.lines_in_viewports:
        return False
    return any(layer in (None, context.view_layer) for layer in lines_over.places(scene))


def _draw():
    """Draw handler: Blender has drawn a 3D viewport, except for gizmos."""
    context = bpy.context
    address = context.region.as_pointer()
    wanted, lines = _is_wanted(context), _of_region.get(address)
    if lines and not (wanted and lines.of == _drawn(context)):
        _drop(address, *(set(_of_region) - set(_regions())))
        lines = None
    if not wanted:
        return
    lines = lines or _of_region.setdefault(address, _Lines(context))
    lines.problem = ""
    with session.reported(partial(setattr, lines, "problem")):
        try:
            lines.draw(lines.engine, context, context.evaluated_depsgraph_get())
        except Exception:
            lines.forget()
            raise


def _say():
    """Draw handler for text, in pixels of the region."""
    region, letters = bpy.context.region, LETTERS * bpy.context.preferences.system.ui_scale
    lines = _of_region.get(region.as_pointer())
    if lines and lines.problem:
        gpu_viewport.say(f"Fovea Lines: {lines.problem}", region.width, region.height, letters, 0.05)


def _drop(*addresses):
    """Forgets the lines over regions."""
    for address in addresses:
        if lines := _of_region.pop(address, None):
            lines.stop()


def _regions():
    """{address: region} of all 3D viewports."""
    areas = (area for window in bpy.context.window_manager.windows for area in window.screen.areas)
    return {r.as_pointer(): r for area in areas if area.type == "VIEW_3D" for r in area.regions if r.type == "WINDOW"}


@persistent
def _note(_scene, depsgraph):
    for lines in _of_region.values():
        lines.changes.note(depsgraph.updates)


@persistent
def _read_anew(*_arguments):
    """After undo, no update tells what has changed."""
    for lines in _of_region.values():
        lines.changes.forget()


@persistent
def _forget(*_arguments):
    _drop(*_of_region)


_HANDLERS = {
    "depsgraph_update_post": _note,
    "frame_change_post": _note,
    "undo_post": _read_anew,
    "redo_post": _read_anew,
    "load_pre": _forget,
}
_handles = []


def register():
    for function, when in ((_draw, "POST_VIEW"), (_say, "POST_PIXEL")):
        _handles.append(bpy.types.SpaceView3D.draw_handler_add(function, (), "WINDOW", when))
    for name, function in _HANDLERS.items():
        getattr(bpy.app.handlers, name).append(function)


def unregister():
    for name, function in _HANDLERS.items():
        getattr(bpy.app.handlers, name).remove(function)
    while _handles:
        bpy.types.SpaceView3D.draw_handler_remove(_handles.pop(), "WINDOW")
    _forget()
