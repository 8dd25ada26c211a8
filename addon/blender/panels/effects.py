"""Panels: elision, where to look, and what answers to it, each effect with its response curve."""

import bpy

from ...elision import Elision
from .. import style_curves, style_data
from ..style_groups import plain_fields
from ..style_words import COLOR_EFFECTS, DISTANCE_EFFECTS, EFFECTS, LINE_EFFECTS
from .common import FoveaPanel, StylePanel, draw_properties, fold


class RENDER_PT_fovea_elision(StylePanel, bpy.types.Panel):
    bl_label = "Elision"
    bl_options = {"DEFAULT_CLOSED"}

    def draw_header(self, context):
        self.layout.prop(style_data.of(context.scene).fovea.elision, "enabled", text="")

    def show(self, layout, context):
        elision = style_data.of(context.scene).fovea.elision
        layout.active = elision.enabled
        if context.scene.fovea.visibility == "SPINE":
            layout.label(text="The spine test knows too late what is seen to thin it", icon="INFO")
        names = [name for name, _ in plain_fields(Elision) if name != "enabled"]
        for name in names:
            draw_properties(layout, elision, (name,), name != "painted" or bool(elision.priority_attribute))
        layout.prop(elision, "density_image")


class RENDER_PT_fovea_focus(FoveaPanel, bpy.types.Panel):
    bl_label = "Focus"

    def show(self, layout, context):
        draw_focus(layout, context.scene.fovea)


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
            layout.label(text="No line set has a pen out of focus: lines are the same everywhere", icon="INFO")
        for name in LINE_EFFECTS:
            _draw_transfer(layout, tree, "effects", name, away and effects.lines != "NONE")
        for name in COLOR_EFFECTS:
            _draw_transfer(layout, tree, "effects", name, color and effects.colors != "NONE")
        draw_properties(layout, effects, ("blur_radius",), color and effects.blur.strength > 0)
        body = fold(layout, "distance", "By Distance")
        if body:
            draw_properties(body, distance, ("near", "far"), away)
            for name in DISTANCE_EFFECTS:
                _draw_transfer(body, tree, "distance", name, away)


def _draw_transfer(layout, tree, part, name, heeded):
    transfer = getattr(getattr(tree.fovea, part), name)
    title = EFFECTS[name] + (", by distance" if part == "distance" else "")
    header, body = layout.panel(f"fovea_{part}_{name}", default_closed=True)
    header.active = heeded and transfer.strength > 0
    header.label(text=title)
    if body:
        body.active = heeded
        draw_properties(body, transfer, ("start", "end", "strength"))
        node = tree.nodes.get(style_curves.node_name(part, name))
        if node:
            body.template_curve_mapping(node, "mapping")


def draw_focus(layout, settings):
    """Where to look, as the scene says."""
    layout.prop(settings, "focus_model")
    if settings.focus_model == "NONE":
        return
    if settings.focus_model == "PAINTED":
        layout.prop(settings, "focus_attribute")
        return
    for place in (settings, *settings.focus_points):
        if settings.focus_model == "IMAGE":
            names = ("place", "near", "far")
        else:
            names = ("object", *(() if place.focus_object else ("location",)), "near_distance", "far_distance")
        for name in names:
            layout.prop(place, f"focus_{name}")
    if settings.focus_points:
        layout.prop(settings, "focus_combine")


CLASSES = (RENDER_PT_fovea_elision, RENDER_PT_fovea_focus, RENDER_PT_fovea_effects)
