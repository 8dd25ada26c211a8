"""Properties that several groups of settings have: colours, numbers of a style, and names of files."""

import zlib

from bpy.props import FloatProperty, FloatVectorProperty, StringProperty

from ..style_values import MOST_ATTRIBUTE, RANGES


def redraw(settings, _context):
    # Properties of add-ons do not tag what they belong to.
    settings.id_data.update_tag()


def file_names(stems):
    """Items of an enum over file names, numbered by name so that saved files survive new ones."""
    return [(n, n.replace("_", " ").title(), "", "NONE", zlib.crc32(n.encode()) & 0x7FFFFFFF) for n in stems]


def number(name, field, default, description):
    low, high = RANGES[field]
    return FloatProperty(name=name, default=default, min=low, max=high, description=description, update=redraw)


def attribute_name(name, description, default=""):
    return StringProperty(name=name, description=description, default=default, maxlen=MOST_ATTRIBUTE, update=redraw)


def color(name, default, description):
    return FloatVectorProperty(
        name=name, subtype="COLOR", size=3, min=0.0, max=1.0, default=default, description=description, update=redraw
    )
