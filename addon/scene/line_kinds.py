# SPDX-License-Identifier: GPL-3.0-or-later
"""The kinds of lines of a line set, as properties made from the native registry, which declares them.

Per line definition a switch named as it, and its parameters as `<definition>_<parameter>`; angles are stored in
radians, as Blender shows them.
"""

import math

from .. import catalogue, native
from .property_kinds import neat, new_group, number, switch

SLIDE = 20  # how many times the default a parameter is dragged to


def definitions():
    """The line definitions; none where the native module is missing, so that files keep their other settings."""
    try:
        return catalogue.definitions()
    except native.Unavailable:
        return ()


def read(kinds):
    """{definition: {parameter: value in the registry's unit}} of the kinds that are on."""
    return {d["name"]: _values(kinds, d) for d in definitions() if getattr(kinds, d["name"])}


def write(kinds, wanted):
    """Switches on what `wanted` has, as `read` gives it, with the registry's defaults where it says nothing."""
    for definition in definitions():
        name = definition["name"]
        defaults = {parameter["name"]: parameter["default"] for parameter in definition["parameters"]}
        setattr(kinds, name, name in wanted)
        set_parameters(kinds, name, defaults | wanted.get(name, {}))


def set_parameters(kinds, name, values):
    """Sets parameters of the named definition; values in the registry's units."""
    units = {p["name"]: p["unit"] for d in definitions() if d["name"] == name for p in d["parameters"]}
    for parameter, value in values.items():
        setattr(kinds, f"{name}_{parameter}", _stored(value, units[parameter]))


def _values(kinds, definition):
    return {parameter["name"]: value_of(kinds, definition, parameter) for parameter in definition["parameters"]}


def value_of(settings, definition, parameter):
    """A parameter of a definition in the registry's unit, as a group's property of it has it."""
    value = float(getattr(settings, property_name(definition, parameter)))
    return neat(math.degrees(value) if parameter["unit"] == "degrees" else value)


def property_name(definition, parameter):
    return f"{definition['name']}_{parameter['name']}"


def _stored(value, unit):
    """A parameter's value as its property keeps it."""
    if unit == "bool":
        return bool(value)
    return math.radians(value) if unit == "degrees" else value


def parameter_property(parameter, name=""):
    """A property for a parameter, called as in the registry where it has no other name."""
    words = name or parameter["label"], parameter["meaning"]
    if parameter["unit"] == "bool":
        return switch(*words, default=bool(parameter["default"]))
    low, default, high = (_stored(parameter[key], parameter["unit"]) for key in ("min", "default", "max"))
    options = {"default": default, "min": low, "max": high}
    if parameter["unit"] == "degrees":
        return number(*words, subtype="ANGLE", **options)
    if parameter["name"] == "count":
        return number(*words, precision=0, step=100, **options)
    if (low, high) == (0, 1):
        return number(*words, subtype="FACTOR", **options)
    # Limits are far out, for models of all kinds; what a hand wants is near the default.
    fine = {"precision": 4, "step": 0.1} if 0 < default < 0.1 else {}
    soft = {"soft_max": min(high, SLIDE * default)} if default > 0 else {}
    return number(*words, **fine, **soft, **options)


def group():
    """The PropertyGroup, by the registry."""
    found = {}
    for definition in definitions():
        name = definition["name"]
        found[name] = switch(definition["label"], f"{definition['description']}.\n{definition['source']}")
        for parameter in definition["parameters"]:
            found[property_name(definition, parameter)] = parameter_property(parameter)
    return new_group("FoveaLineKinds", "Kinds of lines and their parameters.", found)
