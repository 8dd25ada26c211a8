# SPDX-License-Identifier: GPL-3.0-or-later
"""The node group that draws lines over a picture. It exists once in a file; its sockets have what users set."""

import bpy

from . import compositor

NAME = "Fovea Lines Over"
KEY = "fovea_group"  # custom property; the name `fovea` is that of our own settings
_SHARE = {"subtype": "FACTOR", "min_value": 0.0, "max_value": 1.0}
INPUTS = {  # socket -> (type, members)
    "Image": ("NodeSocketColor", {"default_value": (0.0, 0.0, 0.0, 0.0)}),
    "Lines": ("NodeSocketColor", {"default_value": (0.0, 0.0, 0.0, 0.0)}),
    "Opacity": ("NodeSocketFloat", {**_SHARE, "default_value": 1.0}),
    "Multiply": ("NodeSocketFloat", {**_SHARE, "default_value": 0.0}),
}


def found():
    """The group of this file, or None."""
    groups = (tree for tree in bpy.data.node_groups if tree.library is None and tree.get(KEY) == NAME)
    return next(groups, None)


def make():
    """The group of this file, made where there is none.

    Of a picture B with alpha b and lines F with alpha a, both premultiplied, and M = Multiply:
    F' = (1 - M) F + M F (B + 1 - b), and the result is F' + (1 - a) B, mixed with B by Opacity."""
    if made := found():
        return made
    made = bpy.data.node_groups.new(NAME, "CompositorNodeTree")
    made[KEY] = NAME
    for name, (kind, members) in INPUTS.items():
        socket = made.interface.new_socket(name, in_out="INPUT", socket_type=kind)
        for member, value in members.items():
            setattr(socket, member, value)
    made.interface.new_socket("Image", in_out="OUTPUT", socket_type="NodeSocketColor")
    given, out = made.nodes.new("NodeGroupInput"), made.nodes.new("NodeGroupOutput")
    picture, lines, opacity, multiply = (given.outputs[name] for name in INPUTS)
    on_white = compositor.alpha_over(made, (1.0, 1.0, 1.0, 1.0), picture)
    darkened = compositor.multiplied(made, lines, on_white, multiply)
    made.links.new(out.inputs[0], compositor.alpha_over(made, picture, darkened, opacity))
    for place, node in enumerate((given, on_white.node, darkened.node, out)):
        node.location.x = 200 * place
    return made
