"""A style as data: the paper and an ordered list of line sets, each with its lines, their parameters and a pen.

Styles are JSON files of the folder `styles`; the file's name is the style's. What does not belong is refused with a
sentence that names it, so that a misspelt key never changes a drawing silently.
"""

import json
import math
import re
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path

from .stages import Pen

SCHEMA = 1
FOLDER = Path(__file__).parent / "styles"
TEXTURES = Path(__file__).parent / "textures"
DEFAULT = "ink"

RANGES = {
    "opacity": (0, 1),
    "width": (0.1, 1000),
    "length_scale": (0.01, 100),
    "taper": (0, 10000),
    "strength_width": (0, 1),
    "corner_angle": (0, 180),
    "least_length": (0, 10000),
}
CAPS = ("round", "butt")


class StyleError(ValueError):
    """What is wrong with a style, in words for its author."""


@dataclass(frozen=True)
class Paper:
    color: tuple = (1.0, 1.0, 1.0)  # scene-linear
    transparent: bool = False


@dataclass(frozen=True)
class LineSet:
    """Lines drawn alike. An edge goes to the first set of the style that has a line for it."""

    name: str = "lines"
    kinds: dict = field(default_factory=dict)  # {definition id: {parameter: value}}, in the registry's units
    corner_angle: float = 60.0  # degrees of turn at which a path is split
    least_length: float = 30.0  # reference pixels; shorter lines with an end that touches no other are left out
    pen: Pen = Pen()


@dataclass(frozen=True)
class Style:
    paper: Paper = Paper()
    line_sets: tuple = (LineSet(),)


def names():
    """The styles that ship, the default first."""
    return sorted((path.stem for path in FOLDER.glob("*.json")), key=lambda name: (name != DEFAULT, name))


def textures():
    """The pen textures that ship; `solid` needs no file."""
    return sorted({"solid"} | {path.stem for path in TEXTURES.glob("*.png")}, key=lambda name: (name != "solid", name))


def load(name, definitions=None):
    """The style of that name; `definitions` as in `parse`."""
    if name not in names():
        raise StyleError(f"there is no style '{name}'; there are: {', '.join(names())}")
    return parse((FOLDER / f"{name}.json").read_text(encoding="utf-8"), definitions)


def parse(text, definitions=None):
    """A style from JSON. `definitions`: those of the catalogue, to check lines and parameters against, or None."""
    try:
        data = json.loads(text)
    except json.JSONDecodeError as error:
        raise StyleError(f"the style is not JSON: {error}") from error
    _check_keys(data, {"schema", "paper", "line_sets"}, "the style")
    if data.get("schema") != SCHEMA:
        raise StyleError(f"the style has schema {data.get('schema')!r}, this version of Fovea reads {SCHEMA}")
    sets = data.get("line_sets", [])
    if not isinstance(sets, list) or not sets:
        raise StyleError("line_sets must be a list of at least one line set")
    return Style(
        paper=_record(Paper, data.get("paper", {}), "paper"),
        line_sets=tuple(_line_set(entry, f"line_sets[{i}]", definitions) for i, entry in enumerate(sets)),
    )


def dump(style):
    """The JSON of a style; `parse` gives the same style back."""
    return json.dumps({"schema": SCHEMA, **asdict(style)}, indent=2) + "\n"


def _line_set(data, where, definitions):
    _check_keys(data, {f.name for f in fields(LineSet)}, where)
    plain = {key: value for key, value in data.items() if key not in ("kinds", "pen")}
    kinds = data.get("kinds", {})
    if not isinstance(kinds, dict):
        raise StyleError(f"{where}.kinds must map lines to their parameters")
    pen = _record(Pen, data.get("pen", {}), f"{where}.pen")
    if pen.cap not in CAPS:
        raise StyleError(f"{where}.pen.cap is '{pen.cap}'; it can be: {', '.join(CAPS)}")
    if pen.texture not in textures():
        raise StyleError(f"{where}.pen.texture is '{pen.texture}'; there are: {', '.join(textures())}")
    checked = {name: parameters(name, values, f"{where}.kinds", definitions) for name, values in kinds.items()}
    return replace(_record(LineSet, plain, where), kinds=checked, pen=pen)


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
        _check_keys(values, known, f"{where}.{name}")
    return {key: _parameter(value, known and known[key], f"{where}.{name}.{key}") for key, value in values.items()}


def _parameter(value, known, where):
    if isinstance(value, bool) and (known is None or known["unit"] == "bool"):
        return float(value)
    return _check_range(value, (known["min"], known["max"]), where) if known else _number(value, where)


def _record(cls, data, where):
    """An instance of a flat dataclass; every value must be of the type of the field's default."""
    _check_keys(data, {f.name for f in fields(cls)}, where)
    defaults = cls()
    return cls(**{key: _value(value, getattr(defaults, key), key, f"{where}.{key}") for key, value in data.items()})


def _value(value, default, key, where):
    if isinstance(default, bool) or isinstance(default, str):
        if not isinstance(value, type(default)):
            raise StyleError(f"{where} must be {'true or false' if isinstance(default, bool) else 'text'}")
        # Names end up as file names here and elsewhere: none may lead out of its folder.
        if isinstance(value, str) and key != "name" and not re.fullmatch(r"[\w-]+", value):
            raise StyleError(f"{where} is {value!r}; only letters, digits, _ and - are allowed")
        return value
    if isinstance(default, tuple):
        if not isinstance(value, (list, tuple)) or len(value) != len(default):
            raise StyleError(f"{where} must be a list of {len(default)} numbers")
        return tuple(_check_range(v, (0, math.inf), where) for v in value)
    return _check_range(value, RANGES[key], where)


def _number(value, where):
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise StyleError(f"{where} is {value!r}, not a finite number")
    return float(value)


def _check_range(value, limits, where):
    number = _number(value, where)
    if not limits[0] <= number <= limits[1]:
        raise StyleError(f"{where} is {number:g}, outside {limits[0]:g} to {limits[1]:g}")
    return number


def _check_keys(data, known, where):
    if not isinstance(data, dict):
        raise StyleError(f"{where} must be a JSON object")
    unknown = sorted(set(data) - set(known))
    if unknown:
        raise StyleError(f"{where} has unknown keys: {', '.join(unknown)}; known are: {', '.join(sorted(known)) or 'none'}")
