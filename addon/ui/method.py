# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels: the visibility method, and the device with statistics."""

import bpy

from ..render import methods, session, stage_labels
from .common import FoveaPanel, draw_properties, fold


class RENDER_PT_fovea_visibility(FoveaPanel, bpy.types.Panel):
    bl_label = "Visibility"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, context):
        settings = context.scene.fovea
        layout.prop(settings, "visibility")
        for name in ("probes", "layers", "depth_scale"):
            draw_properties(layout, settings, (name,), name in methods.QUALITY.get(settings.visibility, ()))
        if used := session.last_statistics().get("visibility"):
            layout.label(text=f"Last drawn: {used}", icon="INFO")


class RENDER_PT_fovea_performance(FoveaPanel, bpy.types.Panel):
    bl_label = "Performance"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, context):
        layout.prop(context.scene.fovea, "backend")
        layout.prop(context.scene.render, "use_persistent_data")
        known = session.last_statistics()
        body = fold(layout, "last_drawn", f"Last Drawn in {_seconds(known):.2f} s") if known else None
        if body:
            _draw_statistics(body, known)


def _seconds(known):
    return sum(known["stages"].values()) / 1000


def _draw_statistics(layout, known):
    """Draws the device, the number of strokes, and the time of each stage."""
    rows = [("Device", known["backend"].upper()), ("Strokes", str(known["strokes"]))]
    rows += [(stage_labels.label(stage), f"{spent:.0f} ms") for stage, spent in known["stages"].items()]
    column = layout.column(align=True)
    for name, value in rows:
        row = column.split(factor=0.5)
        row.label(text=name)
        row.label(text=value)
