# SPDX-License-Identifier: GPL-3.0-or-later
"""Grease Pencil as Blender has it from 4.3 on. What 4.2 has by that name is other data, which Fovea does not make."""

import bpy

from .problem import CannotDraw


def are_there():
    return bpy.app.version >= (4, 3, 0)


def need(remedy):
    """CannotDraw where this Blender is too old. `remedy`: what to do instead."""
    if not are_there():
        raise CannotDraw(f"The Grease Pencil that Fovea knows is there from Blender 4.3 on: {remedy}")


def kept():
    """The collection of all Grease Pencil data in bpy.data."""
    need("take a newer Blender")
    return bpy.data.grease_pencils_v3 if hasattr(bpy.data, "grease_pencils_v3") else bpy.data.grease_pencils
