# SPDX-License-Identifier: GPL-3.0-or-later
"""Focus and what answers to it, as data: where the viewer shall look, and a transfer function per effect.

Focus f is 0 where the viewer shall look and 1 far from there; see native/fovea/focus/focus.h and transfer.h. Line effects lead
from each pen to the one that is given for lines out of focus, colour effects from nothing to all of the effect.
"""

from dataclasses import dataclass

from .style_values import RANGES, StyleError, check_keys, check_range, check_text, one_of, record

MODELS = ("none", "image", "scene", "object", "painted")
COMBINATIONS = ("nearest", "sum")
MODES = ("emphasized", "uniform", "none")
MOST_POINTS = 16
MOST_CURVE_POINTS = 32
MOST_NAME = 255  # letters in the name of an object


@dataclass(frozen=True)
class Transfer:
    """Mix of an effect: 0 where f is at most `start`, `strength` from `end` on, a curve of (x, y) between; start beyond
    end turns it round."""

    start: float = 0.0
    end: float = 1.0
    strength: float = 1.0
    curve: tuple = ()  # of (x, y) in [0, 1], x ascending; none: straight


OFF = Transfer(strength=0.0)


@dataclass(frozen=True)
class Effects:
    """One transfer function per effect."""

    color: Transfer = Transfer()  # of lines, as the five below: to the pen out of focus
    texture: Transfer = Transfer()
    width: Transfer = Transfer()
    opacity: Transfer = Transfer()
    density: Transfer = Transfer()
    overshoot: Transfer = Transfer()
    desaturation: Transfer = OFF  # of the colour under the lines: amount
    fade: Transfer = OFF
    blur: Transfer = OFF
    lines: str = "emphasized"  # uniform: all lines as at one f; none: no lines
    colors: str = "emphasized"
    uniform: float = 0.5  # that f
    blur_radius: float = 12.0  # reference pixels at full blur


@dataclass(frozen=True)
class Distance:
    """Distance from the camera drives width, opacity and density as focus does, and together with it."""

    near: float = 0.0  # along the view, in units of the scene
    far: float = 100.0
    width: Transfer = OFF
    opacity: Transfer = OFF
    density: Transfer = OFF


@dataclass(frozen=True)
class Point:
    """A place to look at."""

    # In the image: 0..1 from the left and from the top, of the whole frame. In the scene: world coordinates.
    at: tuple = (0.5, 0.5, 0.0)
    near: float = 0.1  # in focus up to here; in the image in heights of the frame, in the scene in its units
    far: float = 0.5  # out of focus from here on
    object: str = ""  # in the model `object`: whose surface is the place; `at` where it has none


@dataclass(frozen=True)
class Focus:
    """Where the viewer shall look."""

    model: str = "none"
    points: tuple = (Point(),)
    combine: str = "nearest"  # or sum
    attribute: str = ""  # in the model `painted`: of meshes; 1 is in focus, 0 out of it, and .5 where there is none

    def active(self):
        if self.model == "painted":
            return bool(self.attribute)
        return self.model != "none" and bool(self.points)


def parse_focus(data, where):
    check_keys(data, {"model", "points", "combine", "attribute"}, where)
    points = data.get("points", [{}])
    if not isinstance(points, list) or len(points) > MOST_POINTS:
        raise StyleError(f"{where}.points must be a list of at most {MOST_POINTS} points")
    found = Focus(
        one_of(data.get("model", "none"), MODELS, f"{where}.model"),
        tuple(_point(point, f"{where}.points[{i}]") for i, point in enumerate(points)),
        one_of(data.get("combine", "nearest"), COMBINATIONS, f"{where}.combine"),
        check_text(data.get("attribute", ""), f"{where}.attribute"),
    )
    if found.model == "painted" and not found.attribute:
        raise StyleError(f"{where}.attribute must name what is painted")
    return found


def parse_effects(data, where):
    return _with_transfers(Effects, data, where, {"lines": MODES, "colors": MODES})


def parse_distance(data, where):
    distance = _with_transfers(Distance, data, where, {})
    if distance.far <= distance.near:
        raise StyleError(f"{where}.far must be more than near")
    return distance


def parse_transfer(data, where, default):
    check_keys(data, {"start", "end", "strength", "curve"}, where)
    plain = {"start": default.start, "end": default.end, "strength": default.strength}
    numbers = {key: check_range(data.get(key, value), (0, 1), f"{where}.{key}") for key, value in plain.items()}
    return Transfer(**numbers, curve=_curve(data.get("curve", default.curve), f"{where}.curve"))


def _with_transfers(cls, data, where, choices):
    """An instance of a dataclass of transfer functions, words and numbers; what is not given is as its default."""
    default = cls()
    check_keys(data, vars(default), where)
    values = {}
    for key, value in data.items():
        here, old = f"{where}.{key}", getattr(default, key)
        if isinstance(old, Transfer):
            values[key] = parse_transfer(value, here, old)
        elif key in choices:
            values[key] = one_of(value, choices[key], here)
        else:
            values[key] = check_range(value, RANGES[key], here)
    return cls(**values)


def _point(data, where):
    check_keys(data, {"at", "near", "far", "object"}, where)
    at = data.get("at", Point.at)
    if not isinstance(at, (list, tuple)) or len(at) not in (2, 3):
        raise StyleError(f"{where}.at must be a list of 2 or 3 numbers")
    at = tuple(check_range(v, (-1e9, 1e9), f"{where}.at") for v in at)
    point = record(Point, {key: value for key, value in data.items() if key in ("near", "far")}, where)
    if point.far < point.near:
        raise StyleError(f"{where}.far is less than near")
    name = check_text(data.get("object", ""), f"{where}.object", MOST_NAME)
    return Point(at + (0.0,) * (3 - len(at)), point.near, point.far, name)


def _curve(data, where):
    if not isinstance(data, (list, tuple)) or len(data) > MOST_CURVE_POINTS:
        raise StyleError(f"{where} must be a list of at most {MOST_CURVE_POINTS} points")
    points = []
    for i, point in enumerate(data):
        if not isinstance(point, (list, tuple)) or len(point) != 2:
            raise StyleError(f"{where}[{i}] must be a list of 2 numbers")
        points.append(tuple(check_range(v, (0, 1), f"{where}[{i}]") for v in point))
        if i and points[i - 1][0] >= points[i][0]:
            raise StyleError(f"{where}: points must ascend in x")
    return tuple(points)
