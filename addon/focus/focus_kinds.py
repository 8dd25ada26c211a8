# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinds of focus, as scenes have them: what each is called, which properties it uses, and what tools may do with it.
How focus falls off is the core's (native/fovea/style/focus.h)."""

from dataclasses import dataclass

IN_SPACE = ("focus_near_distance", "focus_far_distance")  # radii of places there
IN_FRAME = ("focus_near", "focus_far")
PICKED = "SCENE"  # the kind that a click in a viewport makes of another, where that has no places


@dataclass(frozen=True)
class Kind:
    label: str
    description: str
    settings: tuple = ()  # names of the scene's properties that it uses
    place: tuple = ()  # names of properties of each place to look at; (): it has none
    in_frame: bool = False  # places lie in the camera's frame, else in space
    is_surface: bool = False  # a place is the surface of its object, not a point
    no_pull: str = ""  # why it cannot be led elsewhere over time; "": it can, and places have handles in viewports

    @property
    def is_on(self):
        """Whether it says where to look."""
        return bool(self.settings or self.place)

    @property
    def radii(self):
        """Names of a place's inner and outer radius."""
        return IN_FRAME if self.in_frame else IN_SPACE


KINDS = {
    "NONE": Kind("None", "All is in focus", no_pull="There is no focus yet: pick one first"),
    "IMAGE": Kind(
        "Place in the Image",
        "Focus falls off from a place in the image",
        place=("focus_place", *IN_FRAME),
        in_frame=True,
    ),
    "SCENE": Kind(
        "Place in the Scene",
        "Focus falls off from an object's origin, or a point, in space",
        place=("focus_object", "focus_location", *IN_SPACE),
    ),
    "OBJECT": Kind(
        "Object",
        "Focus falls off from an object's surface, and from those of its instances",
        place=("focus_object", *IN_SPACE),
        is_surface=True,
        no_pull="The focus is an object's surface: pick a place in the scene to lead it elsewhere",
    ),
    "PAINTED": Kind(
        "Painted",
        "An attribute of the meshes says what is in focus: white is, black is not",
        settings=("focus_attribute",),
        no_pull="The focus is painted on meshes: pick a place in the scene to lead it elsewhere",
    ),
}


def of(settings):
    """The Kind that a scene's settings have."""
    return KINDS[settings.focus_model]
