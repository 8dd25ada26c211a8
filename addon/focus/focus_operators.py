# SPDX-License-Identifier: GPL-3.0-or-later
"""Pick Focus: sets the focus by a click in a viewport."""

import bpy
from bpy_extras.view3d_utils import region_2d_to_origin_3d, region_2d_to_vector_3d

from ..scene import camera
from ..scene.operator import Operator
from ..scene.problem import CannotDraw
from . import focus_kinds, focus_places

PROMPT = "Pick Focus: click what to look at"
KEYS = (("MOUSE_LMB", "Look Here"), ("EVENT_SHIFT", "Look Here, Too"), ("EVENT_ESC", "Cancel"))
MISSED = "There is nothing under the pointer: the focus stays where it is"
NAVIGATION = {"MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "TRACKPADPAN", "TRACKPADZOOM", "MOUSEROTATE"}
_THROUGH = 64  # most ignored surfaces that the ray of a click passes through


def cast(context, px):
    """(world location, object) of the first hit of the ray through a region's pixel, skipping objects whose usage is
    IGNORE; None if there is no hit."""
    region, view = context.region, context.region_data
    origin, direction = region_2d_to_origin_3d(region, view, px), region_2d_to_vector_3d(region, view, px)
    depsgraph = context.evaluated_depsgraph_get()
    for _ in range(_THROUGH):
        hit, at, _, _, obj, _ = context.scene.ray_cast(depsgraph, origin, direction)
        if not hit:
            return None
        if obj.fovea.usage != "IGNORE":
            return at, obj
        origin = at + 1e-4 * max(1.0, at.length) * direction
    return None


def look(context):
    """The Look of a context's viewport."""
    frame = None
    if context.region_data.view_perspective == "CAMERA":
        frame = camera.of_region(context, context.evaluated_depsgraph_get()).frame
    return focus_places.Look(context.region, context.region_data, frame)


def pick(context, px, add):
    """Sets the focus to what a pixel of the context's viewport shows. Returns None, or a sentence on why it did not."""
    scene, seen = context.scene, look(context)
    kind = focus_kinds.of(scene.fovea)
    if kind.in_frame and seen.frame:
        at = seen.in_frame(px)
        if not all(0 <= v <= 1 for v in at):
            return "That is outside of the camera's frame: the focus stays where it is"
        focus_places.put_in_image(scene, at, add=add)
        return None
    found = cast(context, px)
    if found is None:
        return MISSED
    at, obj = found
    if kind.is_surface:
        focus_places.put_object(scene, obj, add=add)
        return None
    if unit := seen.unit_at(at):
        focus_places.fit_radii(scene.fovea, context.region.height / unit)
    focus_places.put(scene, at, add=add)
    return None


def viewport_at(context, x, y):
    """(area, region) of the 3D viewport at a window pixel; None elsewhere and where another region overlaps it."""
    for area in context.window.screen.areas:
        if area.type != "VIEW_3D":
            continue
        inside = [r for r in area.regions if 0 <= x - r.x < r.width and 0 <= y - r.y < r.height]
        if inside and all(region.type == "WINDOW" for region in inside):
            return area, inside[0]
    return None


def _draw_keys(header, _context):
    """Draws the key hints in the status bar."""
    for icon, text in KEYS:
        header.layout.label(text=text, icon=icon)


class FOVEA_OT_pick_focus(Operator, bpy.types.Operator):
    """Click in a 3D viewport to say where to look: an Empty marks the place. Shift adds another place. In the model
    Place in the Image, click in camera view; in the model Object, the object that is clicked is what to look at"""

    bl_idname = "fovea.pick_focus"
    bl_label = "Pick Focus"
    errors, level = (ValueError,), "WARNING"

    x: bpy.props.IntProperty(
        name="X", description="Pixels from the left of the viewport's region", options={"SKIP_SAVE"}
    )
    y: bpy.props.IntProperty(
        name="Y", description="Pixels from the lower end of the viewport's region", options={"SKIP_SAVE"}
    )
    location: bpy.props.FloatVectorProperty(
        name="Location",
        description="World coordinates of the place, instead of what a pixel shows",
        subtype="XYZ",
        unit="LENGTH",
        options={"SKIP_SAVE"},
    )
    add: bpy.props.BoolProperty(
        name="Add", description="Look there, too, beside the places there are", options={"SKIP_SAVE"}
    )

    here: bpy.props.BoolProperty(
        name="Here", description="Pick at the pointer, without a click", options={"SKIP_SAVE", "HIDDEN"}
    )

    @classmethod
    def hindrance(cls, context):
        fits = context.mode in {"OBJECT", "EDIT_MESH", "POSE"} and context.scene is not None
        return None if fits else "Focus is picked in Object, Edit or Pose mode"

    def invoke(self, context, event):
        if self.here:
            self.x, self.y = event.mouse_region_x, event.mouse_region_y
            return self.execute(context)
        self._tell(context, PROMPT)
        context.workspace.status_text_set(_draw_keys)
        context.window.cursor_modal_set("EYEDROPPER")
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type in {"ESC", "RIGHTMOUSE"}:
            return self._end(context, {"CANCELLED"})
        if event.type in NAVIGATION or event.type.startswith("NDOF"):
            return {"PASS_THROUGH"}
        if event.type != "LEFTMOUSE" or event.value != "PRESS":
            return {"RUNNING_MODAL"}
        found = viewport_at(context, event.mouse_x, event.mouse_y)
        if found is None:
            return {"PASS_THROUGH"}
        area, region = found
        self.x, self.y, self.add = event.mouse_x - region.x, event.mouse_y - region.y, event.shift
        with context.temp_override(area=area, region=region):
            missed = self._pick(bpy.context)
        if missed:
            self._tell(context, missed)
            return {"RUNNING_MODAL"}
        return self._end(context, {"FINISHED"})

    def act(self, context):
        if self.properties.is_property_set("location"):
            focus_places.put(context.scene, self.location, add=self.add)
        elif context.region_data is None:
            raise CannotDraw("Without a location, focus is picked in a 3D viewport")
        elif missed := pick(context, (self.x, self.y), self.add):
            raise CannotDraw(missed)

    def _pick(self, context):
        """None, or a sentence on why nothing was picked."""
        try:
            return pick(context, (self.x, self.y), self.add)
        except self.errors as problem:
            return str(problem)

    def _tell(self, context, text):
        """Sets the header text of all 3D viewports, any of which may be clicked; None restores it."""
        for area in context.window.screen.areas:
            if area.type == "VIEW_3D":
                area.header_text_set(text)

    def cancel(self, context):
        self._end(context, None)

    def _end(self, context, result):
        self._tell(context, None)
        context.workspace.status_text_set(None)
        context.window.cursor_modal_restore()
        return result
