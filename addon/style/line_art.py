# SPDX-License-Identifier: GPL-3.0-or-later
"""Match Line Art: a Style from the Line Art modifiers of a scene's Grease Pencil objects."""

import math

import bpy
import numpy as np

from .. import style
from ..scene import camera, pencils
from ..scene.line_kinds import definitions
from ..scene.operator import Operator
from . import line_art_usage, line_style_modifiers, style_data

# Line Art's edge type -> line definitions; loose edges are drawn as borders.
KINDS = {
    "contour": ("contour", "border"),
    "loose": ("border",),
    "crease": ("crease",),
    "intersection": ("intersection",),
    "material": ("material_boundary",),
    "edge_mark": ("edge_mark",),
    "light_contour": ("light_contour",),
    "shadow": ("cast_shadow",),
}
BY_LIGHT = {"light_contour", "shadow"}  # edge types that Line Art draws by one light, if the modifier names it
# Setting of a modifier that is not converted -> what it says.
UNMATCHED = {
    "use_face_mark": "face marks",
    "use_material_mask": "material masks",
    "use_intersection_mask": "intersection masks",
    "use_custom_camera": "a camera of its own",
    "fill_strokes": "fills",
    "source_vertex_group": "vertex groups",
}
# Modifier of Grease Pencil -> the member of a pen that it changes along strokes, its factor.
ALONG = {"GREASE_PENCIL_THICKNESS": ("width", "thickness_factor"), "GREASE_PENCIL_OPACITY": ("opacity", "color_factor")}
# Settings by which such a modifier is for some strokes alone, or leaves out the curve.
PARTIAL = (
    *("layer_filter", "tree_node_filter", "material_filter", "vertex_group_name", "use_layer_pass_filter"),
    *("use_material_pass_filter", "use_uniform_thickness", "use_uniform_opacity"),
    *("use_weight_factor", "use_weight_as_factor"),
)
DEFAULT_WIDTH = 1.5  # reference pixels, where no distance from the camera is known
WIDTHS = 0.25, 50.0  # limits of a width, in reference pixels


def modifiers_of(scene):
    """(object, modifier) of the Line Art modifiers that renders show; none before Blender 4.3, where Grease Pencil has
    modifiers of its own kind."""
    for obj in scene.objects if pencils.are_there() else ():
        if obj.type == "GREASEPENCIL" and not obj.hide_render:
            yield from ((obj, modifier) for modifier in obj.modifiers if _is_line_art(modifier))


def _is_line_art(modifier):
    return modifier.type == "LINEART" and modifier.show_render


def style_of(scene, depsgraph):
    """(Style, sentences about settings that could not be converted) from the Line Art modifiers of a scene."""
    told, sets = [], []
    for obj, modifier in modifiers_of(scene):
        name = f"{obj.name}: {modifier.name}"
        told += [f"'{name}': {what}" for what in _unmatched(scene, obj, modifier)]
        source = _source(modifier)
        if source is None:
            told.append(f"'{name}': it has no source")
        elif kinds := _kinds(modifier):
            pen = _along(_pen(modifier, _width(modifier, scene, depsgraph)), obj)
            sets.append(_line_set(name, modifier, kinds, source, pen))
    return style.Style(line_sets=tuple(sets)), told


def _source(modifier):
    """The filter of the LineSet, as keyword arguments; None: the modifier draws nothing."""
    if modifier.source_type == "SCENE":
        return {}
    if modifier.source_type == "OBJECT":
        return {"object": modifier.source_object.name} if modifier.source_object else None
    collection = modifier.source_collection
    return {"collection": collection.name, "outside": modifier.use_invert_collection} if collection else None


def _kinds(modifier):
    """{definition: parameters} of a modifier."""
    names = dict.fromkeys(name for word in KINDS if _draws(modifier, word) for name in KINDS[word])
    if "contour" in names and modifier.silhouette_filtering != "NONE":
        names = {"silhouette" if name == "contour" else name: None for name in names}
    # Its angle is between faces, not normals.
    crease = {"angle": 180 - math.degrees(modifier.crease_threshold)}
    values = {"crease": crease, "border": {"loose": float(modifier.use_loose)}}
    return {name: values.get(name, {}) for name in names}


def _draws(modifier, word):
    """Whether a modifier draws an edge type."""
    return getattr(modifier, f"use_{word}") and (word not in BY_LIGHT or modifier.light_contour_object is not None)


def _pen(modifier, width):
    color = _color(modifier.target_material)
    return style.Pen(color=color[:3], opacity=min(color[3] * modifier.opacity, 1.0), width=width)


def _along(pen, obj):
    """The pen with what an object's modifiers say of width and opacity along strokes."""
    for modifier in _of_all_strokes(obj):
        member, factor = ALONG[modifier.type]
        share, curve = getattr(pen, member) * getattr(modifier, factor), ((0.0, 1.0),)
        if modifier.use_custom_curve:
            curve = line_style_modifiers.curve_points(modifier.custom_curve)
        pen = line_style_modifiers.along(pen, member, [(x, share * y) for x, y in curve])
    return pen


def _of_all_strokes(obj):
    """The modifiers that say of all of an object's strokes how wide, and how opaque, they are along their length: the
    first of each."""
    found = {}
    for modifier in obj.modifiers:
        plain = not any(getattr(modifier, name, False) for name in PARTIAL)
        if modifier.show_render and modifier.type in ALONG and plain:
            found.setdefault(modifier.type, modifier)
    return list(found.values())


def _line_set(name, modifier, kinds, source, pen):
    first = modifier.level_start
    last = max(first, modifier.level_end) if modifier.use_multiple_levels else first
    hidden = (style.Hidden(pen=pen, first=max(first, 1), last=last),) if last > 0 else ()
    return style.LineSet(
        name=name, kinds=kinds, pen=pen if first == 0 else style.Pen(opacity=0.0), hidden=hidden, **source
    )


def _color(material):
    """RGBA of a Grease Pencil material's strokes; black without one."""
    pencil = material and material.grease_pencil
    return tuple(pencil.color) if pencil else (0.0, 0.0, 0.0, 1.0)


def _width(modifier, scene, depsgraph):
    """Width in reference pixels. Strokes of Grease Pencil have a width in space: what it is at the mean distance of the
    scene's objects."""
    in_space = modifier.radius if hasattr(modifier, "radius") else modifier.thickness / 1000  # `radius` is the width
    if not scene.camera:
        return DEFAULT_WIDTH
    view = camera.of_scene(depsgraph)
    middles = [
        np.array(obj.matrix_world) @ np.append(np.mean(obj.bound_box, axis=0), 1.0)
        for obj in scene.objects
        if obj.type == "MESH" and obj.visible_get()
    ]
    distances = [-(view.world_to_view @ middle)[2] for middle in middles]
    ahead = [distance for distance in distances if distance > view.near_clip]
    if not ahead:
        return DEFAULT_WIDTH
    distance = 1.0 if view.orthographic else float(np.mean(ahead))
    width = in_space * float(view.view_to_clip[1, 1]) / distance / 2 * view.frame[3] / view.reference_scale
    return min(max(width, WIDTHS[0]), WIDTHS[1])


def _unmatched(scene, obj, modifier):
    """Yields phrases on settings of a modifier, and of its object's others, that are not converted."""
    yield from (what for name, what in UNMATCHED.items() if _is_set(getattr(modifier, name, False)))
    light, lights = modifier.light_contour_object, {other for other in scene.objects if other.type == "LIGHT"}
    if lights != {light} and any(_draws(modifier, word) for word in BY_LIGHT):
        yield f"lines by '{light.name}' alone: they are by the lights of the scene"
    if modifier.use_invert_silhouette and modifier.silhouette_filtering != "NONE":
        yield "lines inside the silhouette alone"
    known = [other.name for other in _of_all_strokes(obj)]
    shown = [other.name for other in obj.modifiers if other.show_render and other.type != "LINEART"]
    others = [name for name in shown if name not in known]
    if others:
        yield f"the modifiers {', '.join(others)}"


def _is_set(value):
    """Of a switch, a text, or an array of switches."""
    return bool(value) if isinstance(value, (bool, str)) else any(value)


class FOVEA_OT_match_line_art(Operator, bpy.types.Operator):
    """Take over the scene's Line Art modifiers: edge types, crease angle, source, levels, the width, color and opacity
    of their strokes, and which objects Line Art excludes or has only hide others"""

    bl_idname = "fovea.match_line_art"
    bl_label = "Match Line Art"

    @classmethod
    def hindrance(cls, context):
        if not pencils.are_there():
            return "Line Art can be matched in Blender 4.3 and later: before, its modifiers are of another kind"
        if not any(modifiers_of(context.scene)):
            return "The scene has no Line Art modifier that renders show: there is nothing to match"
        return None if definitions() else "Fovea's native module cannot be used in this Blender"

    def act(self, context):
        chosen, told = style_of(context.scene, context.evaluated_depsgraph_get())
        if not chosen.line_sets:
            raise style.StyleError("; ".join(["The Line Art modifiers draw nothing that Fovea could", *told]))
        style_data.use(context.scene, chosen, "Line Art")
        usages, left = line_art_usage.usages(context.scene)
        for obj, usage in usages.items():
            obj.fovea.usage = usage
        if told := told + left:
            self.report({"WARNING"}, f"Not taken over: {'; '.join(told)}")
