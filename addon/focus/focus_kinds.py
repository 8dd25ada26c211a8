# SPDX-License-Identifier: GPL-3.0-or-later
"""Focus models of a scene: labels, the properties each uses, and which tools apply to it.
The fall-off itself is computed in the core (native/fovea/style/focus.h)."""

from dataclasses import dataclass

IN_SPACE = ("focus_near_distance", "focus_far_distance")  # inner and outer radius in scene units
IN_FRAME = ("focus_near", "focus_far")  # the same in heights of the camera's frame
PICKED = "SCENE"  # the model set when a point in space is picked


@dataclass(frozen=True)
class Kind:
    label: str
    description: str
    settings: tuple = ()  # names of the scene properties that it uses
    place: tuple = ()  # names of the properties of each focus point; (): it has no points
    in_frame: bool = False  # points lie in the camera's frame, else in world space
    is_surface: bool = False  # distance is to the surface of the point's object, not to a point
    no_pull: str = ""  # why Focus Pull and viewport gizmos are unavailable; "": they are available

    @property
    def is_on(self):
        """Whether it defines any focus."""
        return bool(self.settings or self.place)

    @property
    def radii(self):
        """Names of the inner and outer radius properties of a focus point."""
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
    """The Kind selected in a scene's settings."""
    return KINDS[settings.focus_model]
