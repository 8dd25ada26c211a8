# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties of what is drawn, groups of them, and numbers as they come back from them.

`switch`, `number` and so on are Blender's functions with a name, a description and their keywords; what changes is drawn
anew.
"""

import zlib

import bpy
from bpy import props

SHARE = {"subtype": "FACTOR", "min": 0.0, "max": 1.0}


def redraw(settings, _context):
    # Properties of add-ons do not tag what they belong to.
    settings.id_data.update_tag()


def _redrawn(made):
    return lambda name, description, **words: made(name=name, description=description, **{"update": redraw} | words)


switch, whole_number, number = map(_redrawn, (props.BoolProperty, props.IntProperty, props.FloatProperty))
choice, text, pointer = map(_redrawn, (props.EnumProperty, props.StringProperty, props.PointerProperty))
vector = _redrawn(props.FloatVectorProperty)


def new_group(name, told, annotations, **others):
    """A new class of PropertyGroups; `others`: more of its attributes."""
    contents = {"__annotations__": annotations, "__module__": __name__, "__doc__": told, **others}
    return type(name, (bpy.types.PropertyGroup,), contents)


def file_names(stems):
    """Items of an enum over file names, numbered by name so that saved files survive new ones."""
    return [(n, n.replace("_", " ").title(), "", "NONE", zlib.crc32(n.encode()) & 0x7FFFFFFF) for n in stems]


def neat(value):
    """The short number that a property, of single precision, was set to."""
    return float(f"{value:.7g}")
