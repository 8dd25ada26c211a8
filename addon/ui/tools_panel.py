# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators in a panel of the 3D view's Fovea tab, and in a menu that makes them searchable with F3."""

import bpy

LINES = (
    *("fovea.render_cameras", "fovea.render_lines", "fovea.bake_strokes", "fovea.bake_marks"),
    *("fovea.match_freestyle", "fovea.match_line_art", "fovea.report"),
)


class VIEW3D_PT_fovea_tools(bpy.types.Panel):
    bl_label = "Tools"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Fovea"
    bl_order = 10  # below the other panels

    def draw(self, context):
        column = self.layout.column(align=True)
        for name in LINES:
            column.operator(name)


def _in_menu(self, _context):
    """Entries at the end of Render > Fovea, so that F3 (search) finds the operators."""
    self.layout.separator()
    for name in ("pick_focus", "focus_place_add", "focus_place_remove"):
        self.layout.operator(f"fovea.{name}")
    self.layout.operator_context = "INVOKE_DEFAULT"
    self.layout.operator("fovea.focus_pull", text="Focus Pull...")
    for name in ("check_focus", "strengthen_focus"):
        self.layout.operator(f"fovea.{name}")
    self.layout.operator("fovea.strengthen_focus_over_time", text="Strengthen Focus Over Time...")
    self.layout.separator()
    for name in LINES:
        self.layout.operator(name)
    self.layout.operator("fovea.export_vectors", text="Export Fovea Drawing...")
    self.layout.operator("fovea.compare_drawing", text="Compare with Drawing...")
    self.layout.operator("fovea.register_drawing", text="Register Drawing...")
    self.layout.operator("fovea.fit_style", text="Fit Style to Drawing...")
    self.layout.operator("fovea.learn_lines", text="Learn Lines from Drawing...")
    self.layout.operator("fovea.set_gauges", text="Set Gauges of a Study...")
    for name in ("standard_view", "freestyle_off", "line_art_off"):
        self.layout.operator(f"fovea.{name}")


MENUS = {"TOPBAR_MT_fovea": _in_menu}
