# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines over the renders of another engine: a scene that draws the lines, and the compositor's nodes that lay them over
the picture. Nodes carry a mark, so that they are found whatever they are called."""

import bpy

from ..scene import followed
from ..scene.problem import CannotDraw
from . import compositor, lines_group, lines_scenes

MARK = "fovea_node"  # custom property of nodes
LINES, OVER, PLAIN = "lines", "over", "plain"  # its values; PLAIN: nodes of a tree that was made here
OF_LAYER = "_of_layer"  # at the end of those for lines of one view layer
DRAWN = "fovea_lines"  # custom property of these nodes: the scene that draws them; none if that was removed


def node(scene, mark, layer=None):
    """The first node of a scene's compositor with a mark, or None; `layer`: for the lines of that view layer alone."""
    return next(_nodes(scene, layer, mark), None)


def _nodes(scene, layer, *marks):
    """Yields the nodes with marks for the lines over the whole picture (None) or over that of a view layer."""
    tree, lines = compositor.tree(scene), lines_scenes.of(scene, layer)
    for each in tree.nodes if tree else ():
        if layer is None and each.get(MARK) in marks:
            yield each
        elif layer and lines and each.get(DRAWN) == lines and each.get(MARK) in {mark + OF_LAYER for mark in marks}:
            yield each


def places(scene):
    """What has lines over it in a scene's renders: None, which is the whole picture, or view layers."""
    whole = lines_scenes.of(scene) is not None or node(scene, OVER) is not None
    return [None] * whole + [layer for layer in scene.view_layers if lines_scenes.of(scene, layer)]


def is_on(scene):
    """Whether there is what draws lines over a scene's renders."""
    return bool(places(scene))


def _over(scene):
    """The node that lays lines over a scene's picture, or those of a scene that draws lines; None."""
    layer = lines_scenes.layer_of(scene) if followed.follows(scene) else None
    return node(followed.of(scene), OVER, layer)


def blend(settings):
    """Index of the blend mode of lines: 0 over, 1 multiply. `settings`: those of the scene that has them over its
    renders, or of one that draws them."""
    over = _over(settings.id_data)
    return int(over is not None and over.inputs["Multiply"].default_value > 0.5)


def set_blend(settings, index):
    if over := _over(settings.id_data):
        over.inputs["Multiply"].default_value = float(index)


def shown_layers(scene):
    """The rendered view layers of which a scene's compositor shows a picture."""
    return [layer for layer in scene.view_layers if layer.use and _picture_of(scene, layer)]


def _picture_of(scene, layer):
    """The socket by which a scene's compositor shows a view layer, or None."""
    tree = compositor.tree(scene)
    return compositor.picture_of(tree, scene, layer) if tree else None


def put_all(scene):
    """Lays lines over a scene's renders: over the whole picture, or where the compositor shows several view layers,
    over that of each. CannotDraw if that cannot be."""
    layers = shown_layers(scene)
    for layer in layers if len(layers) > 1 else [None]:
        put(scene, layer)


def put(scene, layer=None):
    """Lays lines over the picture of a scene or of one of its view layers, or repairs what does. CannotDraw if that
    cannot be."""
    if layer and not _picture_of(scene, layer):
        raise CannotDraw(f"The compositor shows no picture of '{layer.name}': add a Render Layers node of it first")
    tree = _own_tree(scene)
    lines = lines_scenes.of(scene, layer) or lines_scenes.make(scene, layer)
    lines_scenes.follow(lines)
    over = node(scene, OVER, layer) or _marked(tree.nodes.new("CompositorNodeGroup"), OVER, layer, lines)
    shown = node(scene, LINES, layer) or _marked(compositor.rendered(tree, lines), LINES, layer, lines)
    over.node_tree, shown.scene, over.mute, shown.mute = lines_group.make(), lines, False, False
    shown.layer, over.width = lines.view_layers[0].name, 180
    lines.view_layers[0].update_render_passes()
    _link(tree, scene, layer, over, shown)


def _marked(made, mark, layer, lines):
    made[MARK], made.label = mark, "Fovea Lines"
    if layer:
        made[MARK], made[DRAWN] = mark + OF_LAYER, lines
    return made


def repair(scene):
    """Puts back what lines over a scene's renders need, with what Blender must do for it switched on."""
    _remove_strays(scene)
    for layer in places(scene):
        put(scene, layer)
    if not is_on(scene):
        put_all(scene)
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


def _link(tree, scene, layer, over, shown):
    """Links the nodes that are not linked: between the picture and what it was made of, or is made of that of a view
    layer."""
    picture = over.inputs["Image"]
    before = picture.links[0].from_socket if picture.is_linked else None
    if layer:
        before = before or _picture_of(scene, layer)
        after = [link.to_socket for link in before.links if link.to_node != over]
        beside = before.node.location.x + 350, before.node.location.y
    else:
        out = compositor.make_output(tree)
        before, after, beside = before or _before(tree, scene, out, over), [out], tuple(out.node.location)
    if not picture.is_linked:
        tree.links.new(picture, before)
        over.location = beside
        shown.location = over.location.x - 350, over.location.y - 250
        for moved in after if not layer else ():
            moved.node.location.x += 300
    tree.links.new(over.inputs["Lines"], shown.outputs["Lines"])
    for socket in after if not over.outputs[0].is_linked else ():
        tree.links.new(socket, over.outputs[0])


def _before(tree, scene, out, over):
    """The socket of what is the picture without lines; where there is nothing, of a new node."""
    if out.is_linked and out.links[0].from_node != over:
        return out.links[0].from_socket
    photo = compositor.rendered(tree, scene)
    photo.location = out.node.location.x - 700, out.node.location.y
    return photo.outputs["Image"]


def remove(scene):
    """Takes all lines from a scene's renders: leaves what was there before."""
    _remove_strays(scene)
    for layer in places(scene):
        remove_from(scene, layer)


def remove_from(scene, layer=None):
    """Takes the lines from the picture of a scene or of one of its view layers."""
    tree, over = compositor.tree(scene), node(scene, OVER, layer)
    if over is not None:
        _bypass(tree, over)
    for made in list(_nodes(scene, layer, LINES, OVER)):
        tree.nodes.remove(made)
    if tree and len(tree.nodes) and all(left.get(MARK) == PLAIN for left in tree.nodes):
        compositor.remove_tree(scene)
    group = lines_group.found()
    if group and not group.users:
        bpy.data.node_groups.remove(group)
    if lines := lines_scenes.of(scene, layer):
        bpy.data.scenes.remove(lines)


def _bypass(tree, over):
    """Links what shows a picture with lines to the picture itself."""
    source = over.inputs["Image"].links[0].from_socket if over.inputs["Image"].is_linked else None
    for link in list(over.outputs[0].links) if source else ():
        tree.links.new(link.to_socket, source)


def _remove_strays(scene):
    """Removes what drew the lines of view layers that are gone."""
    tree = compositor.tree(scene)
    for lines in lines_scenes.strays(scene):
        bpy.data.scenes.remove(lines)
    for lost in [each for each in tree.nodes if DRAWN in each.keys() and each[DRAWN] is None] if tree else ():
        if lost[MARK] == OVER + OF_LAYER:
            _bypass(tree, lost)
        tree.nodes.remove(lost)
