# SPDX-License-Identifier: GPL-3.0-or-later
"""What a material's nodes say about its base color, where that can be told without running them."""

import math
from dataclasses import dataclass, replace

from . import shader_links

# Shader node -> the input that is its color.
COLOR_INPUTS = {
    "BSDF_PRINCIPLED": "Base Color",
    "BSDF_DIFFUSE": "Color",
    "BSDF_GLOSSY": "Color",
    "BSDF_TOON": "Color",
    "BSDF_TRANSLUCENT": "Color",
    "BSDF_GLASS": "Color",
    "BSDF_METALLIC": "Base Color",
    "SUBSURFACE_SCATTERING": "Color",
    "EMISSION": "Color",
}
ACTIVE = ""  # the mesh's own choice of a UV map or a color attribute


@dataclass(frozen=True)
class Source:
    """A color, times an image, times an attribute of the mesh."""

    color: tuple = (0.8, 0.8, 0.8)  # scene-linear
    image: object | None = None  # Blender's
    uv: str = ACTIVE
    place: tuple = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0)  # two rows that map the UVs to the image
    attribute: str | None = None
    unlit: bool = False
    viewport: tuple = (0.8, 0.8, 0.8)  # stands for what is not there: an image or an attribute
    followed: bool = True  # False: nodes that cannot be told beforehand; the viewport color stands for them


def source(material):
    """The Source of a material; an empty slot shows the mesh's active colors, if it has any."""
    if material is None:
        return Source(attribute=ACTIVE)
    viewport = tuple(material.diffuse_color)[:3]
    shader = _colored(shader_links.surface_shader(material))
    if shader is None:
        # No surface at all looks as in the viewport; a shader without a color is one that is not followed.
        return Source(viewport, viewport=viewport, followed=shader_links.surface_shader(material) is None)
    found = _of_socket(shader.inputs[COLOR_INPUTS[shader.type]], shader.type == "EMISSION")
    return replace(found or Source(viewport, followed=False), viewport=viewport)


def _colored(shader):
    """The first shader of a mix that has a color of its own, or None."""
    if shader is None or shader.type in COLOR_INPUTS:
        return shader
    if shader.type in {"MIX_SHADER", "ADD_SHADER"}:
        parts = (shader_links.source(socket) for socket in shader.inputs if socket.type == "SHADER")
        return next((found for part in parts if (found := _colored(part)) is not None), None)
    return None


def _of_socket(socket, unlit):
    node = shader_links.source(socket)
    if node is None:
        return Source(tuple(socket.default_value)[:3], unlit=unlit)
    if node.type == "RGB":
        return Source(tuple(node.outputs[0].default_value)[:3], unlit=unlit)
    if node.type == "TEX_IMAGE" and node.image is not None and node.projection == "FLAT":
        where = _where(node.inputs["Vector"])
        return where and Source((1.0, 1.0, 1.0), node.image, *where, unlit=unlit)
    if node.type == "VERTEX_COLOR":
        return Source((1.0, 1.0, 1.0), attribute=node.layer_name, unlit=unlit)
    if node.type == "ATTRIBUTE" and node.attribute_type == "GEOMETRY" and node.attribute_name:
        return Source((1.0, 1.0, 1.0), attribute=node.attribute_name, unlit=unlit)
    return None


def _where(socket):
    """(UV map, rows of the mapping) of an image's vector, or None where it is something else than a UV map."""
    node = shader_links.source(socket)
    if node is None:
        return ACTIVE, Source.place
    if node.type == "UVMAP" and not node.from_instancer:
        return node.uv_map, Source.place
    if node.type == "TEX_COORD":
        return (ACTIVE, Source.place) if socket.links[0].from_socket.name == "UV" else None
    if node.type == "MAPPING" and node.vector_type == "POINT":
        inner = _where(node.inputs["Vector"])
        inputs = [node.inputs[name] for name in ("Location", "Rotation", "Scale")]
        plain = inner is not None and inner[1] == Source.place and not any(i.links for i in inputs)
        return (inner[0], _mapping(*(i.default_value for i in inputs))) if plain else None
    return None


def _mapping(location, rotation, scale):
    cosine, sine = math.cos(rotation[2]), math.sin(rotation[2])
    return (
        *(cosine * scale[0], -sine * scale[1], location[0]),
        *(sine * scale[0], cosine * scale[1], location[1]),
    )
