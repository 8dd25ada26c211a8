# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that lay lines over the renders of another engine, and take them away."""

import bpy

from ..scene import followed
from ..scene.operator import Operator
from . import lines_over, lines_scenes


class _OfPicture(Operator):
    """One that changes what lies over the renders of the context's scene."""

    @classmethod
    def hindrance(cls, context):
        scene = context.scene
        if scene is None or scene.library or scene.override_library:
            return "The scene is linked from another file: make it local first"
        if followed.follows(scene):
            return f"This scene draws the lines of '{scene.fovea.lines_of.name}': go to that one"
        if scene.render.engine == lines_scenes.ENGINE:
            return "Fovea draws the whole picture: choose another render engine"
        return cls.hindrance_of(scene)


class FOVEA_OT_lines_over(_OfPicture, bpy.types.Operator):
    """Draw Fovea's lines over what this engine renders, in every render and animation. It adds a scene that draws the
    lines, and nodes to the compositor"""

    bl_idname, bl_label = "fovea.lines_over", "Draw Lines Over Renders"

    @staticmethod
    def hindrance_of(scene):
        return "Lines are drawn over the renders already" if lines_over.is_on(scene) else None

    def act(self, context):
        lines_over.put_all(context.scene)


class FOVEA_OT_lines_over_remove(_OfPicture, bpy.types.Operator):
    """Draw no lines over the renders any more: remove the scene that draws them and its nodes"""

    bl_idname, bl_label = "fovea.lines_over_remove", "Remove Lines Over Renders"

    @staticmethod
    def hindrance_of(scene):
        return None if lines_over.is_on(scene) else "No lines are drawn over the renders"

    def act(self, context):
        lines_over.remove(context.scene)


class FOVEA_OT_lines_over_repair(_OfPicture, bpy.types.Operator):
    """Put back what the lines over the renders need and what has been removed, switched off or changed"""

    bl_idname, bl_label = "fovea.lines_over_repair", "Repair Lines Over Renders"
    hindrance_of = FOVEA_OT_lines_over_remove.hindrance_of

    def act(self, context):
        lines_over.repair(context.scene)


class FOVEA_OT_lines_over_layer(_OfPicture, bpy.types.Operator):
    """Draw Fovea's lines of this view layer over its picture, below what the compositor lays over that, or draw them no
    longer"""

    bl_idname, bl_label = "fovea.lines_over_layer", "Draw Lines Over This View Layer"

    @staticmethod
    def hindrance_of(scene):
        whole = lines_scenes.of(scene) is not None and len(lines_over.shown_layers(scene)) < 2
        return "The lines lie over the whole picture: Fovea Lines in the render tab" if whole else None

    def act(self, context):
        scene, layer = context.scene, context.view_layer
        if lines_scenes.of(scene, layer):
            lines_over.remove_from(scene, layer)
        else:
            if None in lines_over.places(scene):
                lines_over.remove_from(scene)  # these would lie over those
            lines_over.put(scene, layer)
