# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel: elision, its priority weights and its density."""

import bpy

from .. import style
from ..style import style_data
from ..style.style_groups import plain_fields
from . import thumbnails
from .common import StylePanel, draw_painted, draw_properties, fold

PICTURES = style.FOLDER  # beside the thumbnails of styles, which the same script draws
PAINTED = "painted"  # the weight that has an effect only with a painted attribute


class RENDER_PT_fovea_elision(StylePanel, bpy.types.Panel):
    bl_label = "Line Thinning"
    bl_options = {"DEFAULT_CLOSED"}

    def draw_header(self, context):
        self.layout.prop(style_data.of(context.scene).fovea.elision, "enabled", text="")

    def show(self, layout, context):
        elision = style_data.of(context.scene).fovea.elision
        layout.active = elision.enabled
        if context.scene.fovea.visibility == "SPINE":
            layout.label(text="No thinning: Per Pixel visibility knows too late what is seen", icon="INFO")
        _draw_pictures(layout)
        draw_properties(layout, elision, ("fade_from", "cut", "frames"))
        if body := fold(layout, "elision_priority", "Priority"):
            body.active = elision.enabled
            weights = [f["name"] for f in plain_fields(style.Elision) if f["group"] == "weights"]
            draw_properties(body, elision, [name for name in weights if name != PAINTED])
            draw_painted(body, elision, "priority_attribute", context.object)
            draw_properties(body, elision, (PAINTED,), bool(elision.priority_attribute))
        if body := fold(layout, "elision_density", "Density"):
            body.active = elision.enabled
            draw_painted(body, elision, "density_attribute", context.object)
            body.prop(elision, "density_image")


def _draw_pictures(layout):
    """Draws what thinning does: boards, whose edges crowd far away, without and with it."""
    row = layout.row()
    for word in ("Off", "On"):
        column = row.column(align=True)
        column.template_icon(icon_value=thumbnails.icon_of_file(PICTURES / f"thinning_{word.lower()}.jpg"), scale=5.0)
        name = column.row()
        name.alignment = "CENTER"
        name.label(text=word)
