# SPDX-License-Identifier: GPL-3.0-or-later
"""Which lines an object has of its own accord, whatever the line sets say: its kinds, by the registry, and the angle of
its creases."""

import math

import bpy
from bpy.props import BoolProperty, FloatProperty, PointerProperty

from .line_kinds import definitions
from .property_kinds import neat, redraw

ALL_KINDS = 0xFFFFFFFF  # bits of the registry
AS_THE_SET_SAYS = math.nan


def of(settings):
    """(bits of the registry that an object shows, degrees between the faces of a crease or NaN) of its settings."""
    kinds, angle = ALL_KINDS, AS_THE_SET_SAYS
    if settings.own_kinds:
        for bit, definition in enumerate(definitions()):
            if not getattr(settings.kinds, definition["name"], True):
                kinds &= ~(1 << bit)
    if settings.own_crease_angle:
        angle = neat(math.degrees(settings.crease_angle))
    return kinds, angle


def switchable():
    """Definitions that an object may do without: lines found in the picture are of no object."""
    return [definition for definition in definitions() if not definition["in_image"]]


def _kinds():
    """The PropertyGroup of switches, by the registry. All are on: what the line sets draw is shown."""
    found = {}
    for definition in switchable():
        told = f"{definition['description']}.\nOff: this object does not have them, whichever line set draws them"
        text = {"name": definition["label"], "description": told}
        found[definition["name"]] = BoolProperty(default=True, update=redraw, **text)
    contents = {"__annotations__": found, "__module__": __name__, "__doc__": "Kinds of lines that an object shows."}
    return type("FoveaOwnKinds", (bpy.types.PropertyGroup,), contents)


def annotations(kinds):
    """Of an object's settings; `kinds`: the registered group."""
    return {
        "own_kinds": BoolProperty(
            name="Own Line Kinds",
            description="Of the lines that the line sets draw, this object and instances of it have only these kinds",
            update=redraw,
        ),
        "kinds": PointerProperty(type=kinds),
        "own_crease_angle": BoolProperty(
            name="Own Crease Angle",
            description="Creases of this object, and of instances of it, have an angle of their own in all line sets",
            update=redraw,
        ),
        "crease_angle": FloatProperty(
            name="Crease Angle",
            description="Least angle between the normals of two faces that makes their edge a crease; less: more lines",
            subtype="ANGLE",
            default=math.radians(30.0),
            min=0.0,
            max=math.pi,
            update=redraw,
        ),
    }


_registered = []


def register():
    """The group of kinds, registered."""
    _registered.append(_kinds())
    bpy.utils.register_class(_registered[0])
    return _registered[0]


def unregister():
    bpy.utils.unregister_class(_registered.pop())
