# SPDX-License-Identifier: GPL-3.0-or-later
"""Follows the opacity of a material to an image, as far as where it is opaque can be told without evaluating nodes."""

from dataclasses import dataclass, replace

from . import color_nodes, shader_links

EXTENSIONS = {"REPEAT": "repeat", "EXTEND": "extend", "CLIP": "clip", "MIRROR": "mirror"}  # names of the native Opacity
CHANNELS = {"Alpha": "ALPHA", "Red": "RED", "Green": "GREEN", "Blue": "BLUE", "R": "RED", "G": "GREEN", "B": "BLUE"}
STEPS = 256  # samples of a color ramp


class Unknown(Exception):  # noqa: N818
    """Opacity that cannot be told; the message is a phrase on why."""


@dataclass(frozen=True)
class Source:
    """Opaque where gain * value + offset exceeds the threshold; value: a channel of an image at a UV map."""

    image: str  # full name of the bpy.types.Image
    channel: str  # ALPHA, RED, GREEN, BLUE, or GRAY: luminance
    threshold: float
    uv: str = color_nodes.ACTIVE
    place: tuple = color_nodes.Source.place
    extension: str = "repeat"
    closest: bool = False
    gain: float = 1.0
    offset: float = 0.0

    def scaled(self, gain, offset):
        return replace(self, gain=self.gain * gain, offset=self.offset * gain + offset)

    def above(self, edge):
        """Opaque where the opacity so far exceeds `edge`."""
        return self.scaled(1.0, self.threshold - edge)

    def inverted(self):
        return self.scaled(-1.0, 2.0 * self.threshold)


def source(socket, groups, threshold):
    """The Source of the value linked to a socket, opaque above the threshold; raises Unknown."""
    link, socket, groups = shader_links.origin(socket, groups)
    if link is None:
        raise Unknown("it is not an image")
    node, output = link.from_node, link.from_socket
    if node.type == "TEX_IMAGE":
        return _of_image(node, output, threshold)
    if node.type in {"SEPARATE_COLOR", "SEPRGB"}:
        found = source(node.inputs[0], groups, threshold)
        if found.channel != "GRAY" or output.name not in CHANNELS or getattr(node, "mode", "RGB") != "RGB":
            raise Unknown("its colors are separated in a way that is not followed")
        return replace(found, channel=CHANNELS[output.name])
    if node.type == "MATH":
        return _of_math(node, groups, threshold)
    if node.type == "VALTORGB":
        return _of_ramp(node, groups, threshold)
    if node.type == "INVERT" and not node.inputs[0].links and node.inputs[0].default_value == 1.0:
        return source(node.inputs[1], groups, threshold).scaled(-1.0, 1.0)
    if node.type == "CLAMP" and node.inputs["Min"].default_value <= 0.0 and node.inputs["Max"].default_value >= 1.0:
        return source(node.inputs["Value"], groups, threshold)
    raise Unknown(f"it comes from a node that is not followed, {node.bl_label}")


def _of_image(node, output, threshold):
    if node.image is None:
        raise Unknown("its image node has no image")
    where = color_nodes.where(node.inputs["Vector"]) if node.projection == "FLAT" else None
    if where is None:
        raise Unknown(f"image '{node.image.name}' is not placed by a UV map")
    if node.image.source not in {"FILE", "GENERATED"}:
        raise Unknown(f"image '{node.image.name}' is a {node.image.source.lower()}")
    if not all(node.image.size):
        raise Unknown(f"image '{node.image.name}' cannot be read")
    return Source(
        image=node.image.name_full,
        channel="ALPHA" if output.name == "Alpha" else "GRAY",
        threshold=threshold,
        uv=where[0],
        place=where[1],
        extension=EXTENSIONS[node.extension],
        closest=node.interpolation == "Closest",
    )


def _of_math(node, groups, threshold):
    """Of sums, products and comparisons with constants."""
    used = node.inputs[:2]
    linked = [i for i, socket in enumerate(used) if shader_links.link_to(socket)]
    if node.operation == "ROUND" and linked[:1] == [0]:
        return source(used[0], groups, threshold).above(0.5)
    if len(linked) != 1 or node.operation not in {"ADD", "SUBTRACT", "MULTIPLY", "GREATER_THAN", "LESS_THAN"}:
        raise Unknown(f"it comes from a node that is not followed, {node.bl_label}: {node.operation.title()}")
    first, constant = linked[0] == 0, used[1 - linked[0]].default_value
    found = source(used[linked[0]], groups, threshold)
    if node.operation == "ADD":
        return found.scaled(1.0, constant)
    if node.operation == "MULTIPLY":
        return found.scaled(constant, 0.0)
    if node.operation == "SUBTRACT":
        return found.scaled(1.0, -constant) if first else found.scaled(-1.0, constant)
    above = found.above(constant)
    return above if (node.operation == "GREATER_THAN") == first else above.inverted()


def _of_ramp(node, groups, threshold):
    """Of a color ramp that passes the threshold once."""
    found = source(node.inputs[0], groups, threshold)
    colors = [node.color_ramp.evaluate(i / STEPS) for i in range(STEPS + 1)]
    opaque = [0.2126 * r + 0.7152 * g + 0.0722 * b > threshold for r, g, b, _ in colors]
    turns = [i for i in range(STEPS) if opaque[i] != opaque[i + 1]]
    if len(turns) != 1:
        raise Unknown("its color ramp does not divide it in two")
    above = found.above((turns[0] + 0.5) / STEPS)
    return above if opaque[-1] else above.inverted()
