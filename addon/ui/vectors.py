# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel: vectors or layers with every render."""

import bpy

from ..render import vector_settings
from .common import FoveaPanel, draw_properties


class RENDER_PT_fovea_vectors(FoveaPanel, bpy.types.Panel):
    bl_label = "Vectors"
    bl_options = {"DEFAULT_CLOSED"}

    def show(self, layout, context):
        settings = context.scene.fovea.vectors
        layout.prop(settings, "kind")
        heeded = settings.kind not in {vector_settings.OFF[0], "ORA"}
        draw_properties(layout, settings, vector_settings.VECTORS, heeded)
        if getattr(settings, "title_block", False):  # not there without the native module
            draw_properties(layout, settings.titles, vector_settings.title_fields(), heeded)
