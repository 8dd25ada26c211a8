# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels of objects, collections, materials and view layers."""

import bpy

from ..render import session
from ..scene import bare_shapes, own_lines
from ..scene.line_kinds import property_name
from ..scene.shapes import LABELS
from ..style import style_data
from .common import FoveaPanel, fold, fold_switch
from .lines import SCOPES


class OBJECT_PT_fovea(FoveaPanel, bpy.types.Panel):
    bl_label = "Line Drawing"
    bl_context = "object"

    def show(self, layout, context):
        obj, settings = context.object, context.object.fovea
        layout.prop(settings, "usage", text="Usage")
        layout.prop(obj, "is_holdout")
        layout.prop(settings, "outline_group")
        if obj.type == "CURVES" or any(bare_shapes.is_hair(system) for system in obj.particle_systems):
            layout.prop(settings, "hair")
        has_lines = settings.usage in {"BOTH", "DRAW"}
        _draw_own_lines(layout, settings, _kinds_of_style(context.scene), has_lines)
        column = layout.column()
        column.active = has_lines
        _draw_as(column, obj)
        _draw_curvature(column, obj)
        _draw_shape(layout, settings)


def _kinds_of_style(scene):
    """Names of the definitions that the scene's style draws, including those of the style mixed in."""
    tree, other = style_data.of(scene), scene.fovea.mixed_style
    if tree:
        drawn = style_data.drawn_kinds(tree.fovea)
    else:
        drawn = {name for line_set in style_data.default().line_sets for name in line_set.kinds}
    mixed = scene.fovea.mix > 0.0 and style_data.is_style(other)
    return drawn | style_data.drawn_kinds(other.fovea) if mixed else drawn


def _draw_own_lines(layout, settings, drawn, has_lines):
    """Draws an object's priority and its overrides of lines; `drawn`: the kinds that the style has."""
    column = layout.column()
    column.active = has_lines
    column.prop(settings, "priority")
    for definition, parameter in own_lines.parameters():
        name, own = definition["name"], own_lines.switch_name(definition, parameter)
        row = layout.row(align=True, heading=own_lines.label(definition, parameter))
        row.active = has_lines and name in drawn and (not settings.own_kinds or getattr(settings.kinds, name))
        row.prop(settings, own, text="")
        value = row.row(align=True)
        value.active = getattr(settings, own)
        value.prop(settings, property_name(definition, parameter), text="")
    if body := fold_switch(layout, "own_kinds", settings, "own_kinds", has_lines):
        body.use_property_split = False
        for scope, title in SCOPES.items():
            body.label(text=title)
            for definition in own_lines.switchable():
                if definition["scope"] == scope:
                    row = body.row()
                    row.active = definition["name"] in drawn
                    row.prop(settings.kinds, definition["name"])


def _draw_as(layout, obj):
    layout.prop(obj.fovea, "shape")
    known = session.last_statistics().get("shape", {}).get(obj.name)
    if known and obj.fovea.shape == "AUTOMATIC":
        shape, reason = known
        layout.label(text=f"Drawn as {LABELS[shape]}: {reason}", icon="INFO")


def _draw_curvature(layout, obj):
    layout.prop(obj.fovea, "curvature_estimator")
    if obj.fovea.curvature_estimator == "JETS":
        layout.prop(obj.fovea, "curvature_rings")
    layout.prop(obj.fovea, "curvature_smoothing")
    if reason := session.last_statistics().get("curvature", {}).get(obj.name):
        layout.label(text=reason, icon="INFO")


def _draw_shape(layout, settings):
    layout.prop(settings, "refine")
    if settings.refine:
        layout.prop(settings, "refine_level")
    if body := fold(layout, "repair", "Repair"):
        for name in ("orient", "resample"):
            body.prop(settings, f"repair_{name}")
        if settings.repair_resample:
            body.prop(settings, "repair_edge_length")


class COLLECTION_PT_fovea(FoveaPanel, bpy.types.Panel):
    bl_label = "Line Drawing"
    bl_context = "collection"

    def show(self, layout, context):
        layout.prop(context.collection.fovea, "one_outline")


class MATERIAL_PT_fovea(FoveaPanel, bpy.types.Panel):
    bl_label = "Line Drawing"
    bl_context = "material"

    @classmethod
    def poll(cls, context):
        return super().poll(context) and context.material is not None

    def show(self, layout, context):
        layout.prop(context.material.fovea, "lines")
        layout.prop(context.material.fovea, "occlusion")


class VIEWLAYER_PT_fovea(FoveaPanel, bpy.types.Panel):
    bl_label = "Passes"
    bl_context = "view_layer"

    def show(self, layout, context):
        layer, told = context.view_layer, layout.column(align=True)
        for each, names in session.wanted_passes(context.scene, layer).items():
            if each.switch:
                owner, _, name = each.switch.rpartition(".")
                layout.prop(layer.path_resolve(owner) if owner else layer, name, text=each.label)
                if names and each.image == "mattes":
                    layout.prop(layer, "pass_cryptomatte_depth", text="Levels")
                for name in names if each.image == "line_sets" else ():
                    layout.label(text=name, icon="DOT")
            else:
                row = told.row()
                row.active = bool(names)
                text = each.label if names else f"{each.label}: {each.lacking}"
                row.label(text=text, icon="CHECKMARK" if names else "BLANK1")
