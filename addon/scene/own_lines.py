# SPDX-License-Identifier: GPL-3.0-or-later
"""Per-object overrides of line sets: the kinds of lines that an object shows, and values of those parameters that the
registry marks as per object."""

import math

from .. import catalogue
from .line_kinds import definitions, parameter_property, property_name, value_of
from .property_kinds import new_group, part, switch

ALL_KINDS = 0xFFFFFFFF  # bit i: the registry's definition i
AS_THE_SET_SAYS = math.nan


def of(settings):
    """(bits of the kinds that an object shows, then its value of each of `parameters()`, NaN: not overridden)."""
    kinds = ALL_KINDS
    if settings.own_kinds:
        for bit, definition in enumerate(definitions()):
            if not getattr(settings.kinds, definition["name"], True):
                kinds &= ~(1 << bit)
    return kinds, *(_own_value(settings, *known) for known in parameters())


def _own_value(settings, definition, parameter):
    own = getattr(settings, switch_name(definition, parameter))
    return value_of(settings, definition, parameter) if own else AS_THE_SET_SAYS


def parameters():
    """The (definition, parameter) that an object may override; () without the native module."""
    return catalogue.per_object() if definitions() else ()


def switch_name(definition, parameter):
    """Name of the property that switches an object's override of a parameter on."""
    return f"own_{property_name(definition, parameter)}"


def label(definition, parameter):
    return f"{definition['label']} {parameter['label']}"


def switchable():
    """Definitions that can be switched off per object: all but image-space lines, which belong to no object."""
    return [definition for definition in definitions() if not definition["in_image"]]


def kinds():
    """The PropertyGroup class of switches, generated from the registry; all are on by default."""
    found = {}
    for definition in switchable():
        told = f"{definition['description']}.\nOff: this object does not have them, whichever line set draws them"
        found[definition["name"]] = switch(definition["label"], told, default=True)
    return new_group("FoveaOwnKinds", "Kinds of lines that an object shows.", found)


def annotations(kinds):
    """Property annotations for an object's settings; `kinds`: the registered group of `kinds()`."""
    told = "Of the lines that the line sets draw, this object and instances of it have only these types"
    found = {"own_kinds": switch("Override Line Types", told), "kinds": part(kinds)}
    for known in parameters():
        name = label(*known)
        told = f"This object, and instances of it, have their own {name.lower()} in all line sets"
        found[switch_name(*known)] = switch(f"Override {name}", told)
        found[property_name(*known)] = parameter_property(known[1], name)
    return found
