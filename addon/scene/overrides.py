# SPDX-License-Identifier: GPL-3.0-or-later
"""Library overrides of the extension's settings.

Blender stores of an override which properties differ from those of the library, by their paths. A group of properties
that was never used in the library does not exist there: then it stores that the whole group differs, and loses it when
the file is opened. So the groups of the linked datablocks, which are made when they are first asked for, are made
before a file is saved.
"""

import bpy
from bpy.app.handlers import persistent

OWNERS = ("scenes", "objects", "collections", "materials", "node_groups")  # what has settings


@persistent
def make_groups(*_):
    """Makes all groups of settings of the linked datablocks that have overrides."""
    for name in OWNERS:
        for owner in getattr(bpy.data, name):
            if owner.override_library and owner.override_library.reference:
                _visit(owner.override_library.reference.fovea)


def _visit(group):
    for declared in group.bl_rna.properties:
        if declared.type == "POINTER" and declared.identifier != "rna_type":
            within = getattr(group, declared.identifier)
            if isinstance(within, bpy.types.PropertyGroup):
                _visit(within)


def register():
    bpy.app.handlers.save_pre.append(make_groups)


def unregister():
    bpy.app.handlers.save_pre.remove(make_groups)
