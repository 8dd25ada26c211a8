# SPDX-License-Identifier: GPL-3.0-or-later
"""The render engine: Blender's callbacks, which forward to session.py and viewport.py."""

from functools import partial

import bpy
from bpy.app.handlers import persistent

from . import as_rendered, beside_renders, gpu_context, session, viewport, write_flag


class FoveaEngine(bpy.types.RenderEngine):
    bl_idname = "FOVEA"
    bl_label = "Fovea"
    bl_use_preview = False
    bl_use_eevee_viewport = True  # the material preview is EEVEE's
    bl_use_shading_nodes_custom = False

    backend = None  # created on first use
    note = ""  # why it is not the GPU that draws, if that was tried
    viewport = None  # viewport.Viewport, the state of the viewport that this engine draws

    def update_render_passes(self, scene=None, renderlayer=None):
        with write_flag.callback():
            session.register_passes(self, scene, renderlayer)

    def render(self, depsgraph):
        with write_flag.callback():
            if as_rendered.looked(self, depsgraph):
                return
            for view in self._views(depsgraph.view_layer):
                self.active_view_set(view)
                session.render(self, depsgraph, also=partial(beside_renders.write, self, depsgraph))

    def _views(self, layer):
        """Names of what Blender wants of a view layer: both eyes of a stereo pair, views, or an empty name alone."""
        result = self.begin_result(0, 0, 1, 1, layer=layer.name)
        names = [view.name for view in result.views]
        self.end_result(result, cancel=True)
        return names

    def view_update(self, context, depsgraph):
        viewport.update(self, depsgraph)

    def view_draw(self, context, depsgraph):
        viewport.draw(self, context, depsgraph)


@persistent
def _forget(*_arguments):
    """Drops all state when another file is loaded or the add-on is unregistered."""
    viewport.stop()
    session.forget()


def register():
    gpu_context.register(FoveaEngine)
    bpy.app.handlers.load_pre.append(_forget)


def unregister():
    bpy.app.handlers.load_pre.remove(_forget)
    _forget()
    gpu_context.unregister()
