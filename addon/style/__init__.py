# SPDX-License-Identifier: GPL-3.0-or-later
"""Styles and their files, without Blender: JSON of the folder `styles`, each named as its style. The other modules of
this folder hold styles in Blender: as node trees with properties and curves, as files of the user, as assets.

What a style is made of, what each part may be and how files are read and written is the core's (native/fovea/style):
`Style`, `LineSet`, `Pen` and the other records are names of this module. What has a wrong type or value is refused with
a sentence that names it. What this version does not know is kept, and written again; `remark` says what it is, so that
a misspelt key does not go unnoticed.
"""

import json
from difflib import get_close_matches
from functools import lru_cache
from pathlib import Path

from .. import catalogue, native

_PACKAGE = Path(__file__).parents[1]
FOLDER, TEXTURES, PAPERS = _PACKAGE / "styles", _PACKAGE / "textures", _PACKAGE / "papers"
DEFAULT = "pen_and_ink"
LARGEST = 1 << 20  # bytes that are read of a file: the core takes no more
MOST_TOLD = 8  # unknown fields that are named
MOST_WORDS = 500  # characters of what is told about a style: files may hold anything

# Of a LineSet: what each is called where it is turned round.
FILTERS = {"collection": "outside", "object": "other_objects", "material": "other_materials"}


class StyleError(ValueError):
    """What is wrong with a style, in one sentence for its author."""

    def __init__(self, text):
        short = text if len(text) <= MOST_WORDS else f"{text[: MOST_WORDS - 100]} ... {text[-90:]}"
        super().__init__("".join(c if c.isprintable() else " " for c in short))


def __getattr__(name):
    """The core's records of styles, and its limits. native.Unavailable where there is no core."""
    if not name[0].isupper():  # as the modules of this folder, which need no core to be imported
        raise AttributeError(name)
    return getattr(native.load().style, name)


def names():
    """The styles that ship, the default first."""
    return sorted((path.stem for path in FOLDER.glob("*.json")), key=lambda name: (name != DEFAULT, name))


@lru_cache(maxsize=1)
def textures():
    """The pen textures that ship; `solid` needs no file."""
    found = {"solid"} | {path.stem for path in TEXTURES.glob("*.png")}
    return tuple(sorted(found, key=lambda name: (name != "solid", name)))


@lru_cache(maxsize=1)
def papers():
    """The papers that ship; `none` is smooth."""
    return ("none", *sorted(path.stem for path in PAPERS.glob("*.png")))


def load(name):
    """The style of that name."""
    if name not in names():
        raise StyleError(f"there is no style '{name}'; there are: {', '.join(names())}")
    return read(FOLDER / f"{name}.json")


def read(path):
    """The style in a file, which may be anyone's."""
    try:
        with open(path, "rb") as file:
            data = file.read(LARGEST + 4)  # a byte order mark does not count
    except (OSError, ValueError) as error:
        raise StyleError(f"the style {str(path)!r} cannot be read: {error}") from error
    try:
        return parse(data.decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        if len(data) > LARGEST:
            raise StyleError("the style has more than 1 MB: that is no style") from error
        raise StyleError(f"the style is not text in UTF-8: byte {error.start} is not") from error


def parse(text, _definitions=None):
    """A style from JSON. What older scripts say beside it, which line definitions there are, is known to the core."""
    try:
        # Half a character is no UTF-8, and refused as such.
        return native.load().style.Style.read(text.encode("utf-8", "surrogatepass"), textures(), papers())
    except ValueError as error:
        raise StyleError(str(error)) from error


def dump(style):
    """The JSON of a style; `parse` gives the same style back."""
    return style.written()


def parameters(definition, values, where):
    """{parameter: value} of one line definition, checked. StyleError says what is wrong; `where` is what it calls it."""
    try:
        return native.load().style.parameters(definition, values, where)
    except ValueError as error:
        raise StyleError(str(error)) from error


def field(record, name):
    """What is declared of a member of one of the core's records: a dict, see native/bindings/bind_style.cpp."""
    return next(field for field in record.fields if field["name"] == name)


def check(record, name, value, where):
    """StyleError where a number cannot be that of a member of one of the core's records; `where` is what it is called."""
    declared = field(record, name)
    least, most = declared["min"], declared["max"]
    if not least <= value <= most:
        raise StyleError(f"{where} is {value:g}, outside {least:g} to {most:g}")


def unknown(style):
    """The dotted names of what is kept without being known."""
    return tuple(_dotted(path) for path, _ in style.kept)


def remark(style):
    """A sentence about what a style has that is not known, each with the known name it resembles; None: nothing."""
    if not style.kept:
        return None
    plain, told = json.loads(dump(style.replace(kept=()))), []
    for *where, key in (path for path, _ in style.kept[:MOST_TOLD]):
        beside = set(_at(plain, where))
        if where[-1:] == ["kinds"]:
            beside |= set(catalogue.by_name())
        if where[-2:-1] == ["kinds"]:
            beside |= {parameter["name"] for parameter in catalogue.by_name()[where[-1]]["parameters"]}
        near = get_close_matches(key, sorted(beside), 1)
        told.append(_dotted((*where, key)) + (f" (is it {near[0]}?)" if near else ""))
    more = f" and {len(style.kept) - MOST_TOLD} more" if len(style.kept) > MOST_TOLD else ""
    return f"The style has fields that this version does not know and leaves alone: {', '.join(told)}{more}"


def _at(data, path):
    """What is at a path, or nothing."""
    try:
        for step in path:
            data = data[step]
    except (KeyError, IndexError, TypeError):
        return ()
    return data or ()


def _dotted(path):
    """A path as a reader of the file would write it: line_sets[0].pen.width."""
    return "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in path).removeprefix(".")


def dashed(pen):
    """A pen for hidden parts of the lines that `pen` draws."""
    least = 0.1 if pen.width_unit == "millimetres" else 1.0
    shape = {"texture": "dashes", "length_scale": 1.5, "cap": "butt"}
    width = max(0.6 * pen.width, least)
    return __getattr__("Pen")(
        color=pen.color, opacity=0.75 * pen.opacity, width=width, width_unit=pen.width_unit, **shape
    )
