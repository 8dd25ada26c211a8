# SPDX-License-Identifier: GPL-3.0-or-later
"""The compositor's node trees in both generations of Blender's interface: up to 4.5 a scene has its own tree with a
Composite node; from 5.0 on it points to a node group, whose first output is the picture."""

import bpy

GROUPS = bpy.app.version >= (5, 0, 0)


def tree(scene):
    """The node tree that composites a scene's renders, or None."""
    if GROUPS:
        return scene.compositing_node_group
    return scene.node_tree if scene.use_nodes else None


def is_off(scene):
    """Whether a scene has a tree that would change its picture if it were on."""
    if GROUPS or scene.use_nodes or not _has_nodes(scene):
        return False
    out = output(scene.node_tree)
    source = out.links[0].from_node if out and out.is_linked else None
    return source is None or source.type != "R_LAYERS" or source.scene not in (None, scene)


def _has_nodes(scene):
    """Whether a scene has a tree of its own that is not empty, up to 4.5."""
    return scene.node_tree is not None and len(scene.node_tree.nodes) > 0


def make_tree(scene):
    """The node tree that composites a scene's renders and no other scene's: where there is none a new one, which shows
    them as they are."""
    found = tree(scene)
    if found and GROUPS and _scenes_with(found) > 1:
        found = scene.compositing_node_group = found.copy()
    if found:
        return found
    if not GROUPS and _has_nodes(scene):
        scene.use_nodes = True
        return scene.node_tree
    if GROUPS:
        made = bpy.data.node_groups.new(f"{scene.name} Compositing", "CompositorNodeTree")
        made.interface.new_socket("Image", in_out="OUTPUT", socket_type="NodeSocketColor")
        scene.compositing_node_group = made
    else:
        scene.use_nodes = True
        made = scene.node_tree
        made.nodes.clear()  # those of Blender's default are linked to nothing of ours
    photo, out = rendered(made, scene), made.nodes.new("NodeGroupOutput" if GROUPS else "CompositorNodeComposite")
    photo.location, out.location = (-300, 0), (300, 0)
    made.links.new(out.inputs[0], photo.outputs["Image"])
    return made


def remove_tree(scene):
    """Renders of the scene are not composited any more."""
    if GROUPS:
        bpy.data.node_groups.remove(scene.compositing_node_group)
    else:
        scene.node_tree.nodes.clear()
        scene.use_nodes = False


def _scenes_with(tree):
    return sum(GROUPS and scene.compositing_node_group == tree for scene in bpy.data.scenes)


def output(tree):
    """The socket whose value is the picture; None if the tree has no active output."""
    kind = "GROUP_OUTPUT" if GROUPS else "COMPOSITE"
    outputs = [node for node in tree.nodes if node.type == kind and not node.mute]
    found = next((node for node in outputs if not GROUPS or node.is_active_output), next(iter(outputs), None))
    return next((socket for socket in found.inputs if socket.type == "RGBA"), None) if found else None


def make_output(tree):
    """The socket whose value is the picture, of a new node if there is none."""
    if (found := output(tree)) is not None:
        return found
    if GROUPS and not any(item.in_out == "OUTPUT" for item in outputs_of(tree)):
        tree.interface.new_socket("Image", in_out="OUTPUT", socket_type="NodeSocketColor")
    tree.nodes.new("NodeGroupOutput" if GROUPS else "CompositorNodeComposite").location = (600, 0)
    return output(tree)


def outputs_of(tree):
    """The sockets of a node group's interface."""
    return [item for item in tree.interface.items_tree if item.item_type == "SOCKET"]


def rendered(tree, scene, layer=None):
    """A new Render Layers node of a scene's view layer; None: the first one that is rendered."""
    made = tree.nodes.new("CompositorNodeRLayers")
    made.scene = scene  # from 5.0 on a node without a scene renders nothing
    made.layer = layer or next((layer for layer in scene.view_layers if layer.use), scene.view_layers[0]).name
    return made


def picture_of(tree, scene, layer):
    """The socket by which a tree shows the picture of a scene's view layer: one that is linked, if any; or None."""
    nodes = [node for node in tree.nodes if node.type == "R_LAYERS" and node.layer == layer.name and not node.mute]
    of_scene = [node.outputs["Image"] for node in nodes if node.scene == scene or (not GROUPS and node.scene is None)]
    return next((socket for socket in of_scene if socket.is_linked), next(iter(of_scene), None))


def alpha_over(tree, below, above, factor=1.0):
    """The picture that a new Alpha Over node makes of premultiplied ones. Each is a socket or a value."""
    node = tree.nodes.new("CompositorNodeAlphaOver")
    named = {"Background": below, "Foreground": above, "Factor": factor}
    places = dict(zip(named, named if GROUPS else (1, 2, 0)))  # their order is another one in each generation
    for name, value in named.items():
        _feed(tree, node.inputs[places[name]], value)
    return node.outputs[0]


def multiplied(tree, first, second, factor):
    """(1 - factor) first + factor first second, with the alpha of the first, by a new node."""
    if GROUPS:
        node = tree.nodes.new("ShaderNodeMix")
        node.data_type, node.blend_type = "RGBA", "MULTIPLY"
        inputs = {socket.identifier: socket for socket in node.inputs}
        places, out = [inputs[name] for name in ("Factor_Float", "A_Color", "B_Color")], "Result_Color"
        node.clamp_factor = node.clamp_result = False
    else:
        node = tree.nodes.new("CompositorNodeMixRGB")
        node.blend_type = "MULTIPLY"
        places, out = list(node.inputs)[:3], "Image"
    for socket, value in zip(places, (factor, first, second)):
        _feed(tree, socket, value)
    return next(socket for socket in node.outputs if socket.identifier == out)


def _feed(tree, socket, value):
    if isinstance(value, bpy.types.NodeSocket):
        tree.links.new(socket, value)
    else:
        socket.default_value = value
