# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines over the renders of another engine: a scene that draws the lines, and the compositor's nodes that lay them over
the picture. Nodes carry a mark, so that they are found whatever they are called."""

import bpy

from ..scene import followed
from ..scene.operator import Operator
from ..scene.problem import CannotDraw
from . import compositor, lines_group, lines_scenes

MARK = "fovea_node"  # custom property of nodes
LINES, OVER, PLAIN, FRAME = "lines", "over", "plain", "frame"  # its values; PLAIN: nodes of a tree that was made here


def node(scene, mark):
    """The first node of a scene's compositor with a mark, or None."""
    tree = compositor.tree(scene)
    return next((node for node in tree.nodes if node.get(MARK) == mark), None) if tree else None


def is_on(scene):
    """Whether there is what draws lines over a scene's renders."""
    return lines_scenes.of(scene) is not None or node(scene, OVER) is not None


def blend(settings):
    """Index of the blend mode of the lines over the renders of a scene: 0 over, 1 multiply. `settings`: the scene's."""
    over = node(settings.id_data, OVER)
    return int(over is not None and over.inputs["Multiply"].default_value > 0.5)


def set_blend(settings, index):
    if over := node(settings.id_data, OVER):
        over.inputs["Multiply"].default_value = float(index)


def put(scene):
    """Lays lines over a scene's renders, or repairs what does. CannotDraw if that cannot be."""
    tree = _own_tree(scene)
    lines = lines_scenes.of(scene) or lines_scenes.make(scene)
    lines_scenes.follow(lines)
    over, layer = node(scene, OVER), node(scene, LINES)
    if over is None:
        over = tree.nodes.new("CompositorNodeGroup")
        over[MARK], over.label, over.width = OVER, "Fovea Lines", 180
    if layer is None:
        layer = compositor.rendered(tree, lines)
        layer[MARK], layer.label = LINES, "Fovea Lines"
    over.node_tree, layer.scene, over.mute, layer.mute = lines_group.make(), lines, False, False
    layer.layer = lines.view_layers[0].name
    lines.view_layers[0].update_render_passes()
    _link(tree, scene, over, layer)


def repair(scene):
    """As `put`, with what Blender must do for it switched on."""
    put(scene)
    scene.render.use_compositing, scene.render.use_single_layer = True, False


def _own_tree(scene):
    """The scene's compositor, used by no other scene."""
    if compositor.is_off(scene):
        raise CannotDraw("The compositor has nodes that are switched off: turn on Use Nodes in it, or remove them")
    made = compositor.tree(scene) is None
    tree = compositor.make_tree(scene)
    if tree.library:
        raise CannotDraw(f"The compositor's nodes '{tree.name}' are linked from another file: make them local first")
    if made:
        for plain in tree.nodes:
            plain[MARK] = PLAIN
    return tree


def _link(tree, scene, over, layer):
    """Links the nodes that are not linked: between the picture and what it was made of."""
    out = compositor.make_output(tree)
    picture = over.inputs["Image"]
    if not picture.is_linked:
        before = out.links[0].from_socket if out.is_linked and out.links[0].from_node != over else None
        if before is None:
            photo = compositor.rendered(tree, scene)
            photo.location = out.node.location.x - 700, out.node.location.y
            before = photo.outputs["Image"]
        tree.links.new(picture, before)
        over.location = out.node.location
        layer.location = over.location.x - 350, over.location.y - 250
        out.node.location.x += 300
    tree.links.new(over.inputs["Lines"], layer.outputs["Lines"])
    if not over.outputs[0].is_linked:
        tree.links.new(out, over.outputs[0])


def remove(scene):
    """Takes the lines from a scene's renders: leaves what was there before."""
    tree, over = compositor.tree(scene), node(scene, OVER)
    if over is not None:
        source = over.inputs["Image"].links[0].from_socket if over.inputs["Image"].is_linked else None
        for link in list(over.outputs[0].links):
            if source is not None:
                tree.links.new(link.to_socket, source)
    for made in [made for made in tree.nodes if made.get(MARK) in {LINES, OVER, FRAME}] if tree else ():
        tree.nodes.remove(made)
    if tree and len(tree.nodes) and all(left.get(MARK) == PLAIN for left in tree.nodes):
        compositor.remove_tree(scene)
    group = lines_group.found()
    if group and not group.users:
        bpy.data.node_groups.remove(group)
    if lines := lines_scenes.of(scene):
        bpy.data.scenes.remove(lines)


class _OfPicture(Operator):
    """One that changes what lies over the renders of the context's scene."""

    @classmethod
    def hindrance(cls, context):
        scene = context.scene
        if scene is None or scene.library or scene.override_library:
            return "The scene is linked from another file: make it local first"
        if followed.follows(scene):
            return f"This scene draws the lines of '{scene.fovea.lines_of.name}': go to that one"
        if scene.render.engine == lines_scenes.ENGINE:
            return "Fovea draws the whole picture: choose another render engine"
        return cls.hindrance_of(scene)


class FOVEA_OT_lines_over(_OfPicture, bpy.types.Operator):
    """Draw Fovea's lines over what this engine renders, in every render and animation. It adds a scene that draws the
    lines, and nodes to the compositor"""

    bl_idname, bl_label = "fovea.lines_over", "Draw Lines Over Renders"

    @staticmethod
    def hindrance_of(scene):
        return "Lines are drawn over the renders already" if is_on(scene) else None

    def act(self, context):
        put(context.scene)


class FOVEA_OT_lines_over_remove(_OfPicture, bpy.types.Operator):
    """Draw no lines over the renders any more: remove the scene that draws them and its nodes"""

    bl_idname, bl_label = "fovea.lines_over_remove", "Remove Lines Over Renders"

    @staticmethod
    def hindrance_of(scene):
        return None if is_on(scene) else "No lines are drawn over the renders"

    def act(self, context):
        remove(context.scene)


class FOVEA_OT_lines_over_repair(_OfPicture, bpy.types.Operator):
    """Put back what the lines over the renders need and what has been removed, switched off or changed"""

    bl_idname, bl_label = "fovea.lines_over_repair", "Repair Lines Over Renders"
    hindrance_of = FOVEA_OT_lines_over_remove.hindrance_of

    def act(self, context):
        repair(context.scene)
