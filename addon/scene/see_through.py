# SPDX-License-Identifier: GPL-3.0-or-later
"""Estimates the transparency of a material from its nodes, without evaluating them.

Occlusion is binary per material, and alpha is not sampled over the surface: a material occludes unless it is
transparent as a whole. So alpha-mapped cards of leaves or hair occlude, and glass does not.
"""

from dataclasses import dataclass

from . import shader_links

ENOUGH = 0.5  # a material with a transparency above this does not occlude

# Values of nodes that drive a Mix Shader's factor, for a camera ray at normal incidence; such mixes imitate glass.
FACTORS = {"FRESNEL": 0.0, "LAYER_WEIGHT": 0.0, "LIGHT_PATH": 0.0}
CAMERA_RAY = "Is Camera Ray"


@dataclass(frozen=True)
class Through:
    """Bounds of a shader's transparency, in [0, 1]."""

    least: float = 0.0
    most: float = 0.0  # above `least` if it varies over the surface or nodes could not be followed
    why: tuple = ()  # phrases on the reasons for transparency

    @property
    def is_enough(self):
        return self.least > ENOUGH


OPAQUE = Through()
CLEAR = {  # by type of shader node
    "BSDF_TRANSPARENT": Through(1.0, 1.0, ("it has a Transparent BSDF",)),
    "BSDF_GLASS": Through(1.0, 1.0, ("it is glass",)),
    "BSDF_REFRACTION": Through(1.0, 1.0, ("it is glass",)),
}


def through(material):
    """The Through of a material."""
    output = shader_links.output_of(material)
    if output is not None:
        if output.inputs["Volume"].links and not output.inputs["Surface"].links:
            return Through(1.0, 1.0, ("it is a volume without a surface",))
        if output.inputs["Surface"].links:
            return _of_socket(output.inputs["Surface"], ())
    alpha = min(max(material.diffuse_color[3], 0.0), 1.0)
    return Through(
        1.0 - alpha, 1.0 - alpha, (f"the alpha of its viewport color is {alpha:.2g}",) if alpha < 1.0 else ()
    )


def _of_socket(socket, groups):
    """The Through of the shader linked to a socket; OPAQUE without one, which renders black."""
    link, _, groups = shader_links.origin(socket, groups)
    if link is None:
        return OPAQUE
    shader = link.from_node
    if shader.type == "BSDF_PRINCIPLED":
        return _of_principled(shader, groups)
    if shader.type == "MIX_SHADER":
        return _of_mix(shader, groups)
    if shader.type == "ADD_SHADER":
        return _of_sum(shader, groups)
    return CLEAR.get(shader.type, OPAQUE)


def _of_principled(shader, groups):
    """Through of a Principled BSDF from its alpha and transmission. If alpha is linked, it is taken to cut out leaves
    or hair and transmission to be their translucency: least = 0, so they occlude."""
    a0, a1, why_alpha = _value(shader.inputs["Alpha"], groups, "its alpha")
    t0, t1, why_transmission = _value(shader.inputs["Transmission Weight"], groups, "its transmission")
    why = (*(why_alpha if a0 < 1.0 else ()), *(why_transmission if t1 > 0.0 else ()))
    return Through(1.0 - a1 * (1.0 - t0) if a0 == a1 else 0.0, 1.0 - a0 * (1.0 - t1), why)


def _of_mix(shader, groups):
    """Through of a Mix Shader: bounds of the weighted mean."""
    low, high, why = _value(shader.inputs[0], groups, "its mix factor")
    first, second = (_of_socket(socket, groups) for socket in shader.inputs[1:3])
    used = [part for part, weight in ((first, 1.0 - low), (second, high)) if weight > 0.0]
    differ = len(used) > 1 and (first.least, first.most) != (second.least, second.most)
    why = [*(phrase for part in used for phrase in part.why), *(why if differ else ())]
    least = min((1.0 - f) * first.least + f * second.least for f in (low, high))
    most = max((1.0 - f) * first.most + f * second.most for f in (low, high))
    return Through(least, most, tuple(dict.fromkeys(why)) if most > 0.0 else ())


def _of_sum(shader, groups):
    """Through of an Add Shader: the minimum of its parts, so the more opaque one decides. (Leaves, for example, add a
    Transparent BSDF for translucency.) Emission is ignored, because it only adds light."""
    parts = []
    for socket in shader.inputs:
        link, _, _ = shader_links.origin(socket, groups)
        if link is not None and link.from_node.type != "EMISSION":
            parts.append(_of_socket(socket, groups))
    if not parts:
        return OPAQUE
    most = min(part.most for part in parts)
    why = dict.fromkeys(phrase for part in parts for phrase in part.why)
    return Through(min(part.least for part in parts), most, tuple(why) if most > 0.0 else ())


def _value(socket, groups, name):
    """(least, most, phrases about it) of a value clamped to [0, 1] at a socket; (0, 1) if linked to unknown nodes."""
    link, socket, _ = shader_links.origin(socket, groups)
    if link is None:
        value = socket.default_value
    elif link.from_node.type == "VALUE":
        value = link.from_socket.default_value
    elif link.from_node.type in FACTORS:
        value = 1.0 if link.from_socket.name == CAMERA_RAY else FACTORS[link.from_node.type]
        return value, value, ()
    else:
        return 0.0, 1.0, (f"{name} is linked",)
    value = min(max(value, 0.0), 1.0)
    return value, value, (f"{name} is {value:.2g}",)
