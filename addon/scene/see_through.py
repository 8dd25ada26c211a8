# SPDX-License-Identifier: GPL-3.0-or-later
"""Estimates the transparency of a material from its nodes, without evaluating them.

A material occludes unless it is transparent as a whole, as glass is. One whose opacity comes from an image, as that of
cards with leaves or hair, is cut out where the image is transparent; where opacity varies in a way that cannot be told,
it occludes as a whole.
"""

from dataclasses import dataclass

from . import opacity_nodes, shader_links

ENOUGH = 0.5  # a material with a transparency above this does not occlude; so does a part of a surface

# Values of nodes that drive a Mix Shader's factor, for a camera ray at normal incidence; such mixes imitate glass.
FACTORS = {"FRESNEL": 0.0, "LAYER_WEIGHT": 0.0, "LIGHT_PATH": 0.0}
CAMERA_RAY = "Is Camera Ray"


@dataclass(frozen=True)
class Through:
    """Bounds of a shader's transparency, in [0, 1]."""

    least: float = 0.0
    most: float = 0.0  # above `least` if it varies over the surface or nodes could not be followed
    why: tuple = ()  # phrases on the reasons for transparency
    cut: object | None = None  # opacity_nodes.Source: where it is opaque
    unknown: str = ""  # phrase on why that cannot be told although it varies

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
    edge = material.alpha_threshold if getattr(material, "blend_method", "") == "CLIP" else 1.0 - ENOUGH
    output = shader_links.output_of(material)
    if output is not None:
        if output.inputs["Volume"].links and not output.inputs["Surface"].links:
            return Through(1.0, 1.0, ("it is a volume without a surface",))
        if output.inputs["Surface"].links:
            return _of_socket(output.inputs["Surface"], (), edge)
    alpha = min(max(material.diffuse_color[3], 0.0), 1.0)
    return Through(
        1.0 - alpha, 1.0 - alpha, (f"the alpha of its viewport color is {alpha:.2g}",) if alpha < 1.0 else ()
    )


def _of_socket(socket, groups, edge):
    """The Through of the shader linked to a socket, opaque above `edge`; OPAQUE without one, which renders black."""
    link, _, groups = shader_links.origin(socket, groups)
    if link is None:
        return OPAQUE
    shader = link.from_node
    if shader.type == "BSDF_PRINCIPLED":
        return _of_principled(shader, groups, edge)
    if shader.type == "MIX_SHADER":
        return _of_mix(shader, groups, edge)
    if shader.type == "ADD_SHADER":
        return _of_sum(shader, groups, edge)
    return CLEAR.get(shader.type, OPAQUE)


def _of_principled(shader, groups, edge):
    """Through of a Principled BSDF from its alpha and transmission. If alpha is linked, it is taken to cut out leaves
    or hair and transmission to be their translucency: least = 0, so they occlude."""
    a0, a1, why_alpha = _value(shader.inputs["Alpha"], groups, "its alpha")
    t0, t1, why_transmission = _value(shader.inputs["Transmission Weight"], groups, "its transmission")
    why = (*(why_alpha if a0 < 1.0 else ()), *(why_transmission if t1 > 0.0 else ()))
    if a0 == a1:
        return Through(1.0 - a1 * (1.0 - t0), 1.0 - a0 * (1.0 - t1), why)
    return Through(0.0, 1.0 - a0 * (1.0 - t1), why, *_opacity(shader.inputs["Alpha"], groups, edge))


def _of_mix(shader, groups, edge):
    """Through of a Mix Shader: bounds of the weighted mean."""
    low, high, why = _value(shader.inputs[0], groups, "its mix factor")
    first, second = (_of_socket(socket, groups, edge) for socket in shader.inputs[1:3])
    used = [part for part, weight in ((first, 1.0 - low), (second, high)) if weight > 0.0]
    differ = len(used) > 1 and (first.least, first.most) != (second.least, second.most)
    why = [*(phrase for part in used for phrase in part.why), *(why if differ else ())]
    least = min((1.0 - f) * first.least + f * second.least for f in (low, high))
    most = max((1.0 - f) * first.most + f * second.most for f in (low, high))
    why = tuple(dict.fromkeys(why)) if most > 0.0 else ()
    if len(used) == 1:
        return Through(least, most, why, used[0].cut, used[0].unknown)
    return Through(least, most, why, *_of_mixed(shader.inputs[0], first, second, low < high, groups, edge))


def _of_mixed(factor, first, second, varies, groups, edge):
    """(Source, phrase) as in Through of a mix of two shaders, of which one may be clear and the other opaque."""
    if first.cut or second.cut or first.unknown or second.unknown:
        return None, first.unknown or second.unknown or "it is mixed with another shader"
    if not varies or first.is_enough == second.is_enough:
        return None, ""
    cut, unknown = _opacity(factor, groups, edge if first.is_enough else 1.0 - edge)
    return (cut and not first.is_enough and cut.inverted()) or cut, unknown


def _opacity(socket, groups, edge):
    """(Source, phrase) as in Through of the opacity at a socket."""
    try:
        return opacity_nodes.source(socket, groups, edge), ""
    except opacity_nodes.Unknown as unknown:
        return None, str(unknown)


def _of_sum(shader, groups, edge):
    """Through of an Add Shader: the minimum of its parts, so the more opaque one decides. (Leaves, for example, add a
    Transparent BSDF for translucency.) Emission is ignored, because it only adds light."""
    parts = []
    for socket in shader.inputs:
        link, _, _ = shader_links.origin(socket, groups)
        if link is not None and link.from_node.type != "EMISSION":
            parts.append(_of_socket(socket, groups, edge))
    if not parts:
        return OPAQUE
    most = min(part.most for part in parts)
    why = dict.fromkeys(phrase for part in parts for phrase in part.why)
    opaque = [part for part in parts if not part.is_enough]
    cut, unknown = (opaque[0].cut, opaque[0].unknown) if len(opaque) == 1 else (None, "")
    return Through(min(part.least for part in parts), most, tuple(why) if most > 0.0 else (), cut, unknown)


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
