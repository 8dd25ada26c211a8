# SPDX-License-Identifier: GPL-3.0-or-later
"""Derives a material's base color from its nodes, as far as possible without evaluating them."""

import math
from dataclasses import dataclass, replace

from . import shader_links

# Type of shader node -> name of its color input.
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
ACTIVE = ""  # stands for the mesh's active UV map or color attribute for rendering


@dataclass(frozen=True)
class Source:
    """A constant color multiplied by an image and by a color attribute of the mesh."""

    color: tuple = (0.8, 0.8, 0.8)  # scene-linear
    image: object | None = None  # bpy.types.Image
    uv: str = ACTIVE
    place: tuple = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0)  # 2 x 3 affine matrix by rows, from UVs to image coordinates
    attribute: str | None = None
    unlit: bool = False
    viewport: tuple = (0.8, 0.8, 0.8)  # replaces the color if the image or the attribute is missing
    opacity: float = 0.0  # of a material that hides nothing: see materials.opacity
    followed: bool = True  # False: nodes that cannot be resolved statically; the viewport color replaces them

    @property
    def plain(self):
        """The color where there is neither an image nor an attribute."""
        return self.viewport if self.image or self.attribute is not None else self.color


def source(material):
    """The Source of a material; for an empty slot (None), the mesh's active color attribute."""
    if material is None:
        return Source(attribute=ACTIVE)
    viewport = tuple(material.diffuse_color)[:3]
    shader = _colored(shader_links.surface_shader(material))
    if shader is None:
        # Without a surface shader the viewport color is correct; a shader without a color input is not followed.
        return Source(viewport, viewport=viewport, followed=shader_links.surface_shader(material) is None)
    found = _of_socket(shader.inputs[COLOR_INPUTS[shader.type]], shader.type == "EMISSION")
    return replace(found or Source(viewport, followed=False), viewport=viewport)


def _colored(shader):
    """The shader itself if it has a color input, or the first such in a tree of mixed or added shaders; else None."""
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
        placed = where(node.inputs["Vector"])
        return placed and Source((1.0, 1.0, 1.0), node.image, *placed, unlit=unlit)
    if node.type == "VERTEX_COLOR":
        return Source((1.0, 1.0, 1.0), attribute=node.layer_name, unlit=unlit)
    if node.type == "ATTRIBUTE" and node.attribute_type == "GEOMETRY" and node.attribute_name:
        return Source((1.0, 1.0, 1.0), attribute=node.attribute_name, unlit=unlit)
    return None


def where(socket):
    """(UV map, 2 x 3 rows of the mapping) of an image node's vector input; None if it is not a UV map."""
    node = shader_links.source(socket)
    if node is None:
        return ACTIVE, Source.place
    if node.type == "UVMAP" and not node.from_instancer:
        return node.uv_map, Source.place
    if node.type == "ATTRIBUTE" and node.attribute_type == "GEOMETRY" and node.attribute_name:
        return node.attribute_name, Source.place
    if node.type == "TEX_COORD":
        return (ACTIVE, Source.place) if socket.links[0].from_socket.name == "UV" else None
    if node.type == "MAPPING" and node.vector_type == "POINT":
        inner = where(node.inputs["Vector"])
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
