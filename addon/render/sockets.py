# SPDX-License-Identifier: GPL-3.0-or-later
"""Sockets of compositors follow what changes passes without a switch of its own: line sets, colors, focus."""

import bpy
from bpy.app.handlers import persistent

from . import passes, session

_known = {}  # (scene, view layer), by name -> names of its passes, when sockets were renewed


@persistent
def _follow(_scene, depsgraph):
    if any(isinstance(update.id, (bpy.types.Scene, bpy.types.NodeTree)) for update in depsgraph.updates):
        follow()


def follow():
    """Renews the sockets if any scene that Fovea renders has other passes than when this was done last."""
    if not any(map(_composites, bpy.data.scenes)):
        return
    drawn = [scene for scene in bpy.data.scenes if scene.render.engine == "FOVEA"]
    found = {(scene.name, layer.name): _names(scene, layer) for scene in drawn for layer in scene.view_layers}
    if found != _known:
        _known.clear()
        _known.update(found)
        passes.renew_sockets()


def _composites(scene):
    """Whether a scene has nodes of a compositor; until 4.5 they are its own."""
    return bool(scene.compositing_node_group if hasattr(scene, "compositing_node_group") else scene.node_tree)


def _names(scene, layer):
    return [name for names in session.wanted_passes(scene, layer).values() for name in names]


def register():
    bpy.app.handlers.depsgraph_update_post.append(_follow)


def unregister():
    bpy.app.handlers.depsgraph_update_post.remove(_follow)
    _known.clear()
