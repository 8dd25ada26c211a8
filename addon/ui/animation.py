# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel: how drawings follow each other in an animation."""

import bpy

from ..style import style_data
from .common import StylePanel, draw_properties


class RENDER_PT_fovea_animation(StylePanel, bpy.types.Panel):
    bl_label = "Animation"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, context):
        animation = style_data.of(context.scene).fovea.animation
        boils = animation.boil > 0
        draw_properties(layout, animation, ("written", "hold", "boil"))
        draw_properties(layout, animation, ("boil_hold", "boil_cycle"), boils)
        draw_properties(layout, animation, ("start_frame",), boils or animation.hold > 1)
        draw_properties(layout, animation, ("visibility_frames",))
        draw_properties(layout, animation, ("vanish",), animation.visibility_frames > 0)
