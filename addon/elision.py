# SPDX-License-Identifier: GPL-3.0-or-later
"""Line elision of a style: which of the lines that crowd each other stay (native/elision; Cole 2009, 5.2.2)."""

from dataclasses import dataclass

from .style_values import StyleError, check_keys, check_range, check_text

TERMS = ("length", "kind", "strength", "depth", "object", "painted")
ATTRIBUTES = ("priority_attribute", "density_attribute")
MOST_WEIGHT = 10
MOST_FRAMES = 8


@dataclass(frozen=True)
class Elision:
    """Lines that go alongside each other nearer than their pens' spacing are thinned, by priority."""

    enabled: bool = False
    fade_from: float = 0.35  # share of its room that a line needs to show at all; it is whole where it has all of it
    cut: float = 0.0  # opacity below which a line is left out altogether
    frames: int = 0  # so many before and after each, over which renders smooth what stays of a line
    length: float = 1.0  # what counts for the priority of a line, and how much: its length in space,
    kind: float = 0.5  # what it is: outlines before creases before lines on smooth surfaces,
    strength: float = 0.25
    depth: float = 0.25  # near before far,
    object: float = 1.0  # what its object's own priority says,
    painted: float = 1.0  # and what is painted
    priority_attribute: str = ""  # there; none: that does not count
    density_attribute: str = ""  # painted: 0 for lines a quarter as dense as pens say, .5 as they say, 1 four times

    def weights(self):
        """{name of the native term: what it counts}."""
        weights = {term: getattr(self, term) for term in TERMS}
        return weights if self.priority_attribute else weights | {"painted": 0.0}


def parse(data, where):
    check_keys(data, Elision.__dataclass_fields__, where)
    enabled = data.get("enabled", False)
    if not isinstance(enabled, bool):
        raise StyleError(f"{where}.enabled must be true or false")
    shares = {key: check_range(data[key], (0, 0.99), f"{where}.{key}") for key in ("fade_from", "cut") if key in data}
    weights = {key: check_range(data[key], (0, MOST_WEIGHT), f"{where}.{key}") for key in TERMS if key in data}
    names = {key: check_text(data[key], f"{where}.{key}") for key in ATTRIBUTES if key in data}
    frames = check_range(data.get("frames", 0), (0, MOST_FRAMES), f"{where}.frames")
    if frames != int(frames):
        raise StyleError(f"{where}.frames is {frames:g}, not a whole number")
    elision = Elision(enabled, **shares, **weights, frames=int(frames), **names)
    if not any(elision.weights().values()):
        raise StyleError(f"{where}: some of {', '.join(TERMS)} must count")
    return elision
