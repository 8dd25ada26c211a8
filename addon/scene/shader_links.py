# SPDX-License-Identifier: GPL-3.0-or-later
"""Follows links between the sockets of shader nodes, without evaluating nodes."""


def output_of(material):
    """The material's output node, or None if it has no nodes: that for all engines, else for Eevee, else for Cycles."""
    # From Blender 5 on every material uses nodes, and use_nodes is deprecated.
    if material.node_tree is None or not getattr(material, "use_nodes", True):
        return None
    found = map(material.node_tree.get_output_node, ("ALL", "EEVEE", "CYCLES"))
    return next((output for output in found if output is not None), None)


def surface_shader(material):
    """The shader node at the material's surface output, or None."""
    output = output_of(material)
    return source(output.inputs["Surface"]) if output else None


def link_to(socket):
    """The valid, unmuted link into a socket, with reroutes skipped; or None."""
    while link := next((link for link in socket.links if link.is_valid and not link.is_muted), None):
        if link.from_node.type != "REROUTE":
            return link
        socket = link.from_node.inputs[0]
    return None


def source(socket):
    """The node linked to a socket, with reroutes skipped; or None."""
    link = link_to(socket)
    return link and link.from_node


def origin(socket, groups):
    """(link, socket, groups): the origin of a socket's value, followed into and out of node groups; link is None if the
    value is the default of the returned socket. `groups`: the enclosing group nodes, innermost last."""
    while link := link_to(socket):
        node, identifier = link.from_node, link.from_socket.identifier
        if node.type == "GROUP" and (inside := _group_output(node)):
            socket, groups = _by_identifier(inside.inputs, identifier), (*groups, node)
        elif node.type == "GROUP_INPUT" and groups:
            socket, groups = _by_identifier(groups[-1].inputs, identifier), groups[:-1]
        else:
            return link, socket, groups
    return None, socket, groups


def _group_output(node):
    nodes = node.node_tree.nodes if node.node_tree else ()
    return next((inside for inside in nodes if inside.type == "GROUP_OUTPUT" and inside.is_active_output), None)


def _by_identifier(sockets, identifier):
    return next(socket for socket in sockets if socket.identifier == identifier)
