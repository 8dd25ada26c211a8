# SPDX-License-Identifier: GPL-3.0-or-later
"""The kinds of lines of a line set, as Blender properties generated from the native registry.

Each line definition has a switch of its name, and its parameters are `<definition>_<parameter>`, its file, too. Angles
are stored in radians, as Blender's angle properties expect.
"""

import math

import bpy

from .. import catalogue, native
from .property_kinds import file_path, neat, new_group, number, switch

SLIDE = 20  # soft maximum of a parameter, in multiples of its default


def definitions():
    """The line definitions; () without the native module, so that files still keep their other settings."""
    try:
        return catalogue.definitions()
    except native.Unavailable:
        return ()


def read(kinds):
    """{definition: {parameter: value in the registry's unit}} of the kinds that are switched on."""
    return {d["name"]: _values(kinds, d) for d in definitions() if getattr(kinds, d["name"])}


def write(kinds, wanted):
    """Switches on exactly the kinds in `wanted` (as of `read`); parameters not given get the registry's defaults."""
    for definition in definitions():
        name = definition["name"]
        defaults = {parameter["name"]: parameter["default"] for parameter in definition["parameters"]}
        defaults |= {definition["file"]["name"]: ""} if definition["file"] else {}
        setattr(kinds, name, name in wanted)
        set_parameters(kinds, name, defaults | wanted.get(name, {}))


def set_parameters(kinds, name, values):
    """Sets parameters of the named definition; values in the registry's units."""
    units = {p["name"]: p["unit"] for d in definitions() if d["name"] == name for p in d["parameters"]}
    for parameter, value in values.items():
        setattr(kinds, f"{name}_{parameter}", _stored(value, units.get(parameter, "")))


def _values(kinds, definition):
    values = {parameter["name"]: value_of(kinds, definition, parameter) for parameter in definition["parameters"]}
    file = definition["file"]
    path = getattr(kinds, property_name(definition, file)) if file else ""
    return values | {file["name"]: bpy.path.abspath(path, library=kinds.id_data.library)} if path else values


def value_of(settings, definition, parameter):
    """Value of a definition's parameter in a property group, in the registry's unit."""
    value = float(getattr(settings, property_name(definition, parameter)))
    return neat(math.degrees(value) if parameter["unit"] == "degrees" else value)


def property_name(definition, parameter):
    return f"{definition['name']}_{parameter['name']}"


def _stored(value, unit):
    """A parameter's value as its property stores it: bool, radians for degrees, else unchanged."""
    if unit == "bool":
        return bool(value)
    return math.radians(value) if unit == "degrees" else value


def parameter_property(parameter, name=""):
    """A Blender property for a registry parameter; `name`: its label, "": the registry's."""
    words = name or parameter["label"], parameter["meaning"]
    if parameter["unit"] == "bool":
        return switch(*words, default=bool(parameter["default"]))
    low, default, high = (_stored(parameter[key], parameter["unit"]) for key in ("min", "default", "max"))
    options = {"default": default, "min": low, "max": high}
    if parameter["unit"] == "degrees":
        return number(*words, subtype="ANGLE", **options)
    if parameter["unit"] == "millimeters":
        return number(*words, subtype="DISTANCE_CAMERA", **options, soft_max=min(high, SLIDE * default))
    if parameter["name"] == "count":
        return number(*words, precision=0, step=100, **options)
    if (low, high) == (0, 1):
        return number(*words, subtype="FACTOR", **options)
    # Hard limits are wide, to suit models of all kinds; the soft range for dragging is near the default.
    fine = {"precision": 4, "step": 0.1} if 0 < default < 0.1 else {}
    soft = {"soft_max": min(high, SLIDE * default)} if default > 0 else {}
    return number(*words, **fine, **soft, **options)


def group():
    """The PropertyGroup class generated from the registry."""
    found = {}
    for definition in definitions():
        name = definition["name"]
        found[name] = switch(definition["label"], definition["description"])
        for parameter in definition["parameters"]:
            found[property_name(definition, parameter)] = parameter_property(parameter)
        if file := definition["file"]:
            found[property_name(definition, file)] = file_path(file["label"], file["meaning"])
    return new_group("FoveaLineKinds", "Kinds of lines and their parameters.", found)
