# SPDX-License-Identifier: GPL-3.0-or-later
"""Styles and their JSON files, independent of bpy. The bundled files are in the folder `styles`, named after the style.
The other modules of this package represent styles in Blender: as node trees with properties and curves, as user files,
as assets.

The records (`Style`, `LineSet`, `Pen` and so on, available as names of this module), their validation and the file
format are defined by the core (native/fovea/style). A wrong type or value is rejected with a message that names it.
Unknown fields are preserved and written back; `remark` lists them, so that misspelled keys are noticed.
"""

import json
import os
from difflib import get_close_matches
from functools import lru_cache
from pathlib import Path

from .. import catalogue, line_files, native

_PACKAGE = Path(__file__).parents[1]
FOLDER, TEXTURES, PAPERS = _PACKAGE / "styles", _PACKAGE / "textures", _PACKAGE / "papers"
DEFAULT = "pen_and_ink"
MOST_TOLD = 8  # most unknown fields that `remark` names
MOST_WORDS = 500  # most characters of an error message, as files may contain anything

# Filters of a LineSet -> name of the switch that inverts each.
FILTERS = {"collection": "outside", "object": "other_objects", "material": "other_materials"}


class StyleError(ValueError):
    """An invalid style; the message is one sentence for its author, shortened and without unprintable characters."""

    def __init__(self, text):
        short = text if len(text) <= MOST_WORDS else f"{text[: MOST_WORDS - 100]} ... {text[-90:]}"
        super().__init__("".join(c if c.isprintable() else " " for c in short))


def __getattr__(name):
    """The core's style records and limits, as attributes of this module. native.Unavailable without the core."""
    if not name[0].isupper():  # lower case: modules of this package, which can be imported without the core
        raise AttributeError(name)
    return getattr(native.load().style, name)


def names():
    """Names of the bundled styles, the default first."""
    return sorted((path.stem for path in FOLDER.glob("*.json")), key=lambda name: (name != DEFAULT, name))


@lru_cache(maxsize=1)
def textures():
    """Names of the bundled pen textures; `solid` needs no file."""
    found = {"solid"} | {path.stem for path in TEXTURES.glob("*.png")}
    return tuple(sorted(found, key=lambda name: (name != "solid", name)))


@lru_cache(maxsize=1)
def papers():
    """Names of the bundled papers; `none` is smooth."""
    return ("none", *sorted(path.stem for path in PAPERS.glob("*.png")))


def load(name):
    """The bundled style of that name."""
    if name not in names():
        raise StyleError(f"there is no style '{name}'; there are: {', '.join(names())}")
    return read(FOLDER / f"{name}.json")


def named(words):
    """The bundled style of that name or, where words end in .json, the one in that file."""
    return read(words) if Path(words).suffix == ".json" else load(words)


def read(path):
    """The style in a file, which may be untrusted. StyleError if it cannot be read or is invalid."""
    try:
        data = native.load().style.file_bytes(os.fsencode(path))
    except ValueError as error:
        raise StyleError(f"the style {error}") from error
    try:
        return line_files.absolute(parse(data.decode("utf-8-sig")), Path(path).parent)
    except UnicodeDecodeError as error:
        raise StyleError(f"the style is not text in UTF-8: byte {error.start} is not") from error
    except StyleError:
        raise
    except ValueError as error:
        raise StyleError(str(error)) from error


def parse(text, _definitions=None):
    """A style from JSON. `_definitions` is ignored; older scripts pass the line definitions, which the core knows."""
    try:
        # Lone surrogates are encoded to invalid UTF-8, which the core rejects.
        return native.load().style.Style.read(text.encode("utf-8", "surrogatepass"), textures(), papers())
    except ValueError as error:
        raise StyleError(str(error)) from error


def dump(style):
    """The JSON of a style; `parse` gives the same style back."""
    return style.written()


def parameters(definition, values, where):
    """{parameter: value} of one line definition, validated. StyleError if invalid; `where`: its name in the message."""
    try:
        return native.load().style.parameters(definition, values, where)
    except ValueError as error:
        raise StyleError(str(error)) from error


def field(record, name):
    """The declaration of a member of one of the core's records: a dict, see native/bindings/bind_style.cpp."""
    return next(field for field in record.fields if field["name"] == name)


def check(record, name, value, where):
    """StyleError if a number is outside the range of a record's member; `where`: its name in the message."""
    declared = field(record, name)
    least, most = declared["min"], declared["max"]
    if not least <= value <= most:
        raise StyleError(f"{where} is {value:g}, outside {least:g} to {most:g}")


def unknown(style):
    """Dotted names of the unknown fields that are preserved."""
    return tuple(_dotted(path) for path, _ in style.kept)


def remark(style):
    """A sentence that lists a style's unknown fields, each with the most similar known name; None if there are none."""
    if not style.kept:
        return None
    plain, told = json.loads(dump(style.replace(kept=()))), []
    for *where, key in (path for path, _ in style.kept[:MOST_TOLD]):
        beside = set(_at(plain, where))
        if where[-1:] == ["kinds"]:
            beside |= set(catalogue.by_name())
        if where[-2:-1] == ["kinds"]:
            definition = catalogue.by_name()[where[-1]]
            beside |= {known["name"] for known in (*definition["parameters"], definition["file"]) if known}
        near = get_close_matches(key, sorted(beside), 1)
        told.append(_dotted((*where, key)) + (f" (is it {near[0]}?)" if near else ""))
    more = f" and {len(style.kept) - MOST_TOLD} more" if len(style.kept) > MOST_TOLD else ""
    return f"The style has fields that this version does not know and leaves alone: {', '.join(told)}{more}"


def _at(data, path):
    """The value at a path in nested data; () if it is empty or missing."""
    try:
        for step in path:
            data = data[step]
    except (KeyError, IndexError, TypeError):
        return ()
    return data or ()


def _dotted(path):
    """A path in dotted form: line_sets[0].pen.width."""
    return "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in path).removeprefix(".")


def dashed(pen):
    """A dashed pen derived from `pen`, thinner and fainter, for the hidden runs of its lines."""
    least = 0.1 if pen.width_unit == "millimetres" else 1.0
    shape = {"texture": "dashes", "length_scale": 1.5, "cap": "butt"}
    width = max(0.6 * pen.width, least)
    return __getattr__("Pen")(
        color=pen.color, opacity=0.75 * pen.opacity, width=width, width_unit=pen.width_unit, **shape
    )
