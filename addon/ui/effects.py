# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel: what answers to focus and to distance, as a list with the response curve of the chosen effect."""

import bpy

from .. import style
from ..style import style_curves, style_data, style_groups
from .common import StylePanel, draw_properties

PARTS = {"effects": "", "distance": "By Distance: "}  # part of a style with effects -> what its labels begin with


def declared():
    """{name of its curve's node: (part, declaration)} of all effects, in order."""
    records = {"effects": style.Effects, "distance": style.Distance}
    found = ((part, field) for part in PARTS for field in style_groups.transfers(records[part]).values())
    return {style_curves.node_name(part, field["name"]): (part, field) for part, field in found}


def heeded(held, part, field):
    """Whether an effect can show: lines need a pen out of focus, colors a color layer."""
    effects = held.effects
    if field["group"] == "colors":
        return held.color.shading != "PLAIN" and effects.colors != "NONE"
    return any(line_set.away for line_set in held.line_sets) and (part != "effects" or effects.lines != "NONE")


class FOVEA_UL_effects(bpy.types.UIList):
    """Effects, each with its strength; the items are the nodes of their curves."""

    def draw_item(self, _context, layout, tree, node, _icon, _active_data, _active, _index=0, _flag=0):
        part, field = declared()[node.name]
        row = layout.split(factor=0.6)
        row.active = heeded(tree.fovea, part, field)
        row.label(text=PARTS[part] + field["label"])
        row.prop(getattr(getattr(tree.fovea, part), field["name"]), "strength", text="", emboss=False, slider=True)

    def filter_items(self, _context, tree, _property):
        order = list(declared())
        flags = [self.bitflag_filter_item if node.name in order else 0 for node in tree.nodes]
        places = {name: place for place, name in enumerate(order)}
        ranked = sorted(range(len(tree.nodes)), key=lambda i: (places.get(tree.nodes[i].name, len(order)), i))
        return flags, [ranked.index(i) for i in range(len(ranked))]


class RENDER_PT_fovea_effects(StylePanel, bpy.types.Panel):
    bl_label = "Effects"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, context):
        tree = style_data.of(context.scene)
        held = tree.fovea
        draw_properties(layout, held.effects, ("lines", "colors", "emphasis"))
        draw_properties(layout, held.effects, ("uniform",), "UNIFORM" in (held.effects.lines, held.effects.colors))
        if not any(line_set.away for line_set in held.line_sets):
            layout.label(text="No line set has a pen out of focus", icon="INFO")
        layout.template_list("FOVEA_UL_effects", "", tree, "nodes", held, "effect_index", rows=6)
        if held.effect_index < len(tree.nodes):
            _draw_effect(layout, held, tree.nodes[held.effect_index])


def _draw_effect(layout, held, node):
    """Draws the effect of a curve's node, if it is one."""
    if node.name not in declared():
        return
    part, field = declared()[node.name]
    group, body = getattr(held, part), layout.column()
    body.active = heeded(held, part, field)
    draw_properties(body, getattr(group, field["name"]), ("start", "end", "strength"))
    body.template_curve_mapping(node, "mapping")
    if field["name"] == "blur":
        draw_properties(body, group, ("blur_radius",))
    if part == "distance":
        draw_properties(body, group, ("near", "far"))
