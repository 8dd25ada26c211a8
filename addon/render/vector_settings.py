# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender properties of the core's options of drawings in files, made of their declarations (native/fovea/vector and
color/screentone.h). There are none without the native module."""

from bpy.props import BoolProperty, EnumProperty, FloatProperty, StringProperty

from .. import native
from ..scene.property_kinds import OVERRIDABLE, new_group, part

# Of VectorOptions.
VECTORS = ("sheet", "margin", "to_scale", "tolerance", "widths", "ground", "colors", "plotter", "title_block")
SCREEN = ("dpi", "lines_per_inch", "angle", "threshold")  # of Screen
RASTER = (  # kinds of files besides the core's VECTORS: (name, label, description)
    ("ora", "OpenRaster", "For programs that paint: paper, colors and the lines of each set on layers"),
    ("png", "PNG of 1 Bit", "For comics: lines in black and white, tones as a screen of dots"),
)
OFF = ("NONE", "None", "Pictures alone")
UNITS = {"millimeters": " [mm]", "degrees": " [degrees]"}


def annotations(record, names, **words):
    """{name: property} of members of a record of the core, which is given by its name. `words`: of all of them."""
    by_name = {field["name"]: field for field in _declared(record)}
    return {name: _property(by_name[name], words) for name in names if name in by_name}


def kinds():
    """(name, label, description) of each kind of file; the name is its suffix, too."""
    return [] if native.problem() else [*native.load().VECTORS, *RASTER]


def title_fields():
    """Names of what a title block says, in the order in which panels have them."""
    return tuple(field["name"] for field in _declared("Titles"))


def titles_group():
    """The PropertyGroup of what a scene's title blocks say."""
    own = annotations("Titles", title_fields(), **OVERRIDABLE)
    return new_group("FoveaTitles", "What title blocks say.", own)


def group(titles):
    """The PropertyGroup of a scene's settings of files with every render, which have the pixels of the picture.
    `titles`: the group of its title blocks."""
    items = [OFF, *((name.upper(), label, told) for name, label, told in kinds() if name != "png")]
    told = "What every render writes beside its picture"
    kind = EnumProperty(name="With Every Render", description=told, items=items, **OVERRIDABLE)
    own = annotations("VectorOptions", VECTORS, **OVERRIDABLE)
    return new_group("FoveaVectorSettings", "Files beside pictures.", {"kind": kind, **own, "titles": part(titles)})


def values(owner, names):
    """{name: value} of an owner's properties."""
    return {name: getattr(owner, name) for name in names}


def _declared(record):
    """Declarations of the members of a record of the core."""
    return () if native.problem() else getattr(native.load(), record).fields


def _property(field, words):
    told = {"name": field["label"], "description": field["description"] + UNITS.get(field["unit"], "")}
    told |= {"default": field["default"], **words}
    if field["type"] == "switch":
        return BoolProperty(**told)
    if field["type"] == "text":
        return StringProperty(**told)
    if field["type"] == "choice":
        return EnumProperty(items=field["choices"], **told)
    limits = {"min": field["min"], "max": field["max"], "soft_max": field["soft_max"]}
    return FloatProperty(precision=3 if field["max"] < 100 else 1, **limits, **told)
