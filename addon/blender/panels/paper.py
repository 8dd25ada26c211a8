"""Panel: the colours under the lines, and the paper."""

import bpy

from ...style_parts import Paper
from .. import style_data
from ..style_groups import plain_fields
from .common import StylePanel, draw_properties


class RENDER_PT_fovea_paper(StylePanel, bpy.types.Panel):
    bl_label = "Colour and Paper"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, context):
        held = style_data.of(context.scene).fovea
        color, paper, drawn = held.color, held.paper, held.color.shading != "PLAIN"
        layout.prop(color, "shading")
        draw_properties(layout, color, ("bands",), color.shading == "TOON")
        draw_properties(layout, color, ("opacity", "desaturation", "on_paper"), drawn)
        draw_properties(layout, color, ("background",), drawn and not color.on_paper)
        for name, _ in plain_fields(Paper):
            draw_properties(layout, paper, (name,), _heeded(name, paper, drawn))


def _heeded(name, paper, drawn):
    if name in ("scale", "tooth", "tint"):
        return paper.texture != "none"
    return name != "granulation" or (paper.texture != "none" and drawn)


CLASSES = (RENDER_PT_fovea_paper,)
