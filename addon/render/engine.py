# SPDX-License-Identifier: GPL-3.0-or-later
"""The render engine: Blender's callbacks, each one call into the session or a viewport."""

import bpy

from . import as_rendered, gpu_context, session, viewport


class FoveaEngine(bpy.types.RenderEngine):
    bl_idname = "FOVEA"
    bl_label = "Fovea"
    bl_use_preview = False
    bl_use_eevee_viewport = True  # the material preview is EEVEE's
    bl_use_shading_nodes_custom = False

    backend = None  # made when first needed
    viewport = None  # what is kept for the viewport that this draws

    def update_render_passes(self, scene=None, renderlayer=None):
        session.register_passes(self, scene, renderlayer)

    def render(self, depsgraph):
        if not as_rendered.looked(self, depsgraph):
            session.render(self, depsgraph)

    def view_update(self, context, depsgraph):
        viewport.update(self, depsgraph)

    def view_draw(self, context, depsgraph):
        viewport.draw(self, context, depsgraph)


def register():
    gpu_context.register(FoveaEngine)
    session.register()
    viewport.register()


def unregister():
    viewport.unregister()
    session.unregister()
    gpu_context.unregister()
