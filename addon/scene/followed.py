# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes that draw the lines of another scene over its pictures. A render of one follows the other scene's camera,
border, style and settings as they are at that frame: nothing of them is copied that could be out of date.

Its depsgraph has the other scene's objects because that is its background set, or because it is a linked copy."""


def of(scene):
    """The scene whose lines a scene's renders draw: the one it follows, or itself."""
    return scene.fovea.lines_of or scene


def follows(scene):
    """Whether a scene draws the lines of another one."""
    return scene.fovea.lines_of is not None


def evaluated(depsgraph):
    """The scene whose lines a depsgraph's renders draw, with the animated values of the frame."""
    return depsgraph.id_eval_get(of(depsgraph.scene)) if follows(depsgraph.scene) else depsgraph.scene_eval


def view_layer(depsgraph):
    """The evaluated view layer that a depsgraph's objects are in. Of a background set, Blender takes the first view
    layer that is rendered."""
    if depsgraph.scene.background_set is None or not follows(depsgraph.scene):
        return depsgraph.view_layer_eval
    layers = evaluated(depsgraph).view_layers
    return next((layer for layer in layers if layer.use), layers[0])


def camera(scene):
    """The camera that a scene's lines are seen by at the scene's current frame, or None."""
    return seen_by(of(scene), scene.frame_current) if follows(scene) else scene.camera


def seen_by(scene, frame):
    """The camera of a scene at a frame, or None: that of the last marker up to it that has one, else of the first one,
    as Blender chooses it; without such markers the scene's."""
    render = scene.render
    if render.frame_map_old != render.frame_map_new:
        frame = int(frame * render.frame_map_new / render.frame_map_old)
    bound = [marker for marker in scene.timeline_markers if marker.camera and not marker.camera.hide_render]
    first = min(bound, key=lambda marker: marker.frame, default=None)
    last = max((marker for marker in bound if marker.frame <= frame), key=lambda marker: marker.frame, default=first)
    return last.camera if last else scene.camera
