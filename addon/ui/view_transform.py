# SPDX-License-Identifier: GPL-3.0-or-later
"""Hint about view transforms that make white paper gray, as Blender's default does, which is meant for photorealism."""

import bpy

from ..scene.operator import Operator
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


def is_gray(scene):
    """Whether the scene's view transform displays white paper as gray."""
    return scene is not None and scene.view_settings.view_transform not in FAITHFUL


def draw_view_transform(layout, scene):
    """Draws a hint and a button to fix it, if the view transform makes paper gray."""
    if is_gray(scene):
        column = layout.column(align=True)
        column.label(text=f"{scene.view_settings.view_transform} makes paper gray", icon="INFO")
        column.operator("fovea.standard_view")


class RENDER_PT_fovea_view_transform(FoveaPanel, bpy.types.Panel):
    bl_label = "View Transform"
    bl_options = {"HIDE_HEADER"}

    @classmethod
    def poll(cls, context):
        return context.engine == ENGINE and is_gray(context.scene)

    def show(self, layout, context):
        draw_view_transform(layout, context.scene)
