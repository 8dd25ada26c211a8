# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene's setting for viewports, and its panel."""

import bpy

from .common import FoveaPanel


class FoveaViewportSettings(bpy.types.PropertyGroup):
    budget_ms: bpy.props.IntProperty(
        name="Draw Time (ms)",
        description="Milliseconds that Fovea may take to draw a viewport while something changes: what takes longer is "
        "left out or drawn coarsely until all rests. Renders are not affected",
        default=33,
        min=1,
        soft_min=10,
        soft_max=500,
        max=10000,
    )


class RENDER_PT_fovea_viewport(FoveaPanel, bpy.types.Panel):
    bl_label = "Viewport"
    bl_parent_id = "RENDER_PT_fovea_performance"

    def show(self, layout, context):
        layout.use_property_decorate = False
        layout.prop(context.scene.fovea_viewport, "budget_ms")


def register():
    bpy.types.Scene.fovea_viewport = bpy.props.PointerProperty(type=FoveaViewportSettings)


def unregister():
    del bpy.types.Scene.fovea_viewport
