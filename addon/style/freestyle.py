# SPDX-License-Identifier: GPL-3.0-or-later
"""Match Freestyle: a Style from a view layer's Freestyle line sets."""

import math

import bpy

from .. import style
from ..scene.line_kinds import definitions
from ..scene.operator import Operator
from ..stages import REFERENCE_HEIGHT
from . import line_style_modifiers, style_data

# Freestyle's edge type -> line definitions.
KINDS = {
    "silhouette": ("contour", "border"),
    "border": ("border",),
    "crease": ("crease",),
    "ridge_valley": ("ridge", "valley"),
    "suggestive_contour": ("suggestive_contour",),
    "material_boundary": ("material_boundary",),
    "contour": ("silhouette",),
    "external_contour": ("silhouette",),
    "edge_mark": ("edge_mark",),
}
# Line definition -> another that it contains.
HAS = {"contour": "silhouette"}
# Line definition -> its parameters from Freestyle's settings, whose crease angle is between faces, not normals. It does
# not draw loose edges.
PARAMETERS = {
    "crease": lambda settings: {"angle": 180 - math.degrees(settings.crease_angle)},
    "border": lambda _settings: {"loose": 0.0},
}
# Told while it is on.
OVER = (
    "Freestyle is on: it draws its own lines over the picture, and may take many times as long as Fovea; "
    "Turn Freestyle Off, in the render tab, ends that"
)
_RELATIVE_HEIGHT = 480  # image height in pixels that Freestyle's relative thickness refers to


def is_on(scene):
    """Whether Freestyle draws its own lines over the scene's renders, whatever their engine."""
    return scene.render.use_freestyle and any(layer.use and layer.use_freestyle for layer in scene.view_layers)


def style_of(scene, layer):
    """(Style, sentences about settings that could not be converted) from a view layer's Freestyle settings."""
    settings, told, sets = layer.freestyle_settings, [], []
    if settings.mode == "SCRIPT":
        told.append("the Python style modules, which draw in place of the line sets")
    for line_set in settings.linesets:
        if not line_set.show_render:
            continue
        if line_set.linestyle is None:  # it was removed from the file
            told.append(f"'{line_set.name}': it has no line style")
            continue
        told += [f"'{line_set.name}': {what}" for what in _unmatched(line_set)]
        if kinds := _kinds(line_set, settings):
            pen, left = line_style_modifiers.applied(
                _pen(line_set.linestyle, scene), line_set.linestyle, _millimeters(scene)
            )
            told += [f"'{line_set.name}': {what}" for what in left]
            sets.append(_line_set(line_set, kinds, pen, scene))
    return style.Style(line_sets=tuple(sets)), told


def _kinds(line_set, settings):
    """{definition: parameters} for a Freestyle line set."""
    wanted = [word for word in KINDS if getattr(line_set, f"select_{word}") or not line_set.select_by_edge_types]
    names = dict.fromkeys(name for word in wanted for name in KINDS[word])
    had = {HAS.get(name) for name in names}
    return {name: PARAMETERS[name](settings) if name in PARAMETERS else {} for name in names if name not in had}


def _line_set(line_set, kinds, pen, scene):
    chosen = line_set.linestyle
    first, last = _range(line_set)
    hidden = (style.Hidden(pen=pen, first=max(first, 1), last=last),) if last is None or last > 0 else ()
    least = chosen.length_min if chosen.use_length_min else 0.0
    return style.LineSet(
        name=line_set.name,
        kinds=kinds,
        **_collection(line_set),
        least_length=min(least * _pixel(scene), 1000.0),
        pen=pen if first == 0 else style.Pen(opacity=0.0),
        hidden=hidden,
    )


def _collection(line_set):
    """The filter by collection of a Freestyle line set, as keyword arguments of LineSet."""
    if not (line_set.select_by_collection and line_set.collection):
        return {}
    return {"collection": line_set.collection.name, "outside": line_set.collection_negation == "EXCLUSIVE"}


def _range(line_set):
    """(first, last) quantitative invisibility of a Freestyle line set; last None: unlimited."""
    if not line_set.select_by_visibility or line_set.visibility == "VISIBLE":
        return (0, 0) if line_set.select_by_visibility else (0, None)
    if line_set.visibility == "HIDDEN":
        return 1, None
    return line_set.qi_start, line_set.qi_end


def _pen(chosen, scene):
    relative = scene.render.line_thickness_mode == "RELATIVE"
    width = chosen.thickness * (REFERENCE_HEIGHT / _RELATIVE_HEIGHT if relative else scene.render.line_thickness)
    return style.Pen(
        color=tuple(chosen.color),
        opacity=chosen.alpha,
        width=width,
        width_unit="reference" if relative else "pixels",
        texture="dashes" if chosen.use_dashed_line else "solid",
        # Whatever the line style has: Freestyle's strokes overlap where they meet; without that, butt caps leave gaps.
        cap="round",
    )


def _pixel(scene):
    """Reference pixels per pixel of the scene's image."""
    return REFERENCE_HEIGHT / (scene.render.resolution_y * scene.render.resolution_percentage / 100)


def _millimeters(scene):
    """Millimeters of the page per pixel of the scene's image."""
    return _pixel(scene) / REFERENCE_HEIGHT * style.Paper().height_mm


def _unmatched(line_set):
    """Yields phrases on settings of a Freestyle line set that are not converted."""
    chosen = line_set.linestyle
    if line_set.select_by_edge_types and line_set.edge_type_negation == "EXCLUSIVE":
        yield "lines that are not of its edge types"
    if line_set.select_by_edge_types and line_set.edge_type_combination == "AND":
        yield "lines that are of all its edge types at once"
    if line_set.select_by_edge_types and any(getattr(line_set, f"exclude_{word}") for word in KINDS):
        yield "edge types that it excludes"
    if line_set.select_by_face_marks:
        yield "face marks"
    # Every new line style has a Sampling modifier.
    if any(modifier.use and modifier.type != "SAMPLING" for modifier in chosen.geometry_modifiers):
        yield "geometry modifiers"
    if any(slot and slot.texture for slot in chosen.texture_slots):
        yield "textures"
    if chosen.use_length_max:
        yield "the greatest length of lines"


class FOVEA_OT_match_freestyle(Operator, bpy.types.Operator):
    """Take over the view layer's Freestyle line sets: edge types, crease angle, visibility, and the line styles'
    thickness, color and opacity with their modifiers along the stroke, by angle, by distance and by noise"""

    bl_idname = "fovea.match_freestyle"
    bl_label = "Match Freestyle"

    @classmethod
    def hindrance(cls, context):
        sets = context.view_layer.freestyle_settings.linesets if context.view_layer else ()
        if not any(line_set.show_render and line_set.linestyle for line_set in sets):
            return "The view layer has no Freestyle line set that is on: there is nothing to match"
        return None if definitions() else "Fovea's native module cannot be used in this Blender"

    def act(self, context):
        chosen, told = style_of(context.scene, context.view_layer)
        if not chosen.line_sets:
            raise style.StyleError("The Freestyle line sets select no edge types that Fovea draws")
        style_data.use(context.scene, chosen, "Freestyle")
        if told:
            self.report({"WARNING"}, f"Not taken over: {'; '.join(told)}")
