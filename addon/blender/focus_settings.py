"""Focus and the effects that answer to it, as properties of the scene; their curves stay those of the style."""

from dataclasses import fields, replace

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, FloatVectorProperty, PointerProperty

from .. import focus
from . import pens
from .property_kinds import attribute_name, number, redraw

LINE_EFFECTS = {
    "color": "Colour of lines",
    "texture": "Ink of lines",
    "width": "Width of lines",
    "opacity": "Opacity of lines",
    "density": "How near to each other lines may be",
    "overshoot": "How far lines overshoot",
}
COLOR_EFFECTS = {
    "desaturation": "How far colours turn grey",
    "fade": "How far colours turn into the paper's",
    "blur": "How far colours blur",
}
DISTANCE_EFFECTS = ("width", "opacity", "density")
AWAY = "away_pen"  # what the names of the properties of the pen out of focus begin with

MODELS = [
    ("NONE", "None", "All is in focus"),
    ("IMAGE", "Place in the Image", "Focus falls off from a place in the image"),
    ("SCENE", "Place in the Scene", "Focus falls off from an object's origin, or a point, in space"),
    ("OBJECT", "Object", "Focus falls off from an object's surface, and from those of its instances"),
    ("PAINTED", "Painted", "An attribute of the meshes says what is in focus: white is, black is not"),
]
COMBINATIONS = [
    ("NEAREST", "Nearest", "Of several places the nearest counts"),
    ("SUM", "Sum", "What several places leave in focus adds up"),
]
MODES = [
    ("EMPHASIZED", "Emphasized", "As focus says"),
    ("UNIFORM", "Uniform", "The same all over the image"),
    ("NONE", "None", "Not drawn"),
]
NUMBERS = {
    "start": ("Start", "{}: the focus (0 in, 1 out of focus) at which the effect begins"),
    "end": ("End", "{}: the focus at which the effect is whole; less than the start turns it round"),
    "strength": ("Strength", "{}: how strong the effect is there"),
}


def style_parts(settings, base):
    """{field of Style: value} of what the panel says; `base`: the Style whose curves hold."""
    effects = {name: _transfer(settings, f"effect_{name}", old) for name, old in _transfers(base.effects)}
    effects |= {
        "lines": settings.effect_lines.lower(),
        "colors": settings.effect_colors.lower(),
        "uniform": settings.effect_uniform,
        "blur_radius": settings.effect_blur_radius,
    }
    distance = {name: _transfer(settings, f"distance_{name}", old) for name, old in _transfers(base.distance)}
    near, far = settings.distance_near, max(settings.distance_far, settings.distance_near + 1e-6)
    return {
        "focus": _focus(settings),
        "effects": replace(base.effects, **effects),
        "distance": replace(base.distance, near=near, far=far, **distance),
    }


def line_set_parts(settings):
    """{field of LineSet: value} of what the panel says of lines out of focus."""
    if not settings.away:
        return {"pen_away": None, "overshoot_away": None}
    return {"pen_away": pens.pen_of(settings, AWAY), "overshoot_away": settings.away_overshoot}


def apply(settings, chosen):
    """Sets the properties to what a Style says; where to look stays as it is unless the style says so."""
    for name, transfer in _transfers(chosen.effects):
        _set_transfer(settings, f"effect_{name}", transfer)
    for name, transfer in _transfers(chosen.distance):
        _set_transfer(settings, f"distance_{name}", transfer)
    settings.distance_near, settings.distance_far = chosen.distance.near, chosen.distance.far
    settings.effect_lines, settings.effect_colors = chosen.effects.lines.upper(), chosen.effects.colors.upper()
    settings.effect_uniform, settings.effect_blur_radius = chosen.effects.uniform, chosen.effects.blur_radius
    if chosen.focus.active():
        set_focus(settings, chosen.focus)
    last = chosen.line_sets[-1]
    settings.away = last.pen_away is not None or last.overshoot_away is not None
    pens.set_pen(settings, AWAY, last.pen_away or last.pen)
    settings.away_overshoot = last.overshoot if last.overshoot_away is None else last.overshoot_away


def set_focus(settings, wanted):
    """Sets where to look to what a Focus says."""
    settings.focus_model, settings.focus_combine = wanted.model.upper(), wanted.combine.upper()
    if wanted.model == "painted":
        settings.focus_attribute = wanted.attribute
    settings.focus_points.clear()
    for i, point in enumerate(wanted.points):
        place = settings if i == 0 else settings.focus_points.add()
        _set_point(place, point, wanted.model)


def keep_effects(settings, names):
    """Takes all strength from the effects that are not named."""
    known = LINE_EFFECTS | COLOR_EFFECTS
    unknown = sorted(set(names) - set(known))
    if unknown:
        raise ValueError(f"there is no effect '{unknown[0]}'; there are: {', '.join(known)}")
    for name in known.keys() - set(names):
        setattr(settings, f"effect_{name}_strength", 0.0)


def annotations(chosen):
    """Annotations of the scene's settings, by a Style's defaults."""
    last = chosen.line_sets[-1]
    found = {
        "focus_model": EnumProperty(name="Focus", items=MODELS, update=redraw),
        "focus_combine": EnumProperty(name="Combine", items=COMBINATIONS, update=redraw),
        "focus_attribute": attribute_name(
            "Attribute", "Of meshes: white (1) is in focus, black (0) out of it; half way where meshes have none", "focus"
        ),
        **_point_annotations(),
        "focus_points": bpy.props.CollectionProperty(
            type=FoveaFocusPoint, name="More Places", description="Further places to look at"
        ),
        "effect_lines": EnumProperty(name="Lines", items=MODES, default=chosen.effects.lines.upper(), update=redraw),
        "effect_colors": EnumProperty(
            name="Colours", items=MODES, default=chosen.effects.colors.upper(), update=redraw
        ),
        "effect_uniform": number(
            "Uniform Focus", "uniform", chosen.effects.uniform, "Focus everywhere, of what is uniform"
        ),
        "effect_blur_radius": number(
            "Blur Radius", "blur_radius", chosen.effects.blur_radius, "Of the full blur, in pixels of an image 1080 pixels high"
        ),
        "distance_near": _distance_property("Near", chosen.distance.near, "Distance from the camera at which effects begin"),
        "distance_far": _distance_property("Far", chosen.distance.far, "Distance from the camera at which effects are whole"),
        "away": BoolProperty(
            name="Pen out of Focus",
            description="Lines out of focus are drawn with a pen of their own",
            default=last.pen_away is not None,
            update=redraw,
        ),
        "away_overshoot": number(
            "Overshoot",
            "overshoot",
            last.overshoot if last.overshoot_away is None else last.overshoot_away,
            "How far lines out of focus go on beyond their ends, in pixels of an image 1080 pixels high",
        ),
        **pens.pen_properties(AWAY, last.pen_away or last.pen, "lines out of focus"),
    }
    told = LINE_EFFECTS | COLOR_EFFECTS
    for name, transfer in _transfers(chosen.effects):
        found |= _transfer_annotations(f"effect_{name}", transfer, told[name])
    for name, transfer in _transfers(chosen.distance):
        found |= _transfer_annotations(f"distance_{name}", transfer, f"{told[name]}, by distance")
    return found


def _focus(settings):
    model = settings.focus_model
    attribute = settings.focus_attribute if model == "PAINTED" else ""
    return focus.Focus(model.lower(), _points(settings), settings.focus_combine.lower(), attribute)


def _points(settings):
    return tuple(_point(place, settings.focus_model) for place in (settings, *settings.focus_points))


def _point(place, model):
    name = ""
    if model == "IMAGE":
        at, near, far = (*place.focus_place, 0.0), place.focus_near, place.focus_far
    else:
        source = place.focus_object
        at = source.matrix_world.translation if source else place.focus_location
        at, near, far = tuple(at), place.focus_near_distance, place.focus_far_distance
        if source and model == "OBJECT":
            name = source.name_full
    return focus.Point(tuple(float(v) for v in at), near, max(near, far), name)


def _set_point(place, point, model):
    if model == "image":
        place.focus_place = point.at[:2]
        place.focus_near, place.focus_far = point.near, point.far
    else:
        named = (obj for obj in bpy.data.objects if point.object and obj.name_full == point.object)
        place.focus_object, place.focus_location = next(named, None), point.at
        place.focus_near_distance, place.focus_far_distance = point.near, point.far


def _point_annotations():
    return {
        "focus_place": FloatVectorProperty(
            name="Place",
            description="From the left and from the top of the camera's frame, 0 to 1",
            size=2,
            default=(0.5, 0.5),
            soft_min=0.0,
            soft_max=1.0,
            precision=3,
            step=1,
            update=redraw,
        ),
        "focus_near": _radius("In Focus", 0.1, "Radius that is in focus, in heights of the frame"),
        "focus_far": _radius("Out of Focus", 0.6, "Radius from which all is out of focus, in heights of the frame"),
        "focus_object": PointerProperty(
            type=bpy.types.Object,
            name="Object",
            description="Its origin, or its surface, is what to look at",
            update=redraw,
        ),
        "focus_location": FloatVectorProperty(
            name="Location",
            description="The place to look at where there is no object",
            size=3,
            subtype="XYZ",
            unit="LENGTH",
            update=redraw,
        ),
        "focus_near_distance": _distance_property("In Focus", 1.0, "Radius that is in focus"),
        "focus_far_distance": _distance_property("Out of Focus", 5.0, "Radius from which all is out of focus"),
    }


def _radius(name, default, told):
    return FloatProperty(name=name, description=told, default=default, min=0.0, soft_max=2.0, update=redraw)


def _distance_property(name, default, told):
    return FloatProperty(name=name, description=told, default=default, min=0.0, subtype="DISTANCE", update=redraw)


def _transfers(data):
    """(name, Transfer) of a dataclass that has some."""
    return [(f.name, getattr(data, f.name)) for f in fields(data) if isinstance(getattr(data, f.name), focus.Transfer)]


def _transfer(settings, prefix, old):
    return replace(old, **{name: getattr(settings, f"{prefix}_{name}") for name in NUMBERS})


def _set_transfer(settings, prefix, transfer):
    for name in NUMBERS:
        setattr(settings, f"{prefix}_{name}", getattr(transfer, name))


def _transfer_annotations(prefix, transfer, told):
    return {
        f"{prefix}_{name}": FloatProperty(
            name=label,
            description=words.format(told),
            default=getattr(transfer, name),
            min=0.0,
            max=1.0,
            update=redraw,
        )
        for name, (label, words) in NUMBERS.items()
    }


class FoveaFocusPoint(bpy.types.PropertyGroup):
    """A further place to look at."""

    __annotations__ = _point_annotations()


def register():
    bpy.utils.register_class(FoveaFocusPoint)


def unregister():
    bpy.utils.unregister_class(FoveaFocusPoint)
