# SPDX-License-Identifier: GPL-3.0-or-later
"""The places to look at: where they are in the scene and in a viewport, and how they are moved."""

import bpy
from bpy_extras.view3d_utils import location_3d_to_region_2d, region_2d_to_location_3d
from mathutils import Vector

from .. import style
from . import focus_kinds

EMPTY = "Focus"  # name of the objects that are made to mark places


def places(settings):
    """All places of a scene's settings, the first first."""
    return (settings, *settings.focus_points)


def location(place):
    """World coordinates of a place in the scene."""
    source = place.focus_object
    return source.matrix_world.translation.copy() if source else Vector(place.focus_location)


def put(scene, at, *, add=False):
    """Makes world coordinates the place to look at, or one more; the place. An Empty marks it: that which marks it
    already, or a new one. ValueError where there are as many as can be."""
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
    """Makes an object's surface the place to look at, or one more."""
    settings = scene.fovea
    place = another(settings) if add else settings
    place.focus_object = obj
    return place


def put_in_image(scene, at, *, add=False):
    """Makes a place of the camera's frame (from the left and the top) the one to look at, or one more."""
    settings = scene.fovea
    place = another(settings) if add else settings
    place.focus_place = at
    key(scene, place, "focus_place")
    return place


def key(scene, owner, name):
    """Keys a property that has just been set, where the scene keys by itself."""
    if scene.tool_settings.use_keyframe_insert_auto:
        owner.keyframe_insert(name)


def another(settings):
    """One more place, with the radii of the first."""
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
    """Places as a 3D viewport shows them, in pixels of its region. `frame`: left, lower, width and height of the
    camera's frame there."""

    def __init__(self, region, view, frame):
        self.region, self.view, self.frame = region, view, frame

    def center(self, place, kind):
        """Pixels of a place, or None where it is not to be seen."""
        if kind.in_frame:
            left, lower, width, height = self.frame
            return Vector((left + place.focus_place[0] * width, lower + (1 - place.focus_place[1]) * height))
        return location_3d_to_region_2d(self.region, self.view, location(place))

    def unit(self, place, kind):
        """Pixels of one unit of a place's radii."""
        return self.frame[3] if kind.in_frame else self.unit_at(location(place))

    def unit_at(self, at):
        """Pixels of one unit of the scene, across the view."""
        across = Vector(self.view.view_matrix[0][:3])
        ends = (location_3d_to_region_2d(self.region, self.view, end) for end in (at, at + across))
        a, b = ends
        return (b - a).length if a and b else 0.0

    def in_frame(self, px):
        """A place of the camera's frame, from the left and the top."""
        left, lower, width, height = self.frame
        return (px[0] - left) / width, 1 - (px[1] - lower) / height

    def move(self, place, kind, px):
        """Moves a place to pixels of the region; in the scene across the view, as far away as it is."""
        if kind.in_frame:
            place.focus_place = self.in_frame(px)
            return
        at = region_2d_to_location_3d(self.region, self.view, px, location(place))
        if place.focus_object:
            move(place.focus_object, at)
        else:
            place.focus_location = at


def fit_radii(settings, height):
    """Radii by what is to be seen, `height` units at the place, unless somebody has chosen them."""
    near, far = focus_kinds.IN_SPACE
    if height > 0 and not (settings.is_property_set(near) or settings.is_property_set(far)):
        setattr(settings, near, 0.1 * height)
        setattr(settings, far, 0.4 * height)
