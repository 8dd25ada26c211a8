# SPDX-License-Identifier: GPL-3.0-or-later
"""Focus points: their location in the scene and in a viewport, and how they are set and moved.

`place` is the property group of one point; the first point's properties are those of the scene itself."""

import bpy
from bpy_extras.view3d_utils import location_3d_to_region_2d, region_2d_to_location_3d
from mathutils import Vector

from .. import style
from . import focus_kinds

EMPTY = "Focus"  # name of new Empties that mark focus points


def places(settings):
    """Property groups of all focus points: the scene's settings for the first, then `focus_points`."""
    return (settings, *settings.focus_points)


def location(place):
    """World coordinates of a focus point: its object's origin, or else its own location."""
    source = place.focus_object
    return source.matrix_world.translation.copy() if source else Vector(place.focus_location)


def put(scene, at, *, add=False):
    """Sets the first focus point to world coordinates or, with `add`, appends one; returns its properties. It is marked
    by an Empty: the one it has, or a new one. ValueError if there are style.MOST_PLACES already."""
    settings = scene.fovea
    place = another(settings) if add and settings.focus_model == focus_kinds.PICKED else settings
    settings.focus_model = focus_kinds.PICKED
    mark = place.focus_object
    if mark is None or mark.type != "EMPTY":
        mark = bpy.data.objects.new(EMPTY, None)
        mark.empty_display_type, mark.empty_display_size = "PLAIN_AXES", 0.5
    if mark.name not in scene.objects:
        scene.collection.objects.link(mark)
    move(mark, at)
    place.focus_object = mark
    key(scene, mark, "location")
    return place


def put_object(scene, obj, *, add=False):
    """Sets the first focus point to an object's surface or, with `add`, appends one."""
    place = another(scene.fovea) if add else scene.fovea
    place.focus_object = obj


def put_in_image(scene, at, *, add=False):
    """Sets the first focus point to a position in the camera's frame (0 to 1 from the left and the top) or, with `add`,
    appends one."""
    place = another(scene.fovea) if add else scene.fovea
    place.focus_place = at
    key(scene, place, "focus_place")


def key(scene, owner, name):
    """Inserts a keyframe for a property that was just set, if the scene has Auto Keying on."""
    if scene.tool_settings.use_keyframe_insert_auto:
        owner.keyframe_insert(name)


def another(settings):
    """Appends a focus point with the radii of the first. ValueError if there are style.MOST_PLACES already."""
    if len(settings.focus_points) + 1 >= style.MOST_PLACES:
        raise ValueError(f"There are {style.MOST_PLACES} places to look at already, no more can be added")
    place = settings.focus_points.add()
    for name in focus_kinds.of(settings).radii:
        setattr(place, name, getattr(settings, name))
    return place


def move(obj, at):
    """Moves an object's origin to world coordinates."""
    if obj.parent is None and not obj.constraints:
        obj.location = at
        return
    matrix = obj.matrix_world.copy()
    matrix.translation = at
    obj.matrix_world = matrix


class Look:
    """Maps focus points to region pixels of a 3D viewport and back. `frame`: left, lower, width and height of the
    camera's frame in region pixels; None outside camera view."""

    def __init__(self, region, view, frame):
        self.region, self.view, self.frame = region, view, frame

    def center(self, place, kind):
        """Region pixel of a focus point, or None if it does not project into the view."""
        if kind.in_frame:
            left, lower, width, height = self.frame
            return Vector((left + place.focus_place[0] * width, lower + (1 - place.focus_place[1]) * height))
        return location_3d_to_region_2d(self.region, self.view, location(place))

    def unit(self, place, kind):
        """Pixels per unit of a focus point's radii."""
        return self.frame[3] if kind.in_frame else self.unit_at(location(place))

    def unit_at(self, at):
        """Pixels per scene unit at a world location, measured along the view's x axis; 0 if it does not project."""
        across = Vector(self.view.view_matrix[0][:3])
        a, b = (location_3d_to_region_2d(self.region, self.view, end) for end in (at, at + across))
        return (b - a).length if a and b else 0.0

    def in_frame(self, px):
        """Position of a region pixel in the camera's frame, 0 to 1 from the left and the top."""
        left, lower, width, height = self.frame
        return (px[0] - left) / width, 1 - (px[1] - lower) / height

    def move(self, place, kind, px):
        """Moves a focus point to a region pixel; one in space moves parallel to the view plane, at its depth."""
        if kind.in_frame:
            place.focus_place = self.in_frame(px)
            return
        at = region_2d_to_location_3d(self.region, self.view, px, location(place))
        if place.focus_object:
            move(place.focus_object, at)
        else:
            place.focus_location = at


def fit_radii(settings, height):
    """Sets the radii of the first focus point to 0.1 and 0.4 of `height`, the visible height at the point in scene
    units, unless the user has set either."""
    near, far = focus_kinds.IN_SPACE
    if height > 0 and not (settings.is_property_set(near) or settings.is_property_set(far)):
        setattr(settings, near, 0.1 * height)
        setattr(settings, far, 0.4 * height)
