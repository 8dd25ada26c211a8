# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on the list of places to look at; a click in the viewport picks them, too: focus_operators.py."""

import bpy

from . import focus_places
from ..scene import animation

LISTED = ("IMAGE", "SCENE", "OBJECT")  # models that have places


class FOVEA_OT_focus_place_add(bpy.types.Operator):
    """Look at one more place: the active object, or the middle of the picture"""

    bl_idname, bl_label = "fovea.focus_place_add", "Add Focus Place"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if context.scene is None or context.scene.fovea.focus_model not in LISTED:
            cls.poll_message_set("There is no focus on a place yet: pick one first")
            return False
        return True

    def execute(self, context):
        settings = context.scene.fovea
        try:
            place = focus_places.another(settings, settings.focus_model)
        except ValueError as problem:
            self.report({"WARNING"}, str(problem))
            return {"CANCELLED"}
        active = context.view_layer.objects.active
        if settings.focus_model != "IMAGE" and all(p.focus_object != active for p in focus_places.places(settings)):
            place.focus_object = active
        context.scene.update_tag()
        return {"FINISHED"}


class FOVEA_OT_focus_place_remove(bpy.types.Operator):
    """Look no longer at this place. The object that marks it stays"""

    bl_idname, bl_label = "fovea.focus_place_remove", "Remove Focus Place"
    bl_options = {"REGISTER", "UNDO"}

    index: bpy.props.IntProperty(
        name="Index", description="Of the further places, from 0; -1: the last one", default=-1
    )

    @classmethod
    def poll(cls, context):
        if context.scene is None or not context.scene.fovea.focus_points:
            cls.poll_message_set("There is one place at most: choose None to look at all alike")
            return False
        return True

    def execute(self, context):
        points = context.scene.fovea.focus_points
        gone, count = self.index % len(points) if self.index < 0 else self.index, len(points)
        if gone >= count:
            self.report({"WARNING"}, f"There are only {count} further places")
            return {"CANCELLED"}
        points.remove(gone)
        left = [None if i == gone else i - (i > gone) for i in range(count)]
        animation.follow(context.scene, left, animation.FOCUS_POINT)
        context.scene.update_tag()
        return {"FINISHED"}


CLASSES = (FOVEA_OT_focus_place_add, FOVEA_OT_focus_place_remove)

register, unregister = bpy.utils.register_classes_factory(CLASSES)
