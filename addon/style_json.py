# SPDX-License-Identifier: GPL-3.0-or-later
"""JSON of style files, whatever they hold: what is read is small, not deep, plain text and finite numbers."""

import json
import math

from .style_values import Part, StyleError

LARGEST = 1 << 20  # bytes; shipped styles have two thousand
DEEPEST = 32  # levels of objects and lists
LONGEST_NUMBER = 300  # digits: longer ones are no float


def read(path):
    """The text of a file."""
    try:
        with open(path, "rb") as file:
            data = file.read(LARGEST + 1)
    except (OSError, ValueError) as error:
        raise StyleError(f"the style {str(path)!r} cannot be read: {error}") from error
    _check_size(len(data))
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise StyleError(f"the style is not text in UTF-8: byte {error.start} is not") from error


def parse(text):
    """Parts, lists and plain values."""
    _check_size(len(text))
    try:
        data = json.loads(text, object_pairs_hook=Part, parse_int=_whole)
    except json.JSONDecodeError as error:
        raise StyleError(f"the style is not JSON: {error}") from error
    except RecursionError:
        raise StyleError(f"the style is nested more than {DEEPEST} levels deep") from None
    _check(data, ())
    return data


def unknown(data, path=()):
    """(path, value) of what `check_keys` found not to be known: keys and indices from the root."""
    if isinstance(data, Part):
        yield from (((*path, key), value) for key, value in data.unknown.items())
    for step, value in _inside(data):
        yield from unknown(value, (*path, step))


def put(data, path, value):
    """Sets what is at a path, if there is such a place."""
    *where, key = path
    place = at(data, where)
    if isinstance(place, dict):
        place[key] = value


def at(data, path):
    """What is at a path, or None."""
    try:
        for step in path:
            data = data[step]
    except (KeyError, IndexError, TypeError):
        return None
    return data


def dotted(path):
    """A path as a reader of the file would write it: line_sets[0].pen.width."""
    return "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in path).removeprefix(".")


def _inside(value):
    """(step, value) of what is directly in a value."""
    if isinstance(value, dict):
        return value.items()
    return enumerate(value) if isinstance(value, list) else ()


def _whole(digits):
    return int(digits) if len(digits) <= LONGEST_NUMBER else math.copysign(math.inf, -1 if digits[0] == "-" else 1)


def _check_size(size):
    if size > LARGEST:
        raise StyleError(f"the style has more than {LARGEST >> 20} MB: that is no style")


def _check(value, path):
    """What holds for every value, known or not."""
    wrong = _wrong(value, len(path))
    if wrong:
        raise StyleError(f"{dotted(path) or 'the style'} {wrong}")
    for step, inner in _inside(value):
        if _broken(step):
            raise StyleError(f"{dotted(path) or 'the style'} has a key that is not Unicode: {step!r}")
        _check(inner, (*path, step))


def _wrong(value, depth):
    if depth > DEEPEST:
        return f"is nested more than {DEEPEST} levels deep"
    if isinstance(value, Part) and value.twice is not None:
        return f"gives {value.twice!r} twice"
    if isinstance(value, float) and not math.isfinite(value):
        return f"is {value!r}, not a finite number"
    return f"is text that is not Unicode: {value!r}" if _broken(value) else None


def _broken(text):
    """Whether it is text with half a character."""
    return isinstance(text, str) and any(0xD800 <= ord(c) <= 0xDFFF for c in text)
