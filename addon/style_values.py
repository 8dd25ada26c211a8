# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of what a style file says: flat records, numbers within their ranges, and no key that is not known."""

import math
import re
from collections import Counter
from dataclasses import fields

RANGES = {
    "opacity": (0, 1),
    "width": (0.01, 1000),
    "length_scale": (0.01, 100),
    "taper": (0, 10000),
    "strength_width": (0, 1),
    "corner_angle": (0, 180),
    "least_length": (0, 10000),
    "overshoot": (0, 200),
    "halo": (0, 100),
    "wobble": (0, 100),
    "wobble_length": (2, 2000),
    "seed": (0, 1000000),
    "pressure": (0, 1),
    "spacing": (0, 200),
    "near": (0, 1e9),
    "far": (0, 1e9),
    "uniform": (0, 1),
    "blur_radius": (0, 200),
    "desaturation": (0, 1),
    "scale": (0.1, 20),
    "tooth": (0, 1),
    "granulation": (0, 1),
    "tint": (0, 1),
    "height_mm": (10, 10000),
}
MOST_ATTRIBUTE = 63  # letters in the name of an attribute
MOST_SURFACES = 100  # that a range of invisibility can name
MOST_LIGHT = 1000  # of a colour, scene-linear
MOST_WORDS = 500  # characters of what is told about a style: files may hold anything


class StyleError(ValueError):
    """What is wrong with a style, in one sentence for its author."""

    def __init__(self, text):
        short = text if len(text) <= MOST_WORDS else f"{text[: MOST_WORDS - 100]} ... {text[-90:]}"
        super().__init__("".join(c if c.isprintable() else " " for c in short))


class Part(dict):
    """An object of a style file. `unknown`: {key: value} of what is not known there, moved out of it by `check_keys`;
    `twice`: a key that the file gives more than once, or None."""

    def __init__(self, pairs):
        super().__init__(pairs)
        self.unknown = {}
        counted = Counter(key for key, _ in pairs) if len(self) < len(pairs) else {}
        self.twice = next((key for key, count in counted.items() if count > 1), None)


def record(cls, data, where):
    """An instance of a flat dataclass; every value must be of the type of the field's default."""
    check_keys(data, {f.name for f in fields(cls)}, where)
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
        return tuple(check_range(v, (0, MOST_LIGHT), where) for v in value)
    return check_range(value, RANGES[key], where)


def finite(value, where):
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise StyleError(f"{where} is {value!r}, not a finite number")
    return float(value)


def one_of(value, known, where):
    if value not in known:
        raise StyleError(f"{where} is {value!r}; it can be: {', '.join(known)}")
    return value


def check_text(value, where, most=MOST_ATTRIBUTE):
    """A name of something in a scene; never that of a file."""
    if not isinstance(value, str) or len(value) > most or not value.isprintable():
        raise StyleError(f"{where} must be text of at most {most} letters")
    return value


def check_range(value, limits, where):
    number = finite(value, where)
    if not limits[0] <= number <= limits[1]:
        raise StyleError(f"{where} is {number:g}, outside {limits[0]:g} to {limits[1]:g}")
    return number


def check_keys(data, known, where):
    if not isinstance(data, dict):
        raise StyleError(f"{where} must be a JSON object")
    unknown = sorted(set(data) - set(known))
    if isinstance(data, Part):
        data.unknown |= {key: data.pop(key) for key in unknown}
    elif unknown:
        raise StyleError(
            f"{where} has unknown keys: {', '.join(unknown)}; known are: {', '.join(sorted(known)) or 'none'}"
        )
