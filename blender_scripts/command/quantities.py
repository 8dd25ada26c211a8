# SPDX-License-Identifier: GPL-3.0-or-later
"""Parsers of numeric command-line arguments. Each takes a string and raises argparse.ArgumentTypeError, with a message
for the user, if it is invalid or out of range."""

import argparse
import math
import re
from pathlib import Path
from typing import NamedTuple

FRAME_SIDES = 4, 65536  # pixels, Blender's limits
LAST_FRAME = 1048574  # Blender's limit
MOST_TOLERANCE = 1e4  # pixels, or millimeters
MOST_PAPER = 1e5  # millimeters
FAR = 1e9  # largest absolute value of a coordinate


def within(least, most, what):
    """A parser of numbers from least to most; `what`: their unit in plural, for the message."""

    def parse(text):
        number = _float(text)
        if not least <= number <= most:
            raise argparse.ArgumentTypeError(f"'{text}' is not a number of {what} from {least:g} to {most:g}")
        return number

    return parse


class OnPaper(NamedTuple):
    """A length on paper."""

    millimeters: float


def tolerance(text):
    """A length in pixels as a number, from 4 or 4px, or OnPaper, from 1mm."""
    found = re.fullmatch(r"(.*?)\s*(px|mm)?", text)
    number = _float(found[1])
    if not 0 <= number <= MOST_TOLERANCE:
        raise argparse.ArgumentTypeError(
            f"'{text}' is not a number of pixels from 0 to {MOST_TOLERANCE:g}, as 4, nor of millimeters, as 1mm"
        )
    return OnPaper(number) if found[2] == "mm" else number


def finite(what):
    """A parser of finite numbers whose range the core checks; `what`: their unit in plural, for the message."""

    def parse(text):
        number = _float(text)
        if not math.isfinite(number):
            raise argparse.ArgumentTypeError(f"'{text}' is not a number of {what}")
        return number

    return parse


def frame_size(text):
    """(width, height) from WIDTHxHEIGHT."""
    found = re.fullmatch(r"(\d{1,9})x(\d{1,9})", text)
    if not found:
        raise argparse.ArgumentTypeError(f"'{text}' is not WIDTHxHEIGHT")
    size = int(found[1]), int(found[2])
    if not all(FRAME_SIDES[0] <= side <= FRAME_SIDES[1] for side in size):
        raise argparse.ArgumentTypeError(f"'{text}' is not {FRAME_SIDES[0]} to {FRAME_SIDES[1]} pixels wide and high")
    return size


def frames(text):
    """(first, last) from FIRST-LAST or FIRST."""
    found = re.fullmatch(r"(\d{1,9})(?:-(\d{1,9}))?", text)
    first, last = (int(found[1]), int(found[2] or found[1])) if found else (1, 0)
    if not first <= last <= LAST_FRAME:
        raise argparse.ArgumentTypeError(f"'{text}' is not FIRST-LAST, frames up to {LAST_FRAME}")
    return first, last


def surfaces(text):
    """(first, last) from A, A-B, or A-, whose last is None (unlimited)."""
    found = re.fullmatch(r"([1-9]\d{0,8})(-(\d{0,9}))?", text)
    first, last = (int(found[1]), int(found[3] or 0) if found[2] else int(found[1])) if found else (1, -1)
    if last and last < first:
        raise argparse.ArgumentTypeError(f"'{text}' is not FIRST-LAST surfaces that hide a line")
    return first, last or None


def focus(text):
    """A tuple of two or three numbers; text with letters other than exponents, and other than nan and inf among
    several, is an object's name."""
    parts = [re.sub(r"^\s*[-+]?(nan|inf|infinity)\s*$", "0", part, flags=re.IGNORECASE) for part in text.split(",")]
    words = ",".join(parts) if len(parts) > 1 else text
    if re.search(r"[^\W\d]", re.sub(r"(?<=[\d.])[eE](?=[-+\d])", "", words)):
        return text
    return _numbers(text, (2, 3), "U,V in the image, X,Y,Z in space, or an object's name")


def section(text):
    """A tuple of six numbers, a point and a normal that is not zero; other text is an object's name."""
    if text.count(",") != 5:
        return text
    numbers = _numbers(text, (6,), "OBJECT or X,Y,Z,NX,NY,NZ")
    if not any(numbers[3:]):
        raise argparse.ArgumentTypeError(f"'{text}' has no direction: NX,NY,NZ point to what is cut away")
    return numbers


def radii(text):
    near, far = _numbers(text, (2,), "NEAR,FAR")
    if not 0 <= near <= far:
        raise argparse.ArgumentTypeError(f"'{text}' is not NEAR,FAR, neither below 0 and FAR the larger")
    return near, far


def assignment(text):
    """(name, number) from NAME=NUMBER, (name, absolute path) from NAME=FILE.json; the line definition validates them
    later."""
    name, _, value = text.partition("=")
    if Path(value).suffix == ".json":
        return name, str(Path(value).absolute())
    number = _float(value)
    if not math.isfinite(number):
        raise argparse.ArgumentTypeError(f"'{text}' is not NAME=NUMBER, nor NAME=FILE.json")
    return name, number


def _numbers(text, counts, what):
    numbers = tuple(_float(part) for part in text.split(","))
    if len(numbers) not in counts or not all(abs(number) <= FAR for number in numbers):
        raise argparse.ArgumentTypeError(f"'{text}' is not {what}")
    return numbers


def _float(text):
    """The number in a string; NaN, which fails all range checks, if it is not a number."""
    try:
        return float(text)
    except ValueError:
        return math.nan
