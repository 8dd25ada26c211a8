# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel: the scene's style, with the gallery of styles."""

import bpy

from .. import catalogue, native, style
from ..style import style_data, style_files
from .common import FoveaPanel
from .gallery import draw_gallery


class RENDER_PT_fovea_style(FoveaPanel, bpy.types.Panel):
    bl_label = "Style"
    of_followers = True  # they may have a style of their own

    def show(self, layout, context):
        try:
            catalogue.definitions()
        except native.Unavailable as error:
            layout.label(text=str(error), icon="ERROR")
            return
        draw_style(layout, context)
        files = layout.grid_flow(row_major=True, columns=2, even_columns=True, align=True)
        files.operator("fovea.style_import", text="Import")
        files.operator("fovea.style_export", text="Export")
        files.operator("fovea.style_save", text="Save Preset")
        files.operator("fovea.style_update", text="Update Preset")
        if style_files.user_names():
            files.operator_menu_enum("fovea.style_rename", "style", text="Rename Preset")
            files.operator_menu_enum("fovea.style_delete", "style", text="Delete Preset")
        row = layout.row(align=True)
        row.operator("fovea.style_mark_asset", text="Mark as Asset", icon="ASSET_MANAGER")
        row.operator("fovea.style_clear_asset", text="", icon="X")
        mixing = layout.column()
        mixing.use_property_split = True
        mixing.prop(context.scene.fovea, "mixed_style", placeholder="Style")
        factor = mixing.column()
        factor.enabled = context.scene.fovea.mixed_style is not None
        factor.prop(context.scene.fovea, "mix")


def draw_style(layout, context):
    """Draws the gallery, and the selector of the scene's style with a button to create or copy one."""
    draw_gallery(layout, context)
    settings = context.scene.fovea
    own = style_data.of(context.scene) is not None
    layout.template_ID(settings, "style", new="fovea.style_duplicate" if own else "fovea.style_new")
    if not own:
        layout.label(text=f"{style_data.title(style.DEFAULT)}, as it ships", icon="INFO")
