# SPDX-License-Identifier: GPL-3.0-or-later
"""Enables those of Blender's panels that apply to this engine."""

import bpy

from .common import ENGINE
from .simplify import PANELS as SIMPLIFY

# Blender's panels declare their engines in COMPAT_ENGINES; those in ALSO are enabled without BLENDER_RENDER in it.
ALSO = {"EEVEE_MATERIAL_PT_context_material", "EEVEE_MATERIAL_PT_surface"}
NOT = {"RENDER_PT_freestyle", "RENDER_PT_gpencil", "VIEWLAYER_PT_filter", *SIMPLIFY}


def _blender_panels():
    """Yields Blender's panels to enable for this engine: those that declare BLENDER_RENDER except NOT, and ALSO."""
    for panel in bpy.types.Panel.__subclasses__():
        engines = getattr(panel, "COMPAT_ENGINES", ())
        if panel.__name__ in ALSO or ("BLENDER_RENDER" in engines and panel.__name__ not in NOT):
            yield panel


def register():
    for panel in _blender_panels():
        panel.COMPAT_ENGINES.add(ENGINE)


def unregister():
    for panel in _blender_panels():
        panel.COMPAT_ENGINES.discard(ENGINE)
