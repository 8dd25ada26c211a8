# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel: effects of focus and of distance, each with its response curve."""

import bpy

from .. import style
from ..style import style_curves, style_data, style_groups
from .common import StylePanel, draw_properties, fold


class RENDER_PT_fovea_effects(StylePanel, bpy.types.Panel):
    bl_label = "Effects"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, context):
        tree = style_data.of(context.scene)
        held = tree.fovea
        effects, distance, color = held.effects, held.distance, held.color.shading != "PLAIN"
        away = any(line_set.away for line_set in held.line_sets)
        draw_properties(layout, effects, ("lines", "colors"))
        draw_properties(layout, effects, ("uniform",), "UNIFORM" in (effects.lines, effects.colors))
        if not away:
            layout.label(text="No line set has a pen out of focus", icon="INFO")
        heeded = {"lines": away and effects.lines != "NONE", "colors": color and effects.colors != "NONE"}
        for name, declared in style_groups.transfers(style.Effects).items():
            body = _draw_transfer(layout, tree, "effects", declared, heeded[declared["group"]])
            if body and name == "blur":
                draw_properties(body, effects, ("blur_radius",), effects.blur.strength > 0)
        if body := fold(layout, "distance", "By Distance"):
            draw_properties(body, distance, ("near", "far"), away)
            for declared in style_groups.transfers(style.Distance).values():
                _draw_transfer(body, tree, "distance", declared, away)


def _draw_transfer(layout, tree, part, declared, heeded):
    """Draws a transfer function; returns the section's body, or None if it is closed."""
    name = declared["name"]
    transfer = getattr(getattr(tree.fovea, part), name)
    body = fold(layout, f"{part}_{name}", declared["label"], heeded=heeded and transfer.strength > 0)
    if body:
        body.active = heeded
        draw_properties(body, transfer, ("start", "end", "strength"))
        if node := tree.nodes.get(style_curves.node_name(part, name)):
            body.template_curve_mapping(node, "mapping")
    return body
