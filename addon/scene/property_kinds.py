# SPDX-License-Identifier: GPL-3.0-or-later
"""Helpers to declare Blender properties and property groups.

`switch`, `number` and so on wrap the functions of bpy.props: they take a name, a description and the function's
keywords, and by default redraw on a change. Library overrides of their owners may change them, `part` and `members`
included.
"""

import zlib

import bpy
from bpy import props

OVERRIDABLE = {"override": {"LIBRARY_OVERRIDABLE"}}
SHARE = {"subtype": "FACTOR", "min": 0.0, "max": 1.0}


def redraw(settings, _context):
    # Blender does not tag the owner of an add-on's property for an update.
    settings.id_data.update_tag()


def _redrawn(made):
    always = {"update": redraw, **OVERRIDABLE}
    return lambda name, description, **words: made(name=name, description=description, **always | words)


def part(group):
    """A property that holds the properties of a group."""
    return props.PointerProperty(type=group, **OVERRIDABLE)


def members(group, **words):
    """A property that holds any number of groups."""
    return props.CollectionProperty(type=group, override={"LIBRARY_OVERRIDABLE", "USE_INSERTION"}, **words)


switch, whole_number, number = map(_redrawn, (props.BoolProperty, props.IntProperty, props.FloatProperty))
choice, text, pointer = map(_redrawn, (props.EnumProperty, props.StringProperty, props.PointerProperty))
vector = _redrawn(props.FloatVectorProperty)


def file_path(name, description):
    """A property that holds the path of a file, which may be relative to the .blend file."""
    relative = {"options": {"PATH_SUPPORTS_BLEND_RELATIVE"}} if bpy.app.version >= (5, 0, 0) else {}
    return text(name, description, subtype="FILE_PATH", **relative)


def new_group(name, told, annotations, **others):
    """A new subclass of PropertyGroup. `told`: its docstring; `others`: further attributes."""
    contents = {"__annotations__": annotations, "__module__": __name__, "__doc__": told, **others}
    return type(name, (bpy.types.PropertyGroup,), contents)


def file_names(stems):
    """Enum items for file names. Their numbers are hashes of the names, so that saved .blend files stay valid when
    files are added."""
    return [(n, n.replace("_", " ").title(), "", "NONE", zlib.crc32(n.encode()) & 0x7FFFFFFF) for n in stems]


def neat(value):
    """A single-precision value rounded to 7 digits, to recover the decimal number it was set to."""
    return float(f"{value:.7g}")
