# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel: the section plane, and the scale at which the picture lies on paper."""

import bpy

from ..render import drawing_scale
from ..style import style_data
from .common import FoveaPanel, draw_properties


class RENDER_PT_fovea_to_scale(FoveaPanel, bpy.types.Panel):
    bl_label = "Section and Scale"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, context):
        scene = context.scene
        _draw_section(layout, scene)
        layout.separator()
        _draw_scale(layout, scene)


def _draw_section(layout, scene):
    row = layout.row(align=True)
    row.prop(scene.fovea, "section")
    row.operator("fovea.section_add", text="", icon="ADD")
    if tree := style_data.of(scene):
        held = tree.fovea.section
        draw_properties(layout, held, ("filled",), scene.fovea.section is not None)
        draw_properties(layout, held, ("color",), scene.fovea.section is not None and held.filled)


def _draw_scale(layout, scene):
    reason = drawing_scale.hindrance(scene)
    draw_properties(layout, scene.fovea, ("drawing_scale",), reason is None)
    if reason:
        layout.label(text=reason.partition(":")[0], icon="INFO")
    if tree := style_data.of(scene):
        layout.prop(tree.fovea.paper, "height_mm")
        layout.operator("fovea.sheet", text="Sheet of Paper...")
