# SPDX-License-Identifier: GPL-3.0-or-later
"""Submenu of Blender's Render menu, which makes operators searchable with F3. tools_panel.py appends the tools."""

import bpy

from ..scene.registration import classes_of
from ..style import line_set_operators, style_operators

ASKING = ("import", "export", "save")  # style operators that open a dialog, by the last word of their names


class _OfOperators:
    """A menu of `operators` (classes); for an operator with the enum property `choice`, a submenu of its values."""

    def draw(self, _context):
        self.show(self.layout)

    def show(self, layout):
        for cls in self.operators:
            _draw_operator(layout, cls, self.choice)


class TOPBAR_MT_fovea_style(_OfOperators, bpy.types.Menu):
    bl_label = "Style"
    operators, choice = classes_of(style_operators), "style"


class TOPBAR_MT_fovea_line_sets(_OfOperators, bpy.types.Menu):
    bl_label = "Line Sets"
    operators, choice = classes_of(line_set_operators), "direction"


class TOPBAR_MT_fovea(bpy.types.Menu):
    bl_label = "Fovea"

    def draw(self, _context):
        self.layout.menu("TOPBAR_MT_fovea_style")
        self.layout.menu("TOPBAR_MT_fovea_line_sets")


def _draw_operator(layout, cls, choice):
    """Draws an entry for an operator class, or a submenu of the values of its property `choice`, if it has that."""
    if choice in getattr(cls, "__annotations__", ()):
        layout.operator_menu_enum(cls.bl_idname, choice, text=cls.bl_label)
        return
    asks = cls.bl_idname.rpartition("_")[2] in ASKING
    layout.operator(cls.bl_idname, text=f"{cls.bl_label}..." if asks else cls.bl_label)


def _in_render_menu(menu, _context):
    menu.layout.separator()
    menu.layout.menu("TOPBAR_MT_fovea")


def _in_export_menu(menu, _context):
    menu.layout.operator("fovea.export_vectors", text="Fovea Drawing (.svg, .pdf, .dxf, .ora, .png)")


MENUS = {"TOPBAR_MT_render": _in_render_menu, "TOPBAR_MT_file_export": _in_export_menu}
