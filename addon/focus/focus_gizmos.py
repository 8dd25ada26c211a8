# SPDX-License-Identifier: GPL-3.0-or-later
"""Gizmos of the focus: two rings for the radii of each focus point, and a dot at its center if no object marks it.

Drawing and dragging are in region pixels. Values are set through the RNA properties, so keyframes and undo work.
"""

from itertools import product

import bpy

from ..gpu import overlay as gpu_overlay
from ..scene.problem import CannotDraw
from . import focus_kinds, focus_operators, focus_places

NEAR, FAR = (1.0, 0.55, 0.1), (0.25, 0.6, 1.0)
PARTS = ("middle", "near", "far")
_REACH = 8  # pixels: distance to a ring or a center within which the pointer picks it


class FOVEA_GT_focus_handle(bpy.types.Gizmo):
    """One ring, or the middle, of one place."""

    bl_idname = "FOVEA_GT_focus_handle"
    __slots__ = ("index", "part", "before")

    def place(self, context):
        """The properties of the focus point, or None if it was removed or this part of it cannot be dragged."""
        settings = context.scene.fovea
        if self.index > len(settings.focus_points):
            return None
        place = settings if self.index == 0 else settings.focus_points[self.index - 1]
        marked = not focus_kinds.of(settings).in_frame and place.focus_object
        return None if self.part == "middle" and marked else place

    def seen(self, context):
        """(Look, properties of the focus point, center in pixels, radius in pixels), or None if not visible here."""
        place, kind = self.place(context), focus_kinds.of(context.scene.fovea)
        try:
            look = focus_operators.look(context)
        except CannotDraw:
            return None
        if place is None or kind.no_pull or (kind.in_frame and look.frame is None):
            return None
        middle = look.center(place, kind)
        if middle is None:
            return None
        radius = 0.0 if self.part == "middle" else getattr(place, self.name(kind)) * look.unit(place, kind)
        return look, place, middle, radius

    def name(self, kind):
        """Name of the property that this handle edits."""
        if self.part == "middle":
            return "focus_place" if kind.in_frame else "focus_location"
        return kind.radii[self.part == "far"]

    def draw(self, context):
        found = self.seen(context)
        if found is None:
            return
        _, _, middle, radius = found
        color = FAR if self.part == "far" else NEAR
        if self.is_highlight or self.is_modal:
            color = tuple(0.5 + 0.5 * v for v in color)
        if self.part == "middle":
            gpu_overlay.dot(middle, 5.0, (*color, 1.0))
        else:
            gpu_overlay.ring(middle, radius, (*color, 0.9), 3.0 if self.is_highlight else 2.0)

    def test_select(self, context, location):
        found = self.seen(context)
        if found is None:
            return -1
        _, _, middle, radius = found
        away = ((location[0] - middle.x) ** 2 + (location[1] - middle.y) ** 2) ** 0.5
        return 0 if abs(away - radius) < _REACH else -1

    def invoke(self, context, event):
        place, kind = self.place(context), focus_kinds.of(context.scene.fovea)
        # Dragging one radius may change the other, to keep near <= far.
        names = (self.name(kind),) if self.part == "middle" else kind.radii
        values = {name: getattr(place, name) for name in names}
        self.before = {name: v if isinstance(v, float) else tuple(v) for name, v in values.items()}
        return {"RUNNING_MODAL"}

    def modal(self, context, event, tweak):
        found = self.seen(context)
        if found is not None:
            look, place, middle, _ = found
            kind = focus_kinds.of(context.scene.fovea)
            drag(look, place, kind, self.part, middle, event, slow="PRECISE" in tweak)
            context.area.header_text_set(self.told(place, kind))
        return {"RUNNING_MODAL"}

    def told(self, place, kind):
        value, label = getattr(place, self.name(kind)), place.bl_rna.properties[self.name(kind)].name
        numbers = (value,) if isinstance(value, float) else value
        return f"{label}: {', '.join(f'{v:.3f}' for v in numbers)}"

    def exit(self, context, cancel):
        context.area.header_text_set(None)
        place = self.place(context)
        if place is None:
            return
        for name, value in self.before.items():
            if cancel:
                setattr(place, name, value)
            else:
                focus_places.key(context.scene, place, name)
        if not cancel:
            bpy.ops.ed.undo_push(message="Drag Focus")


def drag(look, place, kind, part, middle, event, slow=False):
    """Sets a focus point's location or radius from the pointer's position; keeps near <= far. `middle`: its center in
    pixels. `slow`: moves a radius by a tenth of the way."""
    px = (event.mouse_region_x, event.mouse_region_y)
    if part == "middle":
        look.move(place, kind, px)
        return
    near, far = kind.radii
    unit = look.unit(place, kind)
    if not unit:
        return
    wanted = ((px[0] - middle[0]) ** 2 + (px[1] - middle[1]) ** 2) ** 0.5 / unit
    name = far if part == "far" else near
    if slow:
        old = getattr(place, name)
        wanted = old + 0.1 * (wanted - old)
    setattr(place, name, wanted)
    if part == "near" and getattr(place, far) < wanted:
        setattr(place, far, wanted)
    if part == "far" and getattr(place, near) > wanted:
        setattr(place, near, wanted)


class VIEW3D_GGT_fovea_focus(bpy.types.GizmoGroup):
    """Places to look at, and their radii."""

    bl_idname = "VIEW3D_GGT_fovea_focus"
    bl_label = "Focus"
    bl_space_type = "VIEW_3D"
    bl_region_type = "WINDOW"
    bl_options = {"PERSISTENT", "SHOW_MODAL_ALL"}

    @classmethod
    def poll(cls, context):
        if context.engine != "FOVEA" or not context.space_data.overlay.show_overlays:
            return False
        kind = focus_kinds.of(context.scene.fovea)
        in_camera = context.region_data.view_perspective == "CAMERA"
        return not kind.no_pull and (in_camera or not kind.in_frame)

    def refresh(self, context):
        wanted = list(product(range(len(focus_places.places(context.scene.fovea))), PARTS))
        if len(self.gizmos) == len(wanted):
            return
        self.gizmos.clear()
        for index, part in wanted:
            handle = self.gizmos.new(FOVEA_GT_focus_handle.bl_idname)
            handle.index, handle.part, handle.use_draw_modal = index, part, True

    setup = refresh
