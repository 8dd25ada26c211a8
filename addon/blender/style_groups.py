# SPDX-License-Identifier: GPL-3.0-or-later
"""The PropertyGroups that hold a style, in a node tree: one for each of its dataclasses, made from their fields.

A number, word or switch that is added to a dataclass is a property here; style_words.py says how the panels tell it.
What may be missing in a style (a pen out of focus, a background) has a switch beside it.
"""

import math
from dataclasses import MISSING, fields

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from .. import style
from ..color import Color
from ..elision import Elision
from ..focus import MOST_NAME, Distance, Effects, Transfer
from ..stages import Pen
from ..style_parts import FILTERS, Hidden, LineSet, Paper
from ..style_values import MOST_ATTRIBUTE
from . import line_kinds, style_words
from .property_kinds import file_names, redraw

PARTS = {  # dataclass: what the words call it
    Transfer: "transfer",
    Pen: "pen",
    Hidden: "hidden",
    LineSet: "line_set",
    Paper: "paper",
    Color: "color",
    Elision: "elision",
    Effects: "effects",
    Distance: "distance",
}
FILES = {"pen.texture": style.textures, "paper.texture": style.papers}
NAMES = tuple(f"line_set.{name}" for name in FILTERS)  # of Blender's datablocks
AWAY = ("Pen out of Focus", "Lines out of focus are drawn with a pen of their own")

_groups = {}  # dataclass: its group, once they are registered
_registered = []  # groups, in order


def plain_fields(cls):
    """(name, default) of the fields of a dataclass that are numbers, words, switches or colours."""
    for f in fields(cls):
        if f.default is not MISSING and f.default is not None and f.name not in ("name", "hidden", "curve"):
            if not isinstance(f.default, (Pen, Transfer)) and not (cls is Hidden and f.name == "first"):
                yield f.name, f.default


def transfers(cls):
    """Names of the fields of a dataclass that are transfer functions."""
    return [f.name for f in fields(cls) if isinstance(f.default, Transfer)]


def _property(part, name, default):
    """The property for a field."""
    label, told, options = style_words.of(part, name)
    text = {"name": label, "description": told, "update": redraw}
    key = f"{part}.{name}"
    if isinstance(default, bool):
        return BoolProperty(default=default, **text)
    if key in FILES:
        return EnumProperty(items=file_names(FILES[key]()), default=default, **text)
    if key in style_words.CHOICES:
        return EnumProperty(items=style_words.CHOICES[key], default=default.upper(), **text)
    if isinstance(default, str):
        return StringProperty(default=default, maxlen=MOST_NAME if key in NAMES else MOST_ATTRIBUTE, **text)
    if isinstance(default, tuple):
        return FloatVectorProperty(default=default, **options, **text)
    if isinstance(default, int):
        return IntProperty(default=default, **options, **text)
    if options.get("subtype") == "ANGLE":
        return FloatProperty(default=math.radians(default), subtype="ANGLE", min=0.0, max=math.pi, **text)
    return FloatProperty(default=default, **options, **text)


def _plain(cls):
    return {name: _property(PARTS[cls], name, default) for name, default in plain_fields(cls)}


def _transfers(cls):
    return {name: PointerProperty(type=_groups[Transfer]) for name in transfers(cls)}


def _pens():
    pen, (label, told) = _groups[Pen], AWAY
    return {
        "pen": PointerProperty(type=pen),
        "away": BoolProperty(name=label, description=told, update=redraw),
        "pen_away": PointerProperty(type=pen),
    }


def _color():
    label, told = "On Paper", "Where there is nothing, and where colors fade, the paper shows"
    background = FloatVectorProperty(
        name="Background",
        description="Color behind everything, towards which colors fade",
        subtype="COLOR",
        size=3,
        min=0.0,
        soft_max=1.0,
        max=1000.0,
        default=(1.0, 1.0, 1.0),
        update=redraw,
    )
    on_paper = BoolProperty(name=label, description=told, default=True, update=redraw)
    return {"on_paper": on_paper, "background": background}


def _elision():
    told = "Image over the frame: lines are four times as dense where it is white, a quarter as dense where black"
    image = PointerProperty(type=bpy.types.Image, name="Density Map", description=told, update=redraw)
    return {"density_image": image}


def _surfaces(name, default, least):
    label, told, _ = style_words.of("hidden", name)
    limits = {"min": least, "max": style.MOST_SURFACES, "soft_max": 8}
    return IntProperty(name=label, description=told, default=default, update=redraw, **limits)


def _hidden():
    return {**_pens(), "first": _surfaces("first", 1, 1), "last": _surfaces("last", 0, 0)}


def _line_set(kinds):
    return {
        **_pens(),
        "kinds": PointerProperty(type=kinds),
        "overshoot_away": _property("line_set", "overshoot_away", 0.0),
        "hidden": CollectionProperty(type=_groups[Hidden]),
        "hidden_index": IntProperty(name="Hidden Pen", description="The hidden pen that is edited", min=0),
        "kept": StringProperty(options={"HIDDEN"}),
    }


def _style():
    parts = {PARTS[cls]: PointerProperty(type=_groups[cls]) for cls in (Paper, Color, Elision, Effects, Distance)}
    return {
        "schema": IntProperty(options={"HIDDEN"}),
        "untouched": StringProperty(options={"HIDDEN"}),
        "source": StringProperty(options={"HIDDEN"}),  # its file name, now or once, among those that ship or are saved
        "brought": StringProperty(options={"HIDDEN"}),  # the .blend file and the name that it was appended from
        "kept": StringProperty(options={"HIDDEN"}),
        **parts,
        "line_sets": CollectionProperty(type=_groups[LineSet]),
        "line_set_index": IntProperty(name="Line Set", description="The line set that is edited", min=0),
    }


def _add(name, told, annotations):
    contents = {"__annotations__": annotations, "__module__": __name__, "__doc__": told}
    made = type(name, (bpy.types.PropertyGroup,), contents)
    bpy.utils.register_class(made)
    _registered.append(made)
    return made


def register():
    """Puts a style in every node tree; `schema` is 0 where there is none."""
    _groups[Transfer] = _add("FoveaTransfer", "A transfer function without its curve.", _plain(Transfer))
    _groups[Pen] = _add("FoveaPen", "How strokes look.", _plain(Pen))
    _groups[Hidden] = _add("FoveaHiddenPen", "How what surfaces hide is drawn.", _hidden())
    kinds = line_kinds.group()
    bpy.utils.register_class(kinds)
    _registered.append(kinds)
    _groups[LineSet] = _add("FoveaLineSet", "Lines drawn alike.", _plain(LineSet) | _line_set(kinds))
    _groups[Paper] = _add("FoveaPaper", "The paper.", _plain(Paper))
    _groups[Color] = _add("FoveaColor", "The colours under the lines.", _plain(Color) | _color())
    _groups[Elision] = _add("FoveaElision", "Which of crowding lines stay.", _plain(Elision) | _elision())
    for cls, told in ((Effects, "What answers to focus."), (Distance, "What answers to distance.")):
        _groups[cls] = _add(f"Fovea{cls.__name__}", told, _plain(cls) | _transfers(cls))
    bpy.types.NodeTree.fovea = PointerProperty(type=_add("FoveaStyle", "A style.", _style()))


def unregister():
    del bpy.types.NodeTree.fovea
    for group in reversed(_registered):
        bpy.utils.unregister_class(group)
    _registered.clear()
    _groups.clear()
