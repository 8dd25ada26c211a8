# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel: how drawings follow each other in an animation."""

import bpy

from ..scene import followed
from ..style import style_data
from .common import StylePanel, draw_properties, fold, fold_switch


class RENDER_PT_fovea_animation(StylePanel, bpy.types.Panel):
    bl_label = "Animation"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, context):
        animation = style_data.of(context.scene).fovea.animation
        boils = animation.boil > 0
        draw_properties(layout, animation, ("written", "hold", "boil"))
        draw_properties(layout, animation, ("boil_hold", "boil_cycle"), boils)
        counts = boils or animation.hold > 1 or animation.marks_frames > 0
        draw_properties(layout, animation, ("start_frame",), counts)
        draw_properties(layout, animation, ("visibility_frames",))
        draw_properties(layout, animation, ("vanish",), animation.visibility_frames > 0)
        draw_properties(layout, animation, ("marks_frames", "marks_baked"))
        if animation.marks_baked:
            layout.operator("fovea.bake_marks")
        if body := fold_switch(layout, "motion_blur", animation, "motion_blur"):
            _draw_motion_blur(body, animation, followed.of(context.scene).render)


def _draw_motion_blur(layout, animation, render):
    """Draws the samples, and the scene's shutter: Blender shows it for its own engines alone."""
    layout.use_property_split = True
    draw_properties(layout, animation, ("motion_samples",))
    column = draw_properties(layout, render, ("use_motion_blur",))
    draw_properties(column, render, ("motion_blur_position", "motion_blur_shutter"), render.use_motion_blur)
    if body := fold(column, "shutter_curve", "Shutter Curve"):
        body.template_curve_mapping(render, "motion_blur_shutter_curve")
