# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's panel Simplify and its subpanels, below those of Fovea: Blender's own stand above whatever add-ons add."""

import bpy

from .common import ENGINE, copied

PANELS = tuple(f"RENDER_PT_simplify{part}" for part in ("", "_viewport", "_render", "_greasepencil"))

_registered = []


def _own(name):
    """A class with the contents of one of Blender's panels, for this engine alone."""
    below = {} if name == PANELS[0] else {"bl_parent_id": _renamed(PANELS[0])}
    return copied(getattr(bpy.types, name), _renamed(name), COMPAT_ENGINES={ENGINE}, **below)


def _renamed(name):
    return name.replace("RENDER_PT_", "RENDER_PT_fovea_")


def register():
    for name in PANELS:
        _registered.append(_own(name))
        bpy.utils.register_class(_registered[-1])


def unregister():
    while _registered:
        bpy.utils.unregister_class(_registered.pop())
