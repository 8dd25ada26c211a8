# SPDX-License-Identifier: GPL-3.0-or-later
"""Hints about settings that spoil a drawing, each with a button that sets them right: a view transform that makes white
paper gray, as Blender's default does, which is meant for photorealism; Freestyle or Line Art left on."""

import bpy

from ..scene.operator import Operator
from ..style import freestyle, line_art
from .common import ENGINE, FoveaPanel

FAITHFUL = {"Standard", "Raw"}  # view transforms without tone mapping


class FOVEA_OT_standard_view(Operator, bpy.types.Operator):
    """Set the view transform to Standard, which shows the colors of paper and ink as they are. Others make white paper
    gray"""

    bl_idname, bl_label = "fovea.standard_view", "Use Standard View Transform"

    @classmethod
    def hindrance(cls, context):
        return None if is_gray(context.scene) else "The view transform shows colors as they are already"

    def act(self, context):
        settings = context.scene.view_settings
        settings.look, settings.view_transform = "None", "Standard"


class FOVEA_OT_freestyle_off(Operator, bpy.types.Operator):
    """Turn Freestyle off, which draws its own lines over Fovea's picture, and takes many times as long"""

    bl_idname, bl_label = "fovea.freestyle_off", "Turn Freestyle Off"

    @classmethod
    def hindrance(cls, context):
        return None if draws_freestyle(context.scene) else "Freestyle is off"

    def act(self, context):
        context.scene.render.use_freestyle = False


class FOVEA_OT_line_art_off(Operator, bpy.types.Operator):
    """Turn the Line Art modifiers off: Blender draws their Grease Pencil objects over Fovea's picture"""

    bl_idname, bl_label = "fovea.line_art_off", "Turn Line Art Off"

    @classmethod
    def hindrance(cls, context):
        return None if draws_line_art(context.scene) else "The scene has no Line Art modifier that renders show"

    def act(self, context):
        for _, modifier in line_art.modifiers_of(context.scene):
            modifier.show_render = modifier.show_viewport = False


def is_gray(scene):
    """Whether the scene's view transform displays white paper as gray."""
    return scene is not None and scene.view_settings.view_transform not in FAITHFUL


def draws_freestyle(scene):
    return scene is not None and freestyle.is_on(scene)


def draws_line_art(scene):
    return scene is not None and any(line_art.modifiers_of(scene))


def draw_hints(layout, scene):
    """Draws the hints that apply, each with its button."""
    hints = {
        "fovea.standard_view": is_gray(scene) and f"{scene.view_settings.view_transform} makes paper gray",
        "fovea.freestyle_off": draws_freestyle(scene) and "Freestyle draws over the picture",
        "fovea.line_art_off": draws_line_art(scene) and "Line Art draws over the picture",
    }
    for operator, words in hints.items():
        if words:
            column = layout.column(align=True)
            column.label(text=words, icon="INFO")
            column.operator(operator)


class RENDER_PT_fovea_hints(FoveaPanel, bpy.types.Panel):
    bl_label = "Hints"
    bl_options = {"HIDE_HEADER"}

    @classmethod
    def poll(cls, context):
        spoiled = (test(context.scene) for test in (is_gray, draws_freestyle, draws_line_art))
        return context.engine == ENGINE and any(spoiled)

    def show(self, layout, context):
        draw_hints(layout, context.scene)
