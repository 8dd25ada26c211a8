"""The sidebar of the 3D view: what one needs while working."""

import bpy

from .. import style_data
from ..line_set_operators import edited
from .common import ENGINE, draw_pen, fold
from .effects import draw_focus
from .lines import draw_list
from .style import draw_gallery, draw_style


class VIEW3D_PT_fovea(bpy.types.Panel):
    bl_label = "Fovea"
    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "Fovea"

    @classmethod
    def poll(cls, context):
        return context.engine == ENGINE

    def draw(self, context):
        self.layout.use_property_split = True
        self.show(self.layout, context)

    def show(self, layout, context):
        draw_style(layout, context)
        body = fold(layout, "side_gallery", "Gallery")
        if body:
            draw_gallery(body)
        body = fold(layout, "side_focus", "Focus", closed=False)
        if body:
            draw_focus(body, context.scene.fovea)
            tools = body.row(align=True)
            tools.operator("fovea.pick_focus", text="Pick", icon="EYEDROPPER")
            tools.operator("fovea.focus_pull", text="Pull", icon="DECORATE_ANIMATE")
            tools.prop(context.window_manager, "fovea_show_focus", text="", icon="HIDE_OFF")
        tree = style_data.of(context.scene)
        body = fold(layout, "side_lines", "Lines", closed=False) if tree else None
        if body:
            draw_list(body, tree.fovea)
            line_set = edited(tree.fovea)
            if line_set:
                draw_pen(body, line_set.pen)


CLASSES = (VIEW3D_PT_fovea,)
