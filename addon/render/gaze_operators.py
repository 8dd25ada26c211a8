# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators of the panel Focus: whether the eye goes to the focus, and as much emphasis as that takes."""

import bpy

from .. import gaze
from ..focus import focus_kinds, focus_places
from ..scene import animation
from ..scene.problem import CannotDraw
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


class _OfEmphasis(_OfFocus):
    """One that changes the emphasis of the scene's style."""

    @classmethod
    def hindrance(cls, context):
        if reason := super().hindrance(context):
            return reason
        tree = style_data.of(context.scene)
        return "The style is linked from another file: duplicate it to edit it" if tree and tree.library else None


class FOVEA_OT_strengthen_focus(_OfEmphasis, bpy.types.Operator):
    """Raise the emphasis of the effects that answer to focus, as little as it takes for the eye to go there first"""

    bl_idname, bl_label = "fovea.strengthen_focus", "Strengthen Focus"

    def act(self, context):
        with progress(context) as tell:
            emphasis, checked = gaze_check.strengthen(context, tell)
        self.show(context, checked)
        tree = style_data.of(context.scene)
        now = tree.fovea.effects if tree else style_data.default().effects
        if emphasis > now.emphasis:
            _set(context.scene, emphasis)
        self.report({"INFO"}, f"Emphasis {emphasis:.2f}. {checked.sentence}")


class FOVEA_OT_strengthen_focus_over_time(_OfEmphasis, bpy.types.Operator):
    """Key the emphasis of the effects that answer to focus over an animation, as little as it takes at each key for the
    eye to go there first; keys of the emphasis between them are removed"""

    bl_idname, bl_label = "fovea.strengthen_focus_over_time", "Strengthen Focus Over Time"

    frame_start: bpy.props.IntProperty(name="Start", description="Frame of the first key", default=1)
    frame_end: bpy.props.IntProperty(name="End", description="Frame of the last key", default=250)
    step: bpy.props.IntProperty(
        name="Step", description="Frames from key to key; each is drawn up to nine times, small", default=12, min=1
    )

    def invoke(self, context, _event):
        self.frame_start, self.frame_end = context.scene.frame_start, context.scene.frame_end
        return context.window_manager.invoke_props_dialog(self)

    def act(self, context):
        if self.frame_end < self.frame_start:
            raise CannotDraw("It ends before it starts: set End to a later frame than Start")
        frames = sorted({*range(self.frame_start, self.frame_end, self.step), self.frame_end})
        with progress(context) as tell:
            by_frame, lost = gaze_check.strengthen_over(context, frames, tell)
        _key(context.scene, by_frame, self.frame_start, self.frame_end)
        told = f"Emphasis {min(by_frame.values()):.2f} to {max(by_frame.values()):.2f}, {len(by_frame)} keys"
        if lost:
            self.report({"WARNING"}, f"{told}; the focus does not win at frame {', '.join(map(str, lost))}")
        else:
            self.report({"INFO"}, told)


def _set(scene, emphasis):
    """Sets the emphasis of a scene's style; where it is keyed, at the current frame."""
    effects = style_data.own(scene).effects
    effects.emphasis = emphasis
    if animation.is_keyed(effects, "emphasis"):
        effects.keyframe_insert("emphasis")
    else:
        focus_places.key(scene, effects, "emphasis")


def _key(scene, by_frame, first, last):
    """Keys the emphasis of a scene's style, {frame: emphasis}, in place of keys from frame `first` to `last`; between
    keys it changes smoothly, and is never beyond both."""
    effects = style_data.own(scene).effects
    for points in _points(effects):
        for i in reversed(range(len(points))):
            if first <= points[i].co.x <= last:
                points.remove(points[i])
    for frame, emphasis in by_frame.items():
        effects.emphasis = emphasis
        effects.keyframe_insert("emphasis", frame=frame)
    for points in _points(effects):
        for point in points:
            if first <= point.co.x <= last:
                point.interpolation = "BEZIER"
                point.handle_left_type = point.handle_right_type = "AUTO_CLAMPED"
    scene.frame_set(scene.frame_current, subframe=scene.frame_subframe)


def _points(effects):
    """The keyframe points of the emphasis, of each F-curve that it has."""
    return [curve.keyframe_points for curve in animation.channels(effects, "emphasis")]
