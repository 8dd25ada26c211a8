# SPDX-License-Identifier: GPL-3.0-or-later
"""The PropertyGroups that store a style in a node tree: one per record of the core, generated from the declarations of
the records' members (native/fovea/style).

A member added to a record becomes a property here, with its label, range and unit. An optional part of a style (a
defocus pen, a background) has an extra switch. Without the native module there are no such groups.
"""

import math

import bpy
from bpy.props import IntProperty, StringProperty

from .. import native, style
from ..scene import line_kinds
from ..scene.property_kinds import (
    OVERRIDABLE,
    choice,
    file_names,
    members,
    new_group,
    number,
    pointer,
    switch,
    text,
    vector,
    whole_number,
)
from ..scene.property_kinds import part as part_of

PLAIN = ("switch", "number", "whole number", "choice", "text", "color")  # types of members that map to one property
ELSEWHERE = ("name", "first")  # members whose properties are declared separately
UNITS = {  # unit of a member -> keywords of its property
    "": {"step": 10},
    "share": {"subtype": "FACTOR"},
    "reference pixels": {"subtype": "PIXEL"},
    "scene": {"subtype": "DISTANCE"},
    "millimeters": {"subtype": "DISTANCE_CAMERA"},
    "light": {"subtype": "COLOR"},
    "seed": {"precision": 0, "step": 100},
}
FILES = {"texture": style.textures, "paper": style.papers}
AWAY = ("Pen out of Focus", "Lines out of focus are drawn with a pen of their own")

_groups = {}  # record class of the core -> its registered PropertyGroup
_registered = []  # registered groups, in order


def part(cls):
    """Name of the property that stores a record, also the prefix of the names of its effects' curve nodes."""
    return cls.__name__.lower()


def plain_fields(cls):
    """Declarations of the members of a record that map to one property each and are not optional."""
    fields = (f for f in cls.fields if f["type"] in PLAIN and f["default"] is not None)
    return [f for f in fields if f["name"] not in ELSEWHERE]


def transfers(cls):
    """{name: declaration} of the members of a record that are transfer functions."""
    return {f["name"]: f for f in cls.fields if f["type"] == "transfer"}


def grouped(cls):
    """{declared group: names of a record's plain members in it}, in order. Where a group does not begin with a choice,
    choices come right after its first member, as they are its unit or what it is anchored to."""
    groups = {}
    for field in plain_fields(cls):
        groups.setdefault(field["group"], []).append(field)
    for fields in groups.values():
        if fields[0]["type"] != "choice":
            fields[1:] = sorted(fields[1:], key=lambda f: f["type"] != "choice")
    return {group: [f["name"] for f in fields] for group, fields in groups.items()}


def _property(field):
    """The Blender property for a member's declaration."""
    default, kind = field["default"], field["type"]
    measured = ", in pixels of an image 1080 pixels high" if field["unit"] == "reference pixels" else ""
    words = field["label"], field["description"] + measured
    limits = {"min": field["min"], "max": field["max"], "soft_max": field["soft_max"]}
    if kind == "switch":
        return switch(*words, default=default)
    if field["names"] in FILES:
        return choice(*words, items=file_names(FILES[field["names"]]()), default=default)
    if kind == "choice":
        items = [(name.upper(), label, told) for name, label, told in field["choices"]]
        return choice(*words, items=items, default=default.upper())
    if kind == "text":
        return text(*words, default=default, maxlen=field["most_letters"])
    if kind == "color":
        return vector(*words, default=default, size=3, **limits, **UNITS[field["unit"]])
    if kind == "whole number":
        return whole_number(*words, default=default, **{key: int(value) for key, value in limits.items()})
    if field["unit"] == "degrees":
        most = math.radians(limits["max"])
        return number(*words, default=math.radians(default), subtype="ANGLE", min=0.0, max=most)
    return number(*words, default=default, **limits, **UNITS[field["unit"]])


def _plain(cls):
    return {field["name"]: _property(field) for field in plain_fields(cls)}


def _optional(cls, name, default):
    """The property for an optional member; `default`: its value while the member is unset."""
    return _property(style.field(cls, name) | {"default": default})


def _pens():
    pen = part_of(_groups[style.Pen])
    return {"pen": pen, "away": switch(*AWAY), "pen_away": pen}


def _color():
    on_paper = switch(
        "Use Paper as Background", "Where there is nothing, and where colors fade, the paper shows", default=True
    )
    return {"on_paper": on_paper, "background": _optional(style.Color, "background", (1.0, 1.0, 1.0))}


def _elision():
    told = "Image over the frame: lines are four times as dense where it is white, a quarter as dense where black"
    return {"density_image": pointer("Density Map", told, type=bpy.types.Image)}


def _hidden():
    first = style.field(style.Hidden, "first")
    last = style.field(style.Hidden, "last") | {"default": 0, "min": 0, "type": "whole number"}
    return {**_pens(), "first": _property(first), "last": _property(last)}


def _line_set(kinds):
    return {
        "name": text(
            "Name", "Of the line set and, as letters of files allow, of its pass"
        ),  # redraws, Blender's does not
        **_pens(),
        "kinds": part_of(kinds),
        "overshoot_away": _optional(style.LineSet, "overshoot_away", 0.0),
        "hidden": members(_groups[style.Hidden]),
        "hidden_index": IntProperty(name="Hidden Pen", description="The hidden pen that is edited", min=0),
        "kept": StringProperty(options={"HIDDEN"}),
    }


def _style():
    parts = (style.Paper, style.Color, style.Section, style.Elision, style.Animation, style.Effects, style.Distance)
    return {
        **{part(cls): part_of(_groups[cls]) for cls in parts},
        "line_sets": members(_groups[style.LineSet]),
        "line_set_index": IntProperty(name="Line Set", description="The line set that is edited", min=0),
        "effect_index": IntProperty(name="Effect", description="The node of the effect that is edited", min=0),
    }


def _add(made):
    bpy.utils.register_class(made)
    _registered.append(made)
    return made


def _add_part(cls, name, more=None):
    transfer = {name: part_of(_groups[style.Transfer]) for name in transfers(cls)}
    _groups[cls] = _add(new_group(name, cls.__doc__, _plain(cls) | transfer | (more or {})))


def _add_parts():
    _add_part(style.Transfer, "FoveaTransfer")
    curves = StringProperty(options={"HIDDEN"}, **OVERRIDABLE)  # part of the names of its curves' nodes
    _add_part(style.Pen, "FoveaPen", {"curves": curves})
    _add_part(style.Hidden, "FoveaHiddenPen", _hidden())
    _add_part(style.LineSet, "FoveaLineSet", _line_set(_add(line_kinds.group())))
    _add_part(style.Paper, "FoveaPaper")
    _add_part(style.Color, "FoveaColor", _color())
    _add_part(style.Section, "FoveaSection")
    _add_part(style.Elision, "FoveaElision", _elision())
    _add_part(style.Animation, "FoveaAnimation")
    _add_part(style.Effects, "FoveaEffects")
    _add_part(style.Distance, "FoveaDistance")


def register():
    """Registers the groups and adds `fovea` to all node trees; `schema` is 0 in trees that are not styles."""
    held = {
        "schema": IntProperty(options={"HIDDEN"}),
        "untouched": StringProperty(options={"HIDDEN"}),
        "source": StringProperty(options={"HIDDEN"}),  # name of the bundled or saved style that it came from
        "brought": StringProperty(options={"HIDDEN"}),  # the .blend file and the name that it was appended from
        "kept": StringProperty(options={"HIDDEN"}),
    }
    if not native.problem():
        _add_parts()
        held |= _style()
    bpy.types.NodeTree.fovea = part_of(_add(new_group("FoveaStyle", "A style.", held)))


def unregister():
    del bpy.types.NodeTree.fovea
    for group in reversed(_registered):
        bpy.utils.unregister_class(group)
    _registered.clear()
    _groups.clear()
