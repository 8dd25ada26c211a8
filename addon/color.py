# SPDX-License-Identifier: GPL-3.0-or-later
"""The colour layer of a style, and what a scene brings along for it."""

from dataclasses import dataclass, field

from .style_values import StyleError, check_keys, check_range, record

SHADINGS = ("plain", "flat", "smooth", "toon")
MOST_BANDS = 16


@dataclass(frozen=True)
class Color:
    """The scene's surfaces in colour, under the lines."""

    shading: str = "plain"  # plain: there is no layer; flat: base colours; smooth: lit; toon: lit in bands
    bands: int = 3  # of toon shading
    opacity: float = 1.0
    desaturation: float = 0.0  # everywhere, besides what focus does
    background: tuple | None = None  # scene-linear, painted under the layer; None: the paper shows


@dataclass(frozen=True)
class Sources:
    """Where the colours of a scene come from, in native handles."""

    surfaces: list  # a SurfaceColor or None per placement
    lights: list = field(default_factory=list)  # native Lights; none: one at the eye
    world: tuple = (0.0, 0.0, 0.0)  # radiance of the sky


def parse(data, where):
    """A Color from JSON."""
    check_keys(data, Color.__dataclass_fields__, where)
    background, bands = data.get("background"), data.get("bands", Color.bands)
    if isinstance(bands, bool) or not isinstance(bands, int) or not 2 <= bands <= MOST_BANDS:
        raise StyleError(f"{where}.bands is {bands!r}, not a number of bands from 2 to {MOST_BANDS}")
    plain = {key: value for key, value in data.items() if key not in ("background", "bands")}
    checked = record(_Plain, plain, where)
    if checked.shading not in SHADINGS:
        raise StyleError(f"{where}.shading is '{checked.shading}'; it can be: {', '.join(SHADINGS)}")
    if background == "paper":
        background = None
    if background is not None:
        background = _color(background, f"{where}.background")
    return Color(checked.shading, bands, checked.opacity, checked.desaturation, background)


@dataclass(frozen=True)
class _Plain:
    """What of a Color is checked by its type alone."""

    shading: str = Color.shading
    opacity: float = Color.opacity
    desaturation: float = Color.desaturation


def _color(value, where):
    if not isinstance(value, (list, tuple)) or len(value) != 3:
        raise StyleError(f"{where} must be 'paper' or a list of 3 numbers")
    return tuple(check_range(part, (0, 1000), where) for part in value)
