# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels of the 3D view's sidebar: style, focus and lines."""

import bpy

from ..focus import focus_kinds
from ..style import style_data
from ..style.line_set_operators import edited
from .common import ENGINE, draw_pen
from .focus import draw_check, draw_focus
from .hints import draw_hints
from .lines import draw_list
from .style import draw_style


class _SidePanel:
    """Base of panels in the tab Fovea; shown with any engine if the scene has a style, as Render Line Layer to Image
    works with all engines."""

    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "Fovea"

    @classmethod
    def poll(cls, context):
        return context.engine == ENGINE or style_data.of(context.scene) is not None

    def draw(self, context):
        self.layout.use_property_split = True
        self.show(self.layout, context)


class VIEW3D_PT_fovea_style(_SidePanel, bpy.types.Panel):
    bl_label = "Style"

    def show(self, layout, context):
        if context.engine == ENGINE:
            draw_hints(layout, context.scene)
        draw_style(layout, context)


class VIEW3D_PT_fovea_focus(_SidePanel, bpy.types.Panel):
    bl_label = "Focus"

    def show(self, layout, context):
        draw_focus(layout, context.scene.fovea)
        tools = layout.column(align=True)
        tools.operator("fovea.pick_focus", icon="EYEDROPPER")
        if focus_kinds.of(context.scene.fovea).place:
            tools.operator("fovea.focus_place_add", icon="ADD")
        tools.operator("fovea.focus_pull", icon="DECORATE_ANIMATE")
        shown = layout.column()
        shown.active = focus_kinds.of(context.scene.fovea).is_on
        shown.prop(context.window_manager, "fovea_show_focus")
        draw_check(layout)


class VIEW3D_PT_fovea_lines(_SidePanel, bpy.types.Panel):
    bl_label = "Lines"

    @classmethod
    def poll(cls, context):
        return super().poll(context) and style_data.of(context.scene) is not None

    def show(self, layout, context):
        held = style_data.of(context.scene).fovea
        draw_list(layout, held)
        if line_set := edited(held):
            draw_pen(layout, line_set.pen, 3)  # the other groups are in the render tab
