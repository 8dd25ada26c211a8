# SPDX-License-Identifier: GPL-3.0-or-later
"""Styles as assets: operators to mark them, with a thumbnail that Fovea renders, and to use them from the Asset Browser
or the asset shelf of the 3D view."""

from pathlib import Path

import bpy
import numpy as np
from bpy.props import EnumProperty, StringProperty

from .. import native, style
from . import style_data, style_picture, style_read
from .style_operators import OnStyle, StyleOperator

MARK = "fovea_style"  # metadata key that identifies a style asset before its datablock is loaded
TAG = "Fovea"
IMPORTS = [
    ("FOLLOW", "As the Browser Says", "The import method of the Asset Browser or of the asset library"),
    ("LINK", "Link", "The style stays in its file, and what changes there changes here"),
    ("APPEND", "Append", "A copy of the style comes into this file"),
    ("APPEND_REUSE", "Append, Reuse", "A copy of the style comes into this file, unless there is one already"),
    ("PACK", "Pack", "The style stays linked, and its data comes into this file; before Blender 5: linked"),
]


class FOVEA_OT_style_mark_asset(OnStyle, bpy.types.Operator):
    """Show the scene's style in the Asset Browser, with a thumbnail of it as it is now; again: renew what it shows"""

    bl_idname, bl_label = "fovea.style_mark_asset", "Mark Style as Asset"

    # SKIP_SAVE: the values for one style are not the defaults for the next.
    description: StringProperty(name="Description", description="What others read of the style", options={"SKIP_SAVE"})
    author: StringProperty(name="Author", description="Who made the style")
    tags: StringProperty(
        name="Tags", description=f"Words to find it by, with commas between; {TAG} is always one", options={"SKIP_SAVE"}
    )

    @classmethod
    def hindrance_of(cls, tree):
        return "The style is linked: open its own file to make it an asset, or duplicate it" if tree.library else None

    def invoke(self, context, _event):
        if known := style_data.of(context.scene).asset_data:
            self.description, self.author = known.description, known.author
            self.tags = ", ".join(tag.name for tag in known.tags if tag.name != TAG)
        return context.window_manager.invoke_props_dialog(self)

    def act(self, context):
        tree = style_data.of(context.scene)
        tree.asset_mark()
        told = tree.asset_data
        told[MARK] = 1
        told.description, told.author = self.description, self.author
        while told.tags:
            told.tags.remove(told.tags[0])
        for tag in (TAG, *(word.strip() for word in self.tags.split(","))):
            if tag:
                told.tags.new(tag, skip_if_exists=True)
        if problem := native.problem():
            self.report({"WARNING"}, f"The asset has no thumbnail: {problem}")
        else:
            show(tree, style_picture.draw(style_read.read(tree)))


class FOVEA_OT_style_clear_asset(OnStyle, bpy.types.Operator):
    """Take the scene's style out of the Asset Browser; the style itself stays"""

    bl_idname, bl_label = "fovea.style_clear_asset", "Clear Style Asset"

    @classmethod
    def hindrance_of(cls, tree):
        if tree.library:
            return "The style is linked: only its own file says whether it is an asset"
        return None if tree.asset_data else "The style is no asset"

    def act(self, context):
        style_data.of(context.scene).asset_clear()


class FOVEA_OT_style_use_asset(StyleOperator, bpy.types.Operator):
    """Draw the scene in this style of the Asset Browser, linked or appended as the browser's import method says"""

    bl_idname, bl_label = "fovea.style_use_asset", "Use Fovea Style"

    filepath: StringProperty(
        name="File", description="The .blend file of the style; none: the chosen asset's", options={"SKIP_SAVE"}
    )
    name: StringProperty(name="Name", description="Of the style in that file", options={"SKIP_SAVE"})
    method: EnumProperty(
        name="Import", description="How the style comes into this file", items=IMPORTS, options={"SKIP_SAVE"}
    )
    # Set by an asset shelf for the asset that is clicked.
    asset_library_type: StringProperty(options={"HIDDEN", "SKIP_SAVE"})
    asset_library_identifier: StringProperty(options={"HIDDEN", "SKIP_SAVE"})
    relative_asset_identifier: StringProperty(options={"HIDDEN", "SKIP_SAVE"})

    def invoke(self, context, _event):
        asset = getattr(context, "asset", None)
        if not self.relative_asset_identifier and asset is not None:
            self.filepath, self.name = asset.full_library_path, asset.name
            if self.method == "FOLLOW":
                self.method = _browser_method(context) or method_of(self.filepath)
        return self.execute(context)

    def act(self, context):
        if self.relative_asset_identifier:
            self.filepath, self.name = _in_shelf(self)
        if not self.name:
            raise style.StyleError("Choose a Fovea style in the Asset Browser first")
        method = method_of(self.filepath) if self.method == "FOLLOW" else self.method
        tree = brought(self.filepath, self.name, method) if self.filepath else bpy.data.node_groups.get(self.name)
        if not style_data.is_style(tree):
            raise style.StyleError(f"'{self.name}' is no Fovea style")
        style_data.assign(context.scene, tree)


def is_style_asset(asset):
    """Whether an AssetRepresentation is a style."""
    return asset is not None and asset.id_type == "NODETREE" and MARK in asset.metadata.keys()


def show(data, pixels):
    """Sets the preview of a datablock from (H, W, 3) uint8, bottom row first."""
    height, width = pixels.shape[:2]
    opaque = np.full((height, width, 4), 1.0, np.float32)
    opaque[..., :3] = pixels / np.float32(255)
    preview = data.preview_ensure()
    preview.image_size = width, height
    preview.image_pixels_float.foreach_set(opaque.ravel())


def brought(filepath, name, method):
    """The node tree of that name from another .blend file, imported by a method of IMPORTS; None if it has none."""
    path = str(Path(bpy.path.abspath(filepath)).resolve())
    if method == "APPEND_REUSE":
        return _appended(path, name) or brought(filepath, name, "APPEND")
    how = {"link": method != "APPEND"}
    if method == "PACK" and bpy.app.version >= (5, 0, 0):
        how["pack"] = True
    with bpy.data.libraries.load(path, **how) as (there, wanted):
        wanted.node_groups = [name] if name in there.node_groups else []
    tree = wanted.node_groups[0] if wanted.node_groups else None
    if tree is not None and not how["link"]:
        tree.asset_clear()  # the appended copy is not an asset itself
        tree.fovea.brought = f"{path}\n{name}"
    return tree


def _appended(path, name):
    """The node tree that was appended from a file earlier, or None."""
    trees = (tree for tree in bpy.data.node_groups if tree.library is None)
    return next((tree for tree in trees if tree.fovea.brought == f"{path}\n{name}"), None)


def method_of(filepath):
    """The import method in the preferences of the asset library that contains a file; APPEND if none does."""
    for library in bpy.context.preferences.filepaths.asset_libraries:
        if library.path and Path(filepath).resolve().is_relative_to(Path(library.path).resolve()):
            return library.import_method
    return "APPEND"


def _browser_method(context):
    """The import method set in an Asset Browser; None if it follows the preferences of the library."""
    found = getattr(getattr(context.space_data, "params", None), "import_method", "FOLLOW_PREFS")
    return None if found == "FOLLOW_PREFS" else found


def _in_shelf(pressed):
    """(.blend file, "" for the current one; name) of the asset clicked in a shelf, from 'a/b.blend/NodeTree/Name'."""
    file, _, rest = pressed.relative_asset_identifier.replace("\\", "/").rpartition("NodeTree/")
    if pressed.asset_library_type == "LOCAL" or not file:
        return "", rest
    libraries = bpy.context.preferences.filepaths.asset_libraries
    if pressed.asset_library_identifier not in libraries:
        raise style.StyleError(f"there is no asset library '{pressed.asset_library_identifier}' in the preferences")
    return str(Path(libraries[pressed.asset_library_identifier].path) / file.rstrip("/")), rest


class VIEW3D_AST_fovea_styles(bpy.types.AssetShelf):
    """Styles at the lower border of the 3D view, when View > Asset Shelf shows it."""

    bl_space_type = "VIEW_3D"
    bl_activate_operator = "fovea.style_use_asset"

    @classmethod
    def poll(cls, context):
        return context.engine == "FOVEA" and context.mode == "OBJECT"

    @classmethod
    def asset_poll(cls, asset):
        return is_style_asset(asset)


def _in_browser(menu, context):
    """Entry in the context menu of the Asset Browser."""
    if is_style_asset(getattr(context, "asset", None)):
        menu.layout.separator()
        menu.layout.operator("fovea.style_use_asset", icon="BRUSH_DATA")


def _in_menu(menu, _context):
    """Entries in Render > Fovea, so that F3 (search) finds the operators."""
    menu.layout.separator()
    menu.layout.operator_context = "INVOKE_DEFAULT"
    for cls in (FOVEA_OT_style_mark_asset, FOVEA_OT_style_clear_asset):
        menu.layout.operator(cls.bl_idname)


MENUS = {"ASSETBROWSER_MT_context_menu": _in_browser, "TOPBAR_MT_fovea": _in_menu}
