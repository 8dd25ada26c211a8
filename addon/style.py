"""A style as data: the paper and an ordered list of line sets, each with its lines, their parameters and a pen.

Styles are JSON files of the folder `styles`; the file's name is the style's. What does not belong is refused with a
sentence that names it, so that a misspelt key never changes a drawing silently.
"""

import json
from dataclasses import dataclass, field, fields, is_dataclass, replace
from pathlib import Path

from . import color, elision
from .color import Color
from .elision import Elision
from .focus import Distance, Effects, Focus, parse_distance, parse_effects, parse_focus
from .stages import Pen
from .style_values import RANGES, StyleError, check_keys, check_range, finite, record

SCHEMA = 1
FOLDER = Path(__file__).parent / "styles"
TEXTURES = Path(__file__).parent / "textures"
PAPERS = Path(__file__).parent / "papers"
DEFAULT = "pen_and_ink"

CAPS = ("round", "butt")
MOST_SURFACES = 100  # that a range of invisibility can name
UNCOUNTED = 255  # more surfaces than are ever counted


@dataclass(frozen=True)
class Paper:
    color: tuple = (1.0, 1.0, 1.0)  # scene-linear
    transparent: bool = False
    texture: str = "none"  # a file of addon/papers, without .png; none: smooth
    scale: float = 1.0  # reference pixels that a texel of the texture covers
    tooth: float = 0.0  # how far thin ink stays on the heights of the paper
    granulation: float = 0.0  # how much more pigment of the colour layer its valleys take
    tint: float = 0.0  # how much its relief shades the whole picture


@dataclass(frozen=True)
class Hidden:
    """How the parts of lines are drawn that at least `first` and at most `last` surfaces hide (None: any number)."""

    pen: Pen = Pen()
    first: int = 1
    last: int | None = None
    pen_away: Pen | None = None  # out of focus; None: as in focus


@dataclass(frozen=True)
class LineSet:
    """Lines drawn alike. An edge goes to the first set of the style that has a line for it."""

    name: str = "lines"
    kinds: dict = field(default_factory=dict)  # {definition id: {parameter: value}}, in the registry's units
    corner_angle: float = 60.0  # degrees of turn at which a path is split
    least_length: float = 30.0  # reference pixels; shorter lines with an end that touches no other are left out
    overshoot: float = 0.0  # reference pixels that visible parts go on beyond their ends
    halo: float = 0.0  # reference pixels of gap where visible parts pass behind others
    overshoot_away: float | None = None  # the same out of focus; None: as in focus
    pen: Pen = Pen()  # of visible parts
    pen_away: Pen | None = None  # of visible parts out of focus; None: as in focus
    hidden: tuple = ()  # of Hidden, ranges that do not overlap; parts in none of them are not drawn


@dataclass(frozen=True)
class Style:
    paper: Paper = Paper()
    line_sets: tuple = (LineSet(),)
    focus: Focus = Focus()
    effects: Effects = Effects()
    distance: Distance = Distance()
    color: Color = Color()
    elision: Elision = Elision()

    def has_color(self):
        """Whether there is a colour layer."""
        return self.color.shading != "plain" and self.effects.colors != "none"

    def pen_pairs(self):
        """(pen in focus, pen out of focus or None): those of visible parts by line set, then those of hidden parts."""
        visible = [(s.pen, s.pen_away) for s in self.line_sets]
        return visible + [(hidden.pen, hidden.pen_away) for s in self.line_sets for hidden in s.hidden]

    def pens(self):
        """All pens: those in focus as in `pen_pairs`, then those out of focus."""
        pairs = self.pen_pairs()
        return [pen for pen, _ in pairs] + [away for _, away in pairs if away]

    def away(self):
        """{index of a pen: index of the pen out of focus}, into `pens`."""
        pairs = self.pen_pairs()
        led = [i for i, (_, away) in enumerate(pairs) if away]
        return {pen: len(pairs) + k for k, pen in enumerate(led)}

    def has_away(self):
        """Whether lines out of focus are other than those in focus."""
        return bool(self.away()) or any(s.overshoot_away is not None for s in self.line_sets)

    def pen_ranges(self):
        """(line set, least and most surfaces that hide a part, index of its pen) for each of the pens."""
        rows = [(i, 0, 0) for i in range(len(self.line_sets))]
        rows += [(i, h.first, h.last or UNCOUNTED) for i, s in enumerate(self.line_sets) for h in s.hidden]
        return [(*row, pen) for pen, row in enumerate(rows)]

    def counted(self):
        """How many hiding surfaces the pens tell apart; more look like so many. 0: nothing hidden is drawn."""
        return max((h.last + 1 if h.last else h.first for s in self.line_sets for h in s.hidden), default=0)


def names():
    """The styles that ship, the default first."""
    return sorted((path.stem for path in FOLDER.glob("*.json")), key=lambda name: (name != DEFAULT, name))


def textures():
    """The pen textures that ship; `solid` needs no file."""
    return sorted({"solid"} | {path.stem for path in TEXTURES.glob("*.png")}, key=lambda name: (name != "solid", name))


def papers():
    """The papers that ship; `none` is smooth."""
    return ["none", *sorted(path.stem for path in PAPERS.glob("*.png"))]


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
    check_keys(data, {"schema", "paper", "color", "elision", "focus", "effects", "distance", "line_sets"}, "the style")
    if data.get("schema") != SCHEMA:
        raise StyleError(f"the style has schema {data.get('schema')!r}, this version of Fovea reads {SCHEMA}")
    sets = data.get("line_sets", [])
    if not isinstance(sets, list) or not sets:
        raise StyleError("line_sets must be a list of at least one line set")
    return Style(
        paper=_paper(data.get("paper", {}), "paper"),
        line_sets=tuple(_line_set(entry, f"line_sets[{i}]", definitions) for i, entry in enumerate(sets)),
        focus=parse_focus(data.get("focus", {}), "focus"),
        effects=parse_effects(data.get("effects", {}), "effects"),
        distance=parse_distance(data.get("distance", {}), "distance"),
        color=color.parse(data.get("color", {}), "color"),
        elision=elision.parse(data.get("elision", {}), "elision"),
    )


def dump(style):
    """The JSON of a style; `parse` gives the same style back."""
    return json.dumps({"schema": SCHEMA, **_plain(style)}, indent=2) + "\n"


def _plain(value):
    """A style or a part of it as JSON has it."""
    if isinstance(value, Hidden):
        return {"from": value.first, "to": value.last, "pen": _plain(value.pen), "pen_away": _plain(value.pen_away)}
    if is_dataclass(value):
        return {f.name: _plain(getattr(value, f.name)) for f in fields(value)}
    return [_plain(part) for part in value] if isinstance(value, tuple) else value


def dashed(pen):
    """A pen for hidden parts of the lines that `pen` draws."""
    thinner = max(0.6 * pen.width, 1.0)
    return Pen(pen.color, 0.75 * pen.opacity, thinner, texture="dashes", length_scale=1.5, cap="butt")


def _line_set(data, where, definitions):
    check_keys(data, {f.name for f in fields(LineSet)}, where)
    own = ("kinds", "pen", "pen_away", "hidden", "overshoot_away")
    plain = {key: value for key, value in data.items() if key not in own}
    kinds = data.get("kinds", {})
    if not isinstance(kinds, dict):
        raise StyleError(f"{where}.kinds must map lines to their parameters")
    checked = {name: parameters(name, values, f"{where}.kinds", definitions) for name, values in kinds.items()}
    pen, hidden = _pen(data.get("pen", {}), f"{where}.pen"), _hidden(data.get("hidden", []), f"{where}.hidden")
    away, overshoot = _pen_away(data, pen, where), data.get("overshoot_away")
    if overshoot is not None:
        overshoot = check_range(overshoot, RANGES["overshoot"], f"{where}.overshoot_away")
    checked_set = record(LineSet, plain, where)
    return replace(checked_set, kinds=checked, pen=pen, pen_away=away, hidden=hidden, overshoot_away=overshoot)


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
    if pen.cap not in CAPS:
        raise StyleError(f"{where}.cap is '{pen.cap}'; it can be: {', '.join(CAPS)}")
    if pen.texture not in textures():
        raise StyleError(f"{where}.texture is '{pen.texture}'; there are: {', '.join(textures())}")
    return pen


def _hidden(data, where):
    """The pens of a line set's hidden parts, in the order of their ranges."""
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
    found.sort(key=lambda hidden: hidden.first)
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
