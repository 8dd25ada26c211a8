# SPDX-License-Identifier: GPL-3.0-or-later
"""The passes of final renders besides Combined: their names, channels and switches, and what fills them.

Names are those of sockets of the compositor and of layers of OpenEXR files: ASCII letters, digits, - and _ alone, as
Blender divides channels at dots.
"""

import json
import re
import unicodedata
import zlib
from dataclasses import dataclass

import bpy
import numpy as np

from ..scene.property_kinds import new_group, pointer, switch

_MOST_LETTERS = 32  # of a line set's name in its pass's: Blender's names of passes end at 63, with view and channel


@dataclass(frozen=True)
class Pass:
    """One pass, or several alike: one per line set or per two ranks of a Cryptomatte."""

    name: str  # of several: how their names begin
    channels: str  # one letter each, as Blender writes them to files
    image: str  # the member of stages.Image that fills it: pixels, {name of a line set: pixels} or [pixels]
    label: str
    description: str
    switch: str = ""  # property of view layers; "": always on
    option: str = ""  # member of the native Options that requests it
    content: object = None  # content(Style): whether there is any; None: always
    lacking: str = ""  # why renders do not have it then
    below: bool = False  # of what lies below the lines: scenes that draw lines alone have none

    @property
    def kind(self):
        """As what Blender's compositor has it."""
        return {"X": "VALUE", "Z": "VALUE", "XYZW": "VECTOR"}.get(self.channels, "COLOR")

    def is_on(self, layer):
        return not self.switch or layer.path_resolve(self.switch)

    def names(self, layer, line_sets):
        """Names of its passes, if it is on. `line_sets`: names of line sets."""
        if self.image == "line_sets":
            return list(names_of_line_sets(line_sets).values())
        return [f"{self.name}{i:02d}" for i in range(_pairs(layer))] if self.image == "mattes" else [self.name]


PASSES = (
    Pass("Lines", "RGBA", "lines", "Lines", "All lines, over nothing"),
    Pass(
        "LinesHidden",
        "RGBA",
        "hidden_lines",
        "Hidden Lines",
        "Lines that surfaces hide, as far as line sets have pens for them",
        switch="fovea.hidden_lines",
        option="with_hidden",
    ),
    Pass(
        "Lines_",
        "RGBA",
        "line_sets",
        "Line Sets",
        "A pass for each line set, with its visible lines. One over the other, in the order of the list, and over "
        "LinesHidden, they make Lines",
        switch="fovea.line_sets",
        option="with_line_sets",
    ),
    Pass(
        "LineDepth",
        "Z",
        "line_depth",
        "Line Depth",
        "Distance of the nearest line at each pixel, along the view axis",
        switch="fovea.line_depth",
        option="with_line_depth",
    ),
    Pass(
        "LineVector",
        "XYZW",
        "line_vector",
        "Line Vector",
        "How the nearest line at each pixel moves from the frame before and to the next one, for Vector Blur",
        switch="fovea.line_vector",
        option="with_line_vector",
    ),
    Pass(
        "LineId",
        "X",
        "line_id",
        "Line Id",
        "A whole number for each line, 0 where there is none",
        switch="fovea.line_id",
        option="with_line_id",
    ),
    Pass(
        "Color",
        "RGBA",
        "color",
        "Color",
        "What lies under the lines, without the paper",
        content=lambda style: style.has_color(),
        lacking="the style has no color layer",
        below=True,
    ),
    Pass(
        "Focus",
        "X",
        "focus",
        "Focus",
        "How far each pixel is out of focus: 0 is in focus, 1 is not",
        content=lambda style: style.focus.active(),
        lacking="there is no place to look at",
        below=True,
    ),
    Pass(
        "Depth",
        "Z",
        "depth",
        "Depth",
        "Distance of the surface at each pixel, along the view axis",
        switch="use_pass_z",
        option="with_depth",
        below=True,
    ),
    Pass(
        "CryptoObject",
        "rgba",  # as those of Cycles: no program may compress them with loss
        "mattes",
        "Cryptomatte of Objects",
        "Mattes of each object's lines, for Blender's Cryptomatte node and other programs",
        switch="use_pass_cryptomatte_object",
        option="matte_ranks",
    ),
)


COMBINED = "RGBA"  # channels of the picture itself


def _pairs(layer):
    return (min(layer.pass_cryptomatte_depth, 16) + 1) // 2


def options(layer, lines_alone=False):
    """The native Options that request the passes of a view layer. `lines_alone`: only those of lines."""
    on = {each.option: each.is_on(layer) and not (lines_alone and each.below) for each in PASSES if each.option}
    return on | {"with_focus": not lines_alone, "matte_ranks": 2 * _pairs(layer) * on["matte_ranks"]}


def wanted(layer, style, line_sets, lines_alone=False):
    """{Pass: names of its passes in renders of a view layer}, [] if it has none. `style`: the Style, or None if it
    cannot be drawn; `line_sets`: names of its line sets; `lines_alone`: only passes of lines."""

    def has(each):
        content = each.content is None or bool(style and each.content(style))
        return each.is_on(layer) and content and not (lines_alone and each.below)

    return {each: each.names(layer, line_sets) if has(each) else [] for each in PASSES}


def filled(image, layer, line_sets):
    """{name: (channels, pixels)} of all passes of a stages.Image. A line set that is not drawn in this frame has an
    empty pass."""
    passes = {"Combined": (COMBINED, image.combined)}
    for each in PASSES:
        found = getattr(image, each.image)
        if each.image == "line_sets":
            names = names_of_line_sets(line_sets) if each.is_on(layer) else {}
            made = {name: found[of] if of in found else np.zeros_like(image.combined) for of, name in names.items()}
        elif each.image == "mattes":
            made = dict(zip(each.names(layer, line_sets), found))
        else:
            made = {each.name: found}
        passes |= {name: (each.channels, pixels) for name, pixels in made.items() if pixels is not None}
    return passes


def names_of_line_sets(names):
    """{name of a line set: name of its pass}: without accents, with _ for what is no letter or digit. Other letters,
    and names that are too long, are replaced by a checksum; those that become equal are numbered."""
    found = {}
    for name in dict.fromkeys(names):
        letters = "".join(c for c in unicodedata.normalize("NFKD", name) if not unicodedata.combining(c))
        plain = re.sub(r"[^A-Za-z0-9-]+", "_", letters).strip("_")
        if not (letters.isascii() and 0 < len(plain) <= _MOST_LETTERS):
            plain = f"{plain[:_MOST_LETTERS]}_{zlib.crc32(name.encode()):08x}".strip("_")
        numbers = (f"Lines_{plain}" + (f"_{n}" if n > 1 else "") for n in range(1, len(found) + 2))
        found[name] = next(numbered for numbered in numbers if numbered not in found.values())
    return found


def tell_names(engine, layer, objects, core):
    """Adds the names of objects that a Cryptomatte may tell apart to the metadata of the engine's result. `core`: the
    native module."""
    (matte,) = (each for each in PASSES if each.image == "mattes")
    of = f"{layer.name}.{matte.name}"
    manifest = {name: f"{core.cryptomatte_id(name):08x}" for name in sorted(objects)}
    told = {
        "name": of,
        "hash": "MurmurHash3_32",
        "conversion": "uint32_to_float32",
        "manifest": json.dumps(manifest, ensure_ascii=False, separators=(",", ":")),
    }
    for key, value in told.items():
        engine.get_result().stamp_data_add_field(f"cryptomatte/{core.murmur_hash(of):08x}"[:-1] + f"/{key}", value)


def renew_sockets():
    """Gives nodes of compositors the sockets of the passes that there are now. In all scenes, as the nodes of one may
    read another."""
    for scene in bpy.data.scenes:
        for layer in scene.view_layers:
            layer.update_render_passes()


def layer_group():
    """The PropertyGroup of view layers' own switches."""
    own = {each.image: each for each in PASSES if each.switch == f"fovea.{each.image}"}
    renewing = {"update": lambda _settings, _context: renew_sockets()}
    switches = {name: switch(each.label, each.description, **renewing) for name, each in own.items()}
    told = "The scene that draws this view layer's lines over what another engine renders"
    lines = pointer("Lines", told, type=bpy.types.Scene, options={"HIDDEN"})
    return new_group("FoveaViewLayerSettings", "Which passes and lines a view layer has.", {**switches, "lines": lines})
