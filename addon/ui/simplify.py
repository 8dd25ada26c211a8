# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's panel Simplify and its subpanels, below those of Fovea: Blender's own stand above whatever add-ons add."""

import bpy

from .common import ENGINE

PANELS = tuple(f"RENDER_PT_simplify{part}" for part in ("", "_viewport", "_render", "_greasepencil"))
OWN = {"COMPAT_ENGINES", "bl_parent_id", "bl_rna", "__dict__", "__weakref__"}  # members that are not Blender's panel's

_registered = []


def _own(name):
    """A class with the contents of one of Blender's panels, for this engine alone."""
    panel, parent = getattr(bpy.types, name), PANELS[0]
    contents = {key: value for key, value in vars(panel).items() if key not in OWN} | {"COMPAT_ENGINES": {ENGINE}}
    if name != parent:
        contents["bl_parent_id"] = _renamed(parent)
    return type(_renamed(name), panel.__bases__, contents)


def _renamed(name):
    return name.replace("RENDER_PT_", "RENDER_PT_fovea_")


def register():
    for name in PANELS:
        _registered.append(_own(name))
        bpy.utils.register_class(_registered[-1])


def unregister():
    while _registered:
        bpy.utils.unregister_class(_registered.pop())
