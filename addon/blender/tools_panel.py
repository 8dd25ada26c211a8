"""Where the operators are found: a panel of the 3D view's Fovea tab, and a menu, whose entries F3 finds."""

import bpy

LINES = ("fovea.render_lines", "fovea.bake_strokes", "fovea.match_freestyle", "fovea.report")


class VIEW3D_PT_fovea_tools(bpy.types.Panel):
    bl_label = "Tools"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Fovea"
    bl_order = 10  # below what one draws with

    def draw(self, context):
        column = self.layout.column(align=True)
        column.operator("fovea.pick_focus", icon="EYEDROPPER")
        column.operator("fovea.focus_pull", icon="DECORATE_ANIMATE")
        if context.engine == "FOVEA":
            self.layout.prop(context.window_manager, "fovea_show_focus")
        column = self.layout.column(align=True)
        for name in LINES:
            column.operator(name)


class VIEW3D_MT_fovea(bpy.types.Menu):
    bl_label = "Fovea"

    def draw(self, context):
        self.layout.operator("fovea.pick_focus")
        self.layout.operator_context = "INVOKE_DEFAULT"
        self.layout.operator("fovea.focus_pull")
        self.layout.separator()
        for name in LINES:
            self.layout.operator(name)


def _in_menu(self, _context):
    self.layout.separator()
    self.layout.menu("VIEW3D_MT_fovea")


CLASSES = (VIEW3D_PT_fovea_tools, VIEW3D_MT_fovea)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.TOPBAR_MT_render.append(_in_menu)


def unregister():
    bpy.types.TOPBAR_MT_render.remove(_in_menu)
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
