"""The render engine: Blender's callbacks, each one call into the session."""

import bpy

from . import preferences, session


class FoveaEngine(bpy.types.RenderEngine):
    bl_idname = "FOVEA"
    bl_label = "Fovea"
    bl_use_preview = False
    bl_use_eevee_viewport = True  # the material preview is EEVEE's
    bl_use_shading_nodes_custom = False

    drawing = None  # of this viewport, made when first drawn

    def update_render_passes(self, scene=None, renderlayer=None):
        session.register_passes(self, scene, renderlayer)

    def render(self, depsgraph):
        session.render(self, depsgraph)

    def view_update(self, context, depsgraph):
        session.view_update(self)

    def view_draw(self, context, depsgraph):
        session.view_draw(self, context, depsgraph)


def register():
    # Read when the class is registered, and only then.
    FoveaEngine.bl_use_gpu_context = preferences.gl_renderer() is not None
    bpy.utils.register_class(FoveaEngine)
    session.register()


def unregister():
    session.unregister()
    bpy.utils.unregister_class(FoveaEngine)
