# SPDX-License-Identifier: GPL-3.0-or-later
"""Focus as properties of the scene, separate from the style, so that scenes can share a style with different focus."""

import bpy

from .. import style
from ..scene.property_kinds import choice, members, number, pointer, text, vector
from . import focus_kinds

MOST_LETTERS = 63  # Blender's limit on the length of an attribute name
MODELS = [(name, kind.label, kind.description) for name, kind in focus_kinds.KINDS.items()]
COMBINATIONS = [
    ("NEAREST", "Nearest", "Of several places the nearest counts"),
    ("SUM", "Sum", "What several places leave in focus adds up"),
]


def set_focus(settings, wanted):
    """Writes a Focus to the properties."""
    settings.focus_model, settings.focus_combine = wanted.model.upper(), wanted.combine.upper()
    kind = focus_kinds.of(settings)
    if "focus_attribute" in kind.settings:
        settings.focus_attribute = wanted.attribute
    settings.focus_points.clear()
    for i, point in enumerate(wanted.points):
        place = settings if i == 0 else settings.focus_points.add()
        _set_point(place, point, kind)


def annotations():
    """Property annotations for the scene's settings."""
    painted = "Of meshes: white (1) is in focus, black (0) out of it; half way where there is none"
    more = {"name": "More Places", "description": "Further places to look at"}
    return {
        "focus_model": choice("Focus On", "What says where the viewer shall look", items=MODELS),
        "focus_combine": choice("Combine", "What holds where several places count", items=COMBINATIONS),
        "focus_attribute": text("Attribute", painted, default="focus", maxlen=MOST_LETTERS),
        **_point_annotations(),
        "focus_points": members(FoveaFocusPoint, **more),
        "pull_object": pointer("To", "The object that Focus Pull leads to", type=bpy.types.Object, options={"HIDDEN"}),
    }


def focus_of(settings):
    """Reads the Focus from the properties."""
    kind = focus_kinds.of(settings)
    if not kind.is_on:
        return style.Focus()
    attribute = settings.focus_attribute if "focus_attribute" in kind.settings else ""
    points = tuple(_point(place, kind) for place in (settings, *settings.focus_points))
    return style.Focus(
        model=settings.focus_model.lower(),
        points=points,
        combine=settings.focus_combine.lower(),
        attribute=attribute,
    )


def _point(place, kind):
    source = None if kind.in_frame else place.focus_object
    at = (*place.focus_place, 0.0) if kind.in_frame else place.focus_location
    if source:
        at = source.matrix_world.translation
    near, far = (getattr(place, name) for name in kind.radii)
    name = source.name_full if source and kind.is_surface else ""
    return style.FocusPlace(at=tuple(float(v) for v in at), near=near, far=max(near, far), object=name)


def _set_point(place, point, kind):
    if kind.in_frame:
        place.focus_place = point.at[:2]
    else:
        named = (obj for obj in bpy.data.objects if point.object and obj.name_full == point.object)
        place.focus_object, place.focus_location = next(named, None), point.at
    for name, radius in zip(kind.radii, (point.near, point.far)):
        setattr(place, name, radius)


def _point_annotations():
    place = {"subtype": "XYZ", "size": 2, "default": (0.5, 0.5), "soft_min": 0.0, "soft_max": 1.0}
    in_image = {"min": 0.0, "soft_max": 2.0}
    in_scene = {"min": 0.0, "soft_max": 1000.0, "subtype": "DISTANCE"}
    near, far = ("Inner Radius", "Up to here all is in focus"), ("Outer Radius", "From here on nothing is in focus")
    at = "From the left and from the top of the camera's frame, 0 to 1"
    told = "The place to look at where there is no object"
    return {
        "focus_place": vector("Place", at, precision=3, step=1, **place),
        "focus_near": number(f"{near[0]} (Heights)", f"{near[1]}, in heights of the frame", default=0.1, **in_image),
        "focus_far": number(f"{far[0]} (Heights)", f"{far[1]}, in heights of the frame", default=0.6, **in_image),
        "focus_object": pointer("Object", "Its origin, or its surface, is what to look at", type=bpy.types.Object),
        "focus_location": vector("Location", told, size=3, subtype="XYZ", unit="LENGTH"),
        "focus_near_distance": number(*near, default=1.0, **in_scene),
        "focus_far_distance": number(*far, default=5.0, **in_scene),
    }


POINT = tuple(_point_annotations())  # names of the properties of a focus point


class FoveaFocusPoint(bpy.types.PropertyGroup):
    """A further place to look at."""

    __annotations__ = _point_annotations()
