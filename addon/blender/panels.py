"""Panels, made from the line registry, and Blender's own panels that make sense with this engine."""

import bpy

from .. import catalogue, native
from . import focus_settings, layer_settings, pens, session

ENGINE = "FOVEA"
# Blender's panels declare their engines; these are shown although they do not declare the built-in ones.
ALSO = {"EEVEE_MATERIAL_PT_context_material", "EEVEE_MATERIAL_PT_surface"}
NOT = {"RENDER_PT_freestyle", "RENDER_PT_gpencil", "VIEWLAYER_PT_filter"}
# What lines depend on, by the registry's word for it.
SCOPES = {"view": "Lines of the View", "surface": "Lines of the Shape", "scene": "Lines of the Scene"}


class _Panel:
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    COMPAT_ENGINES = {ENGINE}

    @classmethod
    def poll(cls, context):
        return context.engine in cls.COMPAT_ENGINES

    def columns(self):
        self.layout.use_property_split = True
        self.layout.use_property_decorate = True
        return self.layout


class RENDER_PT_fovea(_Panel, bpy.types.Panel):
    bl_label = "Line Drawing"
    bl_context = "render"

    def draw(self, context):
        layout, settings = self.columns(), context.scene.fovea
        try:
            definitions = catalogue.definitions()
        except native.Unavailable as error:
            layout.label(text=str(error), icon="ERROR")
            return
        layout.prop(settings, "style")
        _draw_lines(layout, settings, definitions)
        _draw_pen(layout, settings)
        _draw_hidden(layout, settings)
        _draw_focus(layout, settings)
        _draw_effects(layout, settings)
        _draw_elision(layout, settings)
        _draw_paper(layout, context)
        header, body = layout.panel("fovea_method", default_closed=True)
        header.label(text="Method")
        if body:
            body.prop(settings, "backend")
            _draw_visibility(body, settings)


def _draw_visibility(layout, settings):
    layout.prop(settings, "visibility")
    quality = layout.column()
    quality.enabled = settings.visibility != "EXACT"
    if settings.visibility == "ITEM_BUFFER":
        quality.prop(settings, "layers")
    else:
        quality.prop(settings, "probes")
    quality.prop(settings, "depth_scale")
    used = session.last_statistics().get("visibility")
    if used:
        layout.label(text=f"Last drawn: {used}", icon="INFO")


def _draw_lines(layout, settings, definitions):
    for scope, title in SCOPES.items():
        group = [definition for definition in definitions if definition["scope"] == scope]
        if not group:
            continue
        header, body = layout.panel(f"fovea_lines_{scope}")
        header.label(text=title)
        if body:
            _draw_switches(body, settings, group)


def _draw_switches(body, settings, definitions):
    """Definitions of one group, and the parameters of those that are on."""
    for definition in definitions:
        name = definition["name"]
        # Full width: most names are too long for half of it.
        switch = body.row()
        switch.use_property_split = False
        switch.prop(settings, name)
        if getattr(settings, name):
            for parameter in definition["parameters"]:
                body.prop(settings, f"{name}_{parameter['name']}")


def _draw_pen(layout, settings):
    header, body = layout.panel("fovea_pen")
    header.label(text="Pen")
    if body:
        body.prop(settings, "corner_angle")
        _draw_pen_settings(body, settings, pens.VISIBLE)


def _draw_pen_settings(body, settings, prefix):
    for name in pens.FIELDS:
        body.prop(settings, f"{prefix}_{name}")


def _draw_hidden(layout, settings):
    header, body = layout.panel("fovea_hidden", default_closed=True)
    header.label(text="Where Lines Are Hidden")
    if not body:
        return
    body.prop(settings, "halo")
    body.prop(settings, "overshoot")
    body.prop(settings, "hidden")
    if settings.hidden:
        body.prop(settings, "hidden_from")
        body.prop(settings, "hidden_to")
        if settings.visibility == "SPINE":
            body.label(text="The spine test draws visible lines only", icon="INFO")
        elif settings.visibility != "EXACT":
            body.label(text="Sampled visibility counts one surface at most", icon="INFO")
        _draw_pen_settings(body, settings, pens.HIDDEN)


def _draw_elision(layout, settings):
    header, body = layout.panel("fovea_elision", default_closed=True)
    header.prop(settings, "elision")
    if body:
        body.active = settings.elision
        if settings.visibility == "SPINE":
            body.label(text="The spine test does not know what is seen before it draws: nothing is thinned", icon="INFO")
        for name in ("fade_from", "cut", "frames", *layer_settings.WEIGHTS):
            body.prop(settings, f"elision_{name}")
        for name in layer_settings.ATTRIBUTES:
            body.prop(settings, f"elision_{name}")
        body.prop(settings, "elision_density_image")


def _draw_paper(layout, context):
    settings = context.scene.fovea
    header, body = layout.panel("fovea_paper")
    header.label(text="Colour and Paper")
    if not body:
        return
    body.prop(settings, "color_shading")
    if settings.color_shading == "TOON":
        body.prop(settings, "color_bands")
    if settings.color_shading != "PLAIN":
        body.prop(settings, "color_opacity")
        body.prop(settings, "color_desaturation")
        body.prop(settings, "color_on_paper")
        if not settings.color_on_paper:
            body.prop(settings, "color_background")
    body.prop(settings, "paper_color")
    body.prop(context.scene.render, "film_transparent", text="Transparent")
    body.prop(settings, "paper_texture")
    for name in ("scale", "tooth", "granulation", "tint", "height_mm"):
        body.prop(settings, f"paper_{name}")


def _draw_focus(layout, settings):
    header, body = layout.panel("fovea_focus")
    header.label(text="Focus")
    if not body:
        return
    body.prop(settings, "focus_model")
    if settings.focus_model == "NONE":
        return
    if settings.focus_model == "PAINTED":
        body.prop(settings, "focus_attribute")
        return
    for place in (settings, *settings.focus_points):
        if settings.focus_model == "IMAGE":
            names = ("place", "near", "far")
        else:
            names = ("object", *(() if place.focus_object else ("location",)), "near_distance", "far_distance")
        for name in names:
            body.prop(place, f"focus_{name}")
    if settings.focus_points:
        body.prop(settings, "focus_combine")


def _draw_effects(layout, settings):
    header, body = layout.panel("fovea_effects", default_closed=True)
    header.label(text="Effects of Focus")
    if not body:
        return
    body.prop(settings, "effect_lines")
    body.prop(settings, "effect_colors")
    if "UNIFORM" in (settings.effect_lines, settings.effect_colors):
        body.prop(settings, "effect_uniform")
    body.prop(settings, "away")
    if settings.away:
        body.prop(settings, "away_overshoot")
        _draw_pen_settings(body, settings, focus_settings.AWAY)
        _draw_transfers(body, settings, "effect", focus_settings.LINE_EFFECTS)
        body.prop(settings, "distance_near")
        body.prop(settings, "distance_far")
        _draw_transfers(body, settings, "distance", focus_settings.DISTANCE_EFFECTS)
    _draw_transfers(body, settings, "effect", focus_settings.COLOR_EFFECTS)
    body.prop(settings, "effect_blur_radius")


def _draw_transfers(layout, settings, prefix, names):
    for name in names:
        column = layout.column(align=True, heading=name.title())
        for field in focus_settings.NUMBERS:
            column.prop(settings, f"{prefix}_{name}_{field}")


class OBJECT_PT_fovea(_Panel, bpy.types.Panel):
    bl_label = "Line Drawing"
    bl_context = "object"

    def draw(self, context):
        layout = self.columns()
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


class MATERIAL_PT_fovea(_Panel, bpy.types.Panel):
    bl_label = "Line Drawing"
    bl_context = "material"

    @classmethod
    def poll(cls, context):
        return super().poll(context) and context.material is not None

    def draw(self, context):
        self.columns().prop(context.material.fovea, "occlusion")


class VIEWLAYER_PT_fovea(_Panel, bpy.types.Panel):
    bl_label = "Passes"
    bl_context = "view_layer"

    def draw(self, context):
        self.columns().prop(context.view_layer, "use_pass_z", text="Depth")


CLASSES = (RENDER_PT_fovea, OBJECT_PT_fovea, MATERIAL_PT_fovea, VIEWLAYER_PT_fovea)


def _blender_panels():
    """Blender's panels to show with this engine: those that every engine without own ones shows."""
    for panel in bpy.types.Panel.__subclasses__():
        engines = getattr(panel, "COMPAT_ENGINES", ())
        if panel.__name__ in ALSO or ("BLENDER_RENDER" in engines and panel.__name__ not in NOT):
            yield panel


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    for panel in _blender_panels():
        panel.COMPAT_ENGINES.add(ENGINE)


def unregister():
    for panel in _blender_panels():
        panel.COMPAT_ENGINES.discard(ENGINE)
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
