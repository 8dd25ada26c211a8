"""The submenu of Blender's Render menu: what F3 finds."""

import bpy

from ..line_set_operators import CLASSES as LINE_SETS


class TOPBAR_MT_fovea(bpy.types.Menu):
    bl_label = "Fovea"

    def draw(self, _context):
        self.show(self.layout)

    def show(self, layout):
        layout.operator_menu_enum("fovea.style_new", "style", text="New Style")
        layout.operator_menu_enum("fovea.style_apply", "style", text="Apply Style")
        for name in ("duplicate", "import", "export", "save", "update"):
            layout.operator(f"fovea.style_{name}")
        layout.operator_menu_enum("fovea.style_rename", "style", text="Rename Saved Style")
        layout.operator_menu_enum("fovea.style_delete", "style", text="Delete Saved Style")
        layout.separator()
        for cls in LINE_SETS:
            if "direction" in getattr(cls, "__annotations__", ()):
                layout.operator_menu_enum(cls.bl_idname, "direction", text=cls.bl_label)
            else:
                layout.operator(cls.bl_idname)


def append(menu, _context):
    menu.layout.menu("TOPBAR_MT_fovea")


CLASSES = (TOPBAR_MT_fovea,)
