# SPDX-License-Identifier: GPL-3.0-or-later
"""Pick Focus as a tool of the 3D view's toolbar, and the key that chooses it."""

import bpy

TOOL = "fovea.pick_focus_tool"
KEY = {"type": "F", "value": "PRESS", "alt": True}  # in Object mode; Blender has no other use for it there

_items = []  # (keymap, item) of the key


class PickFocusTool(bpy.types.WorkSpaceTool):
    bl_space_type, bl_context_mode = "VIEW_3D", "OBJECT"
    bl_idname, bl_label = TOOL, "Pick Focus"
    bl_description = "Click what to look at; Shift adds another place"
    bl_icon, bl_cursor = "ops.paint.eyedropper_add", "EYEDROPPER"
    bl_keymap = tuple(
        (
            "fovea.pick_focus",
            {"type": "LEFTMOUSE", "value": "PRESS", "shift": add},
            {"properties": [("here", True), ("add", add)]},
        )
        for add in (False, True)
    )


def register():
    bpy.utils.register_tool(PickFocusTool, separator=True)
    if keys := bpy.context.window_manager.keyconfigs.addon:  # none without a window
        keymap = keys.keymaps.new("Object Mode")
        item = keymap.keymap_items.new("wm.tool_set_by_id", **KEY)
        item.properties.name = TOOL
        _items.append((keymap, item))


def unregister():
    for keymap, item in _items:
        keymap.keymap_items.remove(item)
    _items.clear()
    bpy.utils.unregister_tool(PickFocusTool)
