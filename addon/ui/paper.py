# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels: the color layer and the paper."""

import bpy

from .. import style
from ..style import style_data
from ..style.style_groups import plain_fields
from .common import StylePanel, draw_properties


def _drawn(held):
    """Whether the style has a color layer."""
    return held.color.shading != "PLAIN"


class RENDER_PT_fovea_color(StylePanel, bpy.types.Panel):
    bl_label = "Color"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, context):
        held = style_data.of(context.scene).fovea
        color, drawn = held.color, _drawn(held)
        layout.prop(color, "shading")
        draw_properties(layout, color, ("bands",), color.shading == "TOON")
        draw_properties(layout, color, ("shadow", "blacks"), drawn)
        draw_properties(layout, color, ("black_color",), drawn and color.blacks > 0)
        draw_properties(layout, color, ("opacity", "desaturation", "edge_darkening", "backruns", "on_paper"), drawn)
        draw_properties(layout, color, ("background",), drawn and not color.on_paper)


class RENDER_PT_fovea_paper(StylePanel, bpy.types.Panel):
    bl_label = "Paper"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, context):
        held = style_data.of(context.scene).fovea
        for field in plain_fields(style.Paper):
            draw_properties(layout, held.paper, (field["name"],), self.heeded(field["name"], held))

    @staticmethod
    def heeded(name, held):
        """Whether a member of the paper has an effect."""
        paper = held.paper
        if name in ("scale", "tooth", "tint"):
            return paper.texture != "none"
        return name != "granulation" or (paper.texture != "none" and _drawn(held))
