"""Panels: how it is decided what is hidden, and what draws."""

import bpy

from .. import session
from .common import FoveaPanel, draw_properties


class RENDER_PT_fovea_visibility(FoveaPanel, bpy.types.Panel):
    bl_label = "Visibility"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, context):
        settings = context.scene.fovea
        layout.prop(settings, "visibility")
        sampled, items = settings.visibility != "EXACT", settings.visibility == "ITEM_BUFFER"
        draw_properties(layout, settings, ("probes",), sampled and not items)
        draw_properties(layout, settings, ("layers",), items)
        draw_properties(layout, settings, ("depth_scale",), sampled)
        used = session.last_statistics().get("visibility")
        if used:
            layout.label(text=f"Last drawn: {used}", icon="INFO")


class RENDER_PT_fovea_performance(FoveaPanel, bpy.types.Panel):
    bl_label = "Performance"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, context):
        layout.prop(context.scene.fovea, "backend")
        known = session.last_statistics()
        if known:
            total = sum(known["stages"].values()) / 1000
            layout.label(text=f"Last drawn in {total:.2f} s by the {known['backend']}, {known['strokes']} strokes")
            for stage, spent in known["stages"].items():
                layout.label(text=f"{stage.title()}: {spent:.0f} ms")


CLASSES = (RENDER_PT_fovea_visibility, RENDER_PT_fovea_performance)
