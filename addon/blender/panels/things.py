"""Panels of objects, materials and view layers."""

import bpy

from .. import session
from .common import FoveaPanel


class OBJECT_PT_fovea(FoveaPanel, bpy.types.Panel):
    bl_label = "Line Drawing"
    bl_context = "object"

    def show(self, layout, context):
        layout.prop(context.object.fovea, "usage", text="Usage")
        layout.prop(context.object, "is_holdout")
        layout.prop(context.object.fovea, "priority")
        settings = context.object.fovea
        _draw_curvature(layout, context.object)
        _draw_shape(layout, settings)


def _draw_curvature(layout, obj):
    layout.prop(obj.fovea, "curvature_estimator")
    if obj.fovea.curvature_estimator == "JETS":
        layout.prop(obj.fovea, "curvature_rings")
    layout.prop(obj.fovea, "curvature_smoothing")
    reason = session.last_statistics().get("curvature", {}).get(obj.name)
    if reason:
        layout.label(text=reason, icon="INFO")


def _draw_shape(layout, settings):
    layout.prop(settings, "refine")
    if settings.refine:
        layout.prop(settings, "refine_level")
    header, body = layout.panel("fovea_repair", default_closed=True)
    header.label(text="Repair")
    if body:
        for name in ("weld", "orient", "smooth", "resample"):
            body.prop(settings, f"repair_{name}")
        if settings.repair_resample:
            body.prop(settings, "repair_edge_length")


class MATERIAL_PT_fovea(FoveaPanel, bpy.types.Panel):
    bl_label = "Line Drawing"
    bl_context = "material"

    @classmethod
    def poll(cls, context):
        return super().poll(context) and context.material is not None

    def show(self, layout, context):
        layout.prop(context.material.fovea, "occlusion")


class VIEWLAYER_PT_fovea(FoveaPanel, bpy.types.Panel):
    bl_label = "Passes"
    bl_context = "view_layer"

    def show(self, layout, context):
        layout.prop(context.view_layer, "use_pass_z", text="Depth")



CLASSES = (OBJECT_PT_fovea, MATERIAL_PT_fovea, VIEWLAYER_PT_fovea)
