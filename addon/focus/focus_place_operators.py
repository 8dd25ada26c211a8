# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on the list of focus points; focus_operators.py picks them in a viewport."""

import bpy

from ..scene import animation
from ..scene.operator import Operator
from . import focus_kinds, focus_places, focus_settings


class FOVEA_OT_focus_place_add(Operator, bpy.types.Operator):
    """Look at one more place: the active object, or the middle of the picture"""

    bl_idname, bl_label = "fovea.focus_place_add", "Add Focus Place"
    errors, level = (ValueError,), "WARNING"

    @classmethod
    def hindrance(cls, context):
        listed = context.scene is not None and focus_kinds.of(context.scene.fovea).place
        return None if listed else "There is no focus on a place yet: pick one first"

    def act(self, context):
        settings = context.scene.fovea
        place = focus_places.another(settings)
        active = context.view_layer.objects.active
        if not focus_kinds.of(settings).in_frame and all(
            p.focus_object != active for p in focus_places.places(settings)
        ):
            place.focus_object = active
        context.scene.update_tag()


class FOVEA_OT_focus_place_remove(Operator, bpy.types.Operator):
    """Look no longer at this place. The object that marks it stays"""

    bl_idname, bl_label = "fovea.focus_place_remove", "Remove Focus Place"
    errors, level = (ValueError,), "WARNING"

    index: bpy.props.IntProperty(
        name="Index", description="Of the further places, from 0; -1: the last one", default=-1
    )
    first: bpy.props.BoolProperty(
        name="First", description="Remove the first place: the next one takes its part", options={"SKIP_SAVE"}
    )

    @classmethod
    def hindrance(cls, context):
        several = context.scene is not None and context.scene.fovea.focus_points
        return None if several else "There is one place at most: choose None to look at all alike"

    def act(self, context):
        points = context.scene.fovea.focus_points
        if self.first:
            self.index = 0
            _put_first(context.scene)
        gone, count = self.index % len(points) if self.index < 0 else self.index, len(points)
        if gone >= count:
            raise ValueError(f"There are only {count} further places")
        points.remove(gone)
        left = [None if i == gone else i - (i > gone) for i in range(count)]
        animation.follow(context.scene, left, animation.FOCUS_POINT)
        context.scene.update_tag()


def _put_first(scene):
    """Makes the first place what the second one is, with what animates that."""
    settings, second = scene.fovea, scene.fovea.focus_points[0]
    for name in focus_settings.POINT:
        setattr(settings, name, getattr(second, name))
    animation.take_place(scene, "fovea.focus_points[0].", "fovea.", focus_settings.POINT)
