# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties that several groups of settings have, and numbers as they come back from them."""

import zlib

from bpy.props import StringProperty

MOST_LETTERS = 63  # of the name of an attribute, in Blender


def redraw(settings, _context):
    # Properties of add-ons do not tag what they belong to.
    settings.id_data.update_tag()


def file_names(stems):
    """Items of an enum over file names, numbered by name so that saved files survive new ones."""
    return [(n, n.replace("_", " ").title(), "", "NONE", zlib.crc32(n.encode()) & 0x7FFFFFFF) for n in stems]


def attribute_name(name, description, default=""):
    return StringProperty(name=name, description=description, default=default, maxlen=MOST_LETTERS, update=redraw)


def neat(value):
    """The short number that a property, of single precision, was set to."""
    return float(f"{value:.7g}")
