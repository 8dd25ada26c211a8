# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on whole styles: create, apply, copy, import, export, save, rename and delete."""

from pathlib import Path

import bpy
from bpy.props import BoolProperty, EnumProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

from .. import files, style
from ..focus import focus_settings
from ..scene import animation
from ..scene.operator import Operator
from . import style_data, style_files, style_read

_items = {}  # references to enum items, which Blender does not keep alive itself


def _enum(key, names):
    _items[key] = [(name, style_data.title(name), "") for name in names] or [("NONE", "None", "There is none")]
    return _items[key]


def _all(_self, _context):
    return _enum("all", style_files.names())


def _users(_self, _context):
    return _enum("users", style_files.user_names())


class StyleOperator(Operator):
    """What all of them have: files' troubles as one sentence."""

    errors = (OSError, ValueError)

    @staticmethod
    def sentence(error):
        told = isinstance(error, (style.StyleError, files.NotWritten))
        return str(error) if told else f"Fovea cannot do that: {error}"


class OnStyle(StyleOperator):
    """Of the scene's own style."""

    @classmethod
    def hindrance(cls, context):
        if style_data.of(context.scene) is None:
            return "The scene draws with the default style: press New for a style of its own"
        return cls.hindrance_of(style_data.of(context.scene))

    @classmethod
    def hindrance_of(cls, tree):
        """Why the operator is unavailable for the style's node tree, or None."""


class FOVEA_OT_style_new(StyleOperator, bpy.types.Operator):
    """Give the scene a style of its own to edit: the default style of the preferences, unless another is named"""

    bl_idname, bl_label = "fovea.style_new", "New Style"

    # If unset, it is the first item.
    style: EnumProperty(name="From", description="The style it begins as", items=_all, options={"SKIP_SAVE"})

    def act(self, context):
        tree = style_data.new("Style", style_files.load(self.style))
        style_data.note_source(tree, self.style)
        style_data.assign(context.scene, tree)


class FOVEA_OT_style_apply(StyleOperator, bpy.types.Operator):
    """Draw the scene in this style. A style that was edited before stays in the file"""

    bl_idname, bl_label = "fovea.style_apply", "Apply Style"

    style: EnumProperty(name="Style", description="One that ships, or one of yours", items=_all)

    @classmethod
    def description(cls, _context, properties):
        return f"Draw the scene in the style {style_data.title(properties.style)}; an edited one stays in the file"

    def act(self, context):
        style_data.use(context.scene, style_files.load(self.style), style_data.title(self.style))
        style_data.note_source(style_data.of(context.scene), self.style)


class FOVEA_OT_style_duplicate(OnStyle, bpy.types.Operator):
    """Draw the scene in a copy of its style, and leave the style itself to others"""

    bl_idname, bl_label = "fovea.style_duplicate", "Duplicate Style"

    def act(self, context):
        copy = style_data.of(context.scene).copy()
        animation.own_action(copy)
        context.scene.fovea.style = copy


class FOVEA_OT_style_import(StyleOperator, bpy.types.Operator, ImportHelper):
    """Draw the scene in a style from a JSON file"""

    bl_idname, bl_label = "fovea.style_import", "Import Style"
    filename_ext = ".json"

    filter_glob: StringProperty(default="*.json", options={"HIDDEN"})

    def act(self, context):
        found = style.read(self.filepath)
        if remark := style.remark(found):
            self.report({"INFO"}, remark)
        style_data.use(context.scene, found, style_data.title(Path(self.filepath).stem) or "Style")


class FOVEA_OT_style_export(OnStyle, bpy.types.Operator, ExportHelper):
    """Write the scene's style to a JSON file, its numbers as they are at this frame"""

    bl_idname, bl_label = "fovea.style_export", "Export Style"
    bl_options = {"REGISTER"}
    filename_ext = ".json"

    filter_glob: StringProperty(default="*.json", options={"HIDDEN"})
    with_focus: BoolProperty(name="Focus", description="Write where this scene looks, too", default=False)

    def act(self, context):
        found = style_read.read(style_data.of(context.scene))
        if self.with_focus:
            found = found.replace(focus=focus_settings.focus_of(context.scene.fovea))
        style_files.write(self.filepath, found)


class FOVEA_OT_style_save(OnStyle, bpy.types.Operator):
    """Keep the scene's style as a preset, for other files. A preset of yours with that name is replaced"""

    bl_idname, bl_label = "fovea.style_save", "Save Style Preset"
    bl_options = {"UNDO"}  # no REGISTER: changing the name in the redo panel would write another file

    name: StringProperty(name="Name", description="Of the style; none: as the scene's is named", maxlen=60)

    def invoke(self, context, _event):
        self.name = style_data.of(context.scene).name
        return context.window_manager.invoke_props_dialog(self, confirm_text="Save")

    def act(self, context):
        tree = style_data.of(context.scene)
        name = style_files.file_name(self.name or tree.name)
        path = style_files.save(name, style_read.read(tree))
        style_data.note_source(tree, name)
        self.report({"INFO"}, f"Saved as {path}")


class FOVEA_OT_style_update(OnStyle, bpy.types.Operator):
    """Write the scene's style over the preset that it came from, with its numbers as they are at this frame. This
    cannot be undone"""

    bl_idname, bl_label = "fovea.style_update", "Update Style Preset"
    bl_options = {"REGISTER"}

    @classmethod
    def hindrance_of(cls, tree):
        source = tree.fovea.source
        if source in style_files.user_names():
            return None
        gone = f"The preset '{source}' is no more" if source else "This style does not come from a preset of yours"
        return f"{gone}: press Save Preset to keep it as one"

    def invoke(self, context, event):
        source = style_data.of(context.scene).fovea.source
        words = {"title": f"Write over the preset '{source}'?", "confirm_text": "Update"}
        return context.window_manager.invoke_confirm(self, event, **words)

    def act(self, context):
        tree = style_data.of(context.scene)
        path = style_files.save(tree.fovea.source, style_read.read(tree))
        self.report({"INFO"}, f"Updated {path}")


class _OnSaved(StyleOperator):
    """Of one of the user's presets."""

    bl_options = {"REGISTER"}

    @classmethod
    def hindrance(cls, _context):
        return None if style_files.user_names() else "There are no presets of yours: Save Preset keeps one"


class FOVEA_OT_style_rename(_OnSaved, bpy.types.Operator):
    """Give one of your presets another name. This cannot be undone"""

    bl_idname, bl_label = "fovea.style_rename", "Rename Style Preset"

    style: EnumProperty(name="Style", description="One of yours", items=_users)
    name: StringProperty(name="Name", description="The name it shall have", maxlen=60)

    def invoke(self, context, _event):
        self.name = style_data.title(self.style)
        return context.window_manager.invoke_props_dialog(self, confirm_text="Rename")

    def act(self, _context):
        # Read first: after renaming, the enum no longer has the old name.
        old, fresh = self.style, style_files.file_name(self.name)
        if fresh != old:
            style_files.rename(old, fresh)
            style_data.follow_source(old, fresh)


class FOVEA_OT_style_delete(_OnSaved, bpy.types.Operator):
    """Delete one of your presets; scenes that draw with it keep theirs. This cannot be undone"""

    bl_idname, bl_label = "fovea.style_delete", "Delete Style Preset"

    style: EnumProperty(name="Style", description="One of yours", items=_users)

    def invoke(self, context, event):
        return context.window_manager.invoke_confirm(self, event)

    def act(self, _context):
        style_files.delete(self.style)
