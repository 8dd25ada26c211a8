# SPDX-License-Identifier: GPL-3.0-or-later
"""Styles as JSON: files of the folder `styles`, each named as its style; what a style is made of: style_parts.py.

What has a wrong type or value is refused with a sentence that names it. What this version does not know is kept, and
written again; `remark` says what it is, so that a misspelt key does not go unnoticed.
"""

import json
from dataclasses import fields, is_dataclass, replace
from difflib import get_close_matches
from functools import lru_cache
from pathlib import Path

from . import color, elision, style_json
from .focus import MOST_NAME, parse_distance, parse_effects, parse_focus
from .stages import Pen
from .style_parts import FILTERS, Hidden, LineSet, Paper, Style
from .style_values import MOST_SURFACES, RANGES, StyleError, check_keys, check_range, check_text, finite, one_of, record

SCHEMA = 1
FOLDER = Path(__file__).parent / "styles"
TEXTURES = Path(__file__).parent / "textures"
PAPERS = Path(__file__).parent / "papers"
DEFAULT = "pen_and_ink"

CHOICES = {  # field of a pen: what it can be
    "cap": ("round", "butt"),
    "width_unit": ("reference", "pixels", "millimetres"),
    "texture_anchor": ("screen", "path"),
}
MOST_TOLD = 8  # unknown fields that are named
PARTS = ("schema", "paper", "color", "elision", "focus", "effects", "distance", "line_sets")


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


def load(name, definitions=None):
    """The style of that name; `definitions` as in `parse`."""
    if name not in names():
        raise StyleError(f"there is no style '{name}'; there are: {', '.join(names())}")
    return read(FOLDER / f"{name}.json", definitions)


def read(path, definitions=None):
    """The style in a file, which may be anyone's."""
    return parse(style_json.read(path), definitions)


def parse(text, definitions=None):
    """A style from JSON. `definitions`: those of the catalogue, to check lines and parameters against, or None."""
    data = style_json.parse(text)
    check_keys(data, PARTS, "the style")
    _check_schema(data.get("schema"))
    sets = data.get("line_sets", [])
    if not isinstance(sets, list) or not sets:
        raise StyleError("line_sets must be a list of at least one line set")
    found = Style(
        paper=_paper(data.get("paper", {}), "paper"),
        line_sets=tuple(_line_set(entry, f"line_sets[{i}]", definitions) for i, entry in enumerate(sets)),
        focus=parse_focus(data.get("focus", {}), "focus"),
        effects=parse_effects(data.get("effects", {}), "effects"),
        distance=parse_distance(data.get("distance", {}), "distance"),
        color=color.parse(data.get("color", {}), "color"),
        elision=elision.parse(data.get("elision", {}), "elision"),
    )
    return replace(found, kept=tuple(style_json.unknown(data)))


def _check_schema(schema):
    if isinstance(schema, bool) or not isinstance(schema, int) or schema < 1:
        raise StyleError(f"schema is {schema!r}, not the number of a schema: 1 to {SCHEMA}")
    if schema > SCHEMA:
        raise StyleError(f"schema is {schema}: a newer version of Fovea wrote the style, this one reads up to {SCHEMA}")


def dump(style):
    """The JSON of a style; `parse` gives the same style back."""
    data = {"schema": SCHEMA, **_plain(style)}
    for path, value in style.kept:
        style_json.put(data, path, value)
    return json.dumps(data, indent=2) + "\n"


def remark(style, definitions=()):
    """A sentence about what a style has that is not known, each with the known name it resembles; None: nothing."""
    if not style.kept:
        return None
    plain, told = _plain(style), []
    for *where, key in (path for path, _ in style.kept[:MOST_TOLD]):
        beside = set(style_json.at(plain, where) or ())
        if where[-1:] == ["kinds"]:
            beside |= {definition["name"] for definition in definitions}
        if where[-2:-1] == ["kinds"]:
            beside |= {p["name"] for d in definitions if d["name"] == where[-1] for p in d["parameters"]}
        near = get_close_matches(key, sorted(beside), 1)
        told.append(style_json.dotted((*where, key)) + (f" (is it {near[0]}?)" if near else ""))
    more = f" and {len(style.kept) - MOST_TOLD} more" if len(style.kept) > MOST_TOLD else ""
    return f"The style has fields that this version does not know and leaves alone: {', '.join(told)}{more}"


def _plain(value):
    """A style or a part of it as JSON has it."""
    if isinstance(value, Hidden):
        return {"from": value.first, "to": value.last, "pen": _plain(value.pen), "pen_away": _plain(value.pen_away)}
    if is_dataclass(value):
        return {f.name: _plain(getattr(value, f.name)) for f in fields(value) if f.name != "kept"}
    if isinstance(value, dict):
        return {key: _plain(part) for key, part in value.items()}
    return [_plain(part) for part in value] if isinstance(value, tuple) else value


def dashed(pen):
    """A pen for hidden parts of the lines that `pen` draws."""
    least = 0.1 if pen.width_unit == "millimetres" else 1.0
    shape = {"texture": "dashes", "length_scale": 1.5, "cap": "butt"}
    return Pen(pen.color, 0.75 * pen.opacity, max(0.6 * pen.width, least), width_unit=pen.width_unit, **shape)


def _line_set(data, where, definitions):
    check_keys(data, {f.name for f in fields(LineSet)}, where)
    own = ("kinds", *FILTERS, "pen", "pen_away", "hidden", "overshoot_away")
    plain = {key: value for key, value in data.items() if key not in own}
    kinds = data.get("kinds", {})
    if not isinstance(kinds, dict):
        raise StyleError(f"{where}.kinds must map lines to their parameters")
    if definitions is not None:
        check_keys(kinds, [definition["name"] for definition in definitions], f"{where}.kinds")
    checked = {name: parameters(name, values, f"{where}.kinds", definitions) for name, values in kinds.items()}
    pen, hidden = _pen(data.get("pen", {}), f"{where}.pen"), _hidden(data.get("hidden", []), f"{where}.hidden")
    away, overshoot = _pen_away(data, pen, where), data.get("overshoot_away")
    if overshoot is not None:
        overshoot = check_range(overshoot, RANGES["overshoot"], f"{where}.overshoot_away")
    checked_set = record(LineSet, plain, where)
    names = {key: check_text(data.get(key, ""), f"{where}.{key}", MOST_NAME) for key in FILTERS}
    found = {"kinds": checked, "hidden": hidden, "overshoot_away": overshoot, **names}
    return replace(checked_set, pen=pen, pen_away=away, **found)


def _pen_away(data, pen, where):
    """The pen out of focus: as the one in focus but for what is given; None where nothing is."""
    given = data.get("pen_away")
    if given is None:
        return None
    check_keys(given, {f.name for f in fields(Pen)}, f"{where}.pen_away")
    return _pen(_plain(pen) | given, f"{where}.pen_away")


def _paper(data, where):
    paper = record(Paper, data, where)
    if paper.texture not in papers():
        raise StyleError(f"{where}.texture is '{paper.texture}'; there are: {', '.join(papers())}")
    return paper


def _pen(data, where):
    pen = record(Pen, data, where)
    for name, known in CHOICES.items():
        one_of(getattr(pen, name), known, f"{where}.{name}")
    if pen.texture not in textures():
        raise StyleError(f"{where}.texture is '{pen.texture}'; there are: {', '.join(textures())}")
    return pen


def _hidden(data, where):
    """The pens of a line set's hidden parts, in the order of their ranges, into which `data` is brought, too."""
    if not isinstance(data, list):
        raise StyleError(f"{where} must be a list of pens with ranges of invisibility")
    found = []
    for i, entry in enumerate(data):
        here = f"{where}[{i}]"
        check_keys(entry, {"from", "to", "pen", "pen_away"}, here)
        first, last = _surfaces(entry.get("from", 1), f"{here}.from"), entry.get("to")
        if last is not None and _surfaces(last, f"{here}.to") < first:
            raise StyleError(f"{here}.to is {last}, less than {here}.from, which is {first}")
        pen = _pen(entry.get("pen", {}), f"{here}.pen")
        found.append(Hidden(pen, first, last, _pen_away(entry, pen, here)))
    order = sorted(range(len(found)), key=lambda i: found[i].first)
    found, data[:] = [found[i] for i in order], [data[i] for i in order]
    for before, after in zip(found, found[1:]):
        if before.last is None or before.last >= after.first:
            raise StyleError(f"{where}: two ranges hold what {after.first} surfaces hide")
    return tuple(found)


def _surfaces(value, where):
    if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= MOST_SURFACES:
        raise StyleError(f"{where} is {value!r}, not a number of surfaces from 1 to {MOST_SURFACES}")
    return value


def parameters(name, values, where, definitions):
    """The parameters given for one line definition, checked, as floats; switches may be true and false."""
    if not isinstance(values, dict):
        raise StyleError(f"{where}.{name} must map parameters to numbers")
    known = None
    if definitions is not None:
        parameters_of = {d["name"]: {p["name"]: p for p in d["parameters"]} for d in definitions}
        if name not in parameters_of:
            raise StyleError(f"{where}: there is no line '{name}'; there are: {', '.join(parameters_of)}")
        known = parameters_of[name]
        check_keys(values, known, f"{where}.{name}")
    return {key: _parameter(value, known and known[key], f"{where}.{name}.{key}") for key, value in values.items()}


def _parameter(value, known, where):
    if isinstance(value, bool) and (known is None or known["unit"] == "bool"):
        return float(value)
    return check_range(value, (known["min"], known["max"]), where) if known else finite(value, where)
