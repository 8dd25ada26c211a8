# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators of the panel Focus: whether the eye goes to the focus, and as much emphasis as that takes."""

import bpy

from .. import gaze
from ..focus import focus_kinds, focus_places
from ..scene import animation
from ..style import style_data
from . import gaze_check
from .line_operators import OfRender, image_of, linear, open_image, progress

NAME = "Gaze"


class _OfFocus(OfRender):
    """One that draws the scene to see where the eye goes, and shows that in a new image."""

    @classmethod
    def hindrance(cls, context):
        if reason := super().hindrance(context):
            return reason
        on = focus_kinds.of(context.scene.fovea).is_on
        return None if on else gaze_check.NO_FOCUS

    def show(self, context, checked):
        image = image_of(NAME, linear(gaze.heat(checked.gaze)))
        if not bpy.app.background:
            open_image(context, image)


class FOVEA_OT_check_focus(_OfFocus, bpy.types.Operator):
    """Draw the frame small, predict where the eye goes first by what stands out (which knows neither faces nor words),
    and show that as a heat map in a new image"""

    bl_idname, bl_label = "fovea.check_focus", "Check Focus"

    def act(self, context):
        with progress(context) as tell:
            checked = gaze_check.check(context, tell)
        self.show(context, checked)
        wins = checked.judged is not None and checked.judged.wins
        self.report({"INFO"} if wins else {"WARNING"}, checked.sentence)


class FOVEA_OT_strengthen_focus(_OfFocus, bpy.types.Operator):
    """Raise the emphasis of the effects that answer to focus, as little as it takes for the eye to go there first"""

    bl_idname, bl_label = "fovea.strengthen_focus", "Strengthen Focus"

    @classmethod
    def hindrance(cls, context):
        if reason := super().hindrance(context):
            return reason
        tree = style_data.of(context.scene)
        return "The style is linked from another file: duplicate it to edit it" if tree and tree.library else None

    def act(self, context):
        with progress(context) as tell:
            emphasis, checked = gaze_check.strengthen(context, tell)
        self.show(context, checked)
        tree = style_data.of(context.scene)
        now = tree.fovea.effects if tree else style_data.default().effects
        if emphasis > now.emphasis:
            _set(context.scene, emphasis)
        self.report({"INFO"}, f"Emphasis {emphasis:.2f}. {checked.sentence}")


def _set(scene, emphasis):
    """Sets the emphasis of a scene's style; where it is keyed, at the current frame."""
    effects = style_data.own(scene).effects
    effects.emphasis = emphasis
    if animation.is_keyed(effects, "emphasis"):
        effects.keyframe_insert("emphasis")
    else:
        focus_places.key(scene, effects, "emphasis")
