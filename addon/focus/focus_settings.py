# SPDX-License-Identifier: GPL-3.0-or-later
"""Where to look, as properties of the scene: a style may be drawn with any focus, and shared by scenes with others."""

import bpy
from bpy.props import EnumProperty, FloatProperty, FloatVectorProperty, PointerProperty

from .. import style
from ..scene.property_kinds import attribute_name, redraw

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


def set_focus(settings, wanted):
    """Sets where to look to what a Focus says."""
    settings.focus_model, settings.focus_combine = wanted.model.upper(), wanted.combine.upper()
    if wanted.model == "painted":
        settings.focus_attribute = wanted.attribute
    settings.focus_points.clear()
    for i, point in enumerate(wanted.points):
        place = settings if i == 0 else settings.focus_points.add()
        _set_point(place, point, wanted.model)


def annotations():
    """Annotations of the scene's settings."""
    return {
        "focus_model": EnumProperty(
            name="Focus On", description="What says where the viewer shall look", items=MODELS, update=redraw
        ),
        "focus_combine": EnumProperty(
            name="Combine", description="What holds where several places count", items=COMBINATIONS, update=redraw
        ),
        "focus_attribute": attribute_name(
            "Attribute", "Of meshes: white (1) is in focus, black (0) out of it; half way where there is none", "focus"
        ),
        **_point_annotations(),
        "focus_points": bpy.props.CollectionProperty(
            type=FoveaFocusPoint, name="More Places", description="Further places to look at"
        ),
    }


def focus_of(settings):
    """The Focus that the properties describe."""
    model = settings.focus_model
    if model == "NONE":
        return style.Focus()
    attribute = settings.focus_attribute if model == "PAINTED" else ""
    return style.Focus(
        model=model.lower(), points=_points(settings), combine=settings.focus_combine.lower(), attribute=attribute
    )


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
    return style.FocusPlace(at=tuple(float(v) for v in at), near=near, far=max(near, far), object=name)


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
            subtype="XYZ",
            size=2,
            default=(0.5, 0.5),
            soft_min=0.0,
            soft_max=1.0,
            precision=3,
            step=1,
            update=redraw,
        ),
        "focus_near": _radius("Inner Radius", 0.1, "Up to here all is in focus, in heights of the frame"),
        "focus_far": _radius("Outer Radius", 0.6, "From here on nothing is in focus, in heights of the frame"),
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
        "focus_near_distance": _distance_property("Inner Radius", 1.0, "Up to here all is in focus"),
        "focus_far_distance": _distance_property("Outer Radius", 5.0, "From here on nothing is in focus"),
    }


def _radius(name, default, told):
    return FloatProperty(name=name, description=told, default=default, min=0.0, soft_max=2.0, update=redraw)


def _distance_property(name, default, told):
    limits = {"min": 0.0, "soft_max": 1000.0, "subtype": "DISTANCE"}
    return FloatProperty(name=name, description=told, default=default, update=redraw, **limits)


class FoveaFocusPoint(bpy.types.PropertyGroup):
    """A further place to look at."""

    __annotations__ = _point_annotations()


def register():
    bpy.utils.register_class(FoveaFocusPoint)


def unregister():
    bpy.utils.unregister_class(FoveaFocusPoint)
