# SPDX-License-Identifier: GPL-3.0-or-later
"""How viewports are drawn: a setting of the scene, and its panel."""

import bpy

PANEL_ENGINE = "FOVEA"


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


class RENDER_PT_fovea_viewport(bpy.types.Panel):
    bl_label = "Viewport"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"
    bl_parent_id = "RENDER_PT_fovea_performance"
    COMPAT_ENGINES = {PANEL_ENGINE}

    @classmethod
    def poll(cls, context):
        return context.engine in cls.COMPAT_ENGINES

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.use_property_decorate = False
        self.layout.prop(context.scene.fovea_viewport, "budget_ms")


def budget_ms(scene):
    """Milliseconds for a draw of a scene's viewports while something changes."""
    return scene.fovea_viewport.budget_ms


CLASSES = (FoveaViewportSettings, RENDER_PT_fovea_viewport)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Scene.fovea_viewport = bpy.props.PointerProperty(type=FoveaViewportSettings)


def unregister():
    del bpy.types.Scene.fovea_viewport
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
