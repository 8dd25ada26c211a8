# SPDX-License-Identifier: GPL-3.0-or-later
"""Modifiers of a pen from those of Freestyle's line styles.

A modifier of Freestyle gives width, opacity or color a value for each value x in [0, 1] of its cause, and blends it
with the line style's own. Where the result is largest, the pen has it whole; elsewhere the pen's modifier takes some
away.
"""

import math

from .. import style
from . import style_curves

BLENDS = {
    "MIX": lambda old, new: new,
    "ADD": lambda old, new: old + new,
    "SUBTRACT": lambda old, new: old - new,
    "MULTIPLY": lambda old, new: old * new,
}
MEMBERS = {"thickness": "width", "alpha": "opacity", "color": "color"}  # Freestyle's word -> ours
CAUSES = {"ALONG_STROKE": "along", "CALLIGRAPHY": "nib", "DISTANCE_FROM_CAMERA": "distance", "NOISE": "noise"}


def applied(pen, chosen, pixel_mm):
    """(pen with the modifiers of a Freestyle line style, phrases on those that are not converted). `pixel_mm`:
    millimeters of the page per pixel of the image."""
    told, unit = [], pen.width / max(chosen.thickness, 1e-6)
    for words in MEMBERS:
        for modifier in getattr(chosen, f"{words}_modifiers"):
            if modifier.use:
                pen, left = _applied(pen, words, modifier, unit, pixel_mm)
                told += left
    return pen, told


def _applied(pen, words, modifier, unit, pixel_mm):
    cause, member = CAUSES.get(modifier.type), MEMBERS[words]
    settings = _settings(cause, modifier, pixel_mm)
    if (
        cause is None
        or modifier.blend not in (BLENDS if words != "color" else ("MIX",))
        or _is_taken(pen, cause, member)
        or any(_acts(pen, cause) and abs(getattr(pen, name) - value) > 1e-6 for name, value in settings.items())
    ):
        return pen, [f"the {words} modifier '{modifier.name}'"]
    pen = pen.replace(**settings)
    if words == "color":
        return _colored(pen, cause, modifier)
    own, blend = getattr(pen, member), BLENDS[modifier.blend]
    points = [(x, own + modifier.influence * (blend(own, new) - own)) for x, new in _values(modifier, pen, words, unit)]
    if cause == "along":
        return along(pen, member, points), []
    changed, told = _taking(*_whole(pen, member, points), words, cause, modifier)
    return changed or pen, told


def along(pen, member, points):
    """The pen whose width or opacity has the values of (place along the stroke, value) points."""
    pen, taken = _whole(pen, member, points)
    changes = any(fraction for _, fraction in taken)
    return pen.replace(**{f"along_{member}": style.Transfer(strength=float(changes), curve=tuple(taken))})


def _whole(pen, member, points):
    """(pen with the largest of some (x, value) points, (x, fraction taken of it))."""
    known = style.field(style.Pen, member)
    points = [(x, min(max(value, 0.0), known["max"])) for x, value in points]
    whole = max(value for _, value in points)
    pen = pen.replace(**{member: max(whole, known["min"])})
    return pen, [(x, 1.0 - value / whole if whole else 1.0) for x, value in points]


def _values(modifier, pen, words, unit):
    """(x, value) points of a modifier of thickness (in the pen's unit) or alpha."""
    if modifier.type == "CALLIGRAPHY":
        return ((0.0, modifier.thickness_min * unit), (1.0, modifier.thickness_max * unit))
    if words == "thickness" and modifier.type == "NOISE":
        return tuple((x, pen.width + side * modifier.amplitude * unit) for x, side in ((0.0, -1.0), (1.0, 1.0)))
    if modifier.mapping == "CURVE":
        points = curve_points(modifier.curve)
    else:
        points = ((0.0, 1.0), (1.0, 0.0)) if modifier.invert else style_curves.STRAIGHT
    if words == "alpha":
        return points
    low, high = modifier.value_min * unit, modifier.value_max * unit
    return tuple((x, low + y * (high - low)) for x, y in points)


def curve_points(mapping):
    """(x, y) points of a curve mapping; two where it is straight."""
    return style_curves.points_of(mapping) or style_curves.STRAIGHT


def _settings(cause, modifier, pixel_mm):
    """The members of a pen that all modifiers of a cause share."""
    if cause == "distance":
        return {"distance_near": modifier.range_min, "distance_far": modifier.range_max}
    if cause == "noise":
        length = style.field(style.Pen, "noise_length")
        return {
            "noise_length": min(max(modifier.period * pixel_mm, length["min"]), length["max"]),
            "seed": float(modifier.seed),
        }
    return {}


def _taking(pen, taken, words, cause, modifier):
    """(pen of whose member a cause takes the fractions of (x, fraction) points, phrases): of a curve its ends. The pen
    is None where it has another modifier of the cause that points the other way."""
    (_, first), *between, (_, last) = taken
    told = [f"the curve of the {words} modifier '{modifier.name}'"] if between else []
    turned = first > last
    if cause == "nib":
        angle = math.degrees(modifier.orientation) + (0.0 if turned else 90.0)
        pen = pen.replace(nib_angle=angle % 180.0)
    elif cause == "distance" and turned:
        if _acts(pen, cause):
            return None, [f"the {words} modifier '{modifier.name}'"]
        pen = pen.replace(distance_near=pen.distance_far, distance_far=pen.distance_near)
    return pen.replace(**{f"{cause}_{MEMBERS[words]}": max(first, last)}), told


def _colored(pen, cause, modifier):
    """The pen with the ends of a color ramp as its colors."""
    elements = modifier.color_ramp.elements
    first, last = elements[0], elements[len(elements) - 1]
    near, far = (
        tuple(own + modifier.influence * (new - own) for own, new in zip(pen.color, element.color[:3]))
        for element in (first, last)
    )
    between = f"the colors between the first and the last of the color modifier '{modifier.name}'"
    told = [between] if len(elements) > 2 else []
    over = 1.0
    if cause == "along":
        over = style.Transfer(start=first.position, end=last.position, strength=1.0)
    return pen.replace(color=near, second_color=far, **{f"{cause}_color": over}), told


def _acts(pen, cause):
    return any(_is_set(getattr(pen, f"{cause}_{member}")) for member in MEMBERS.values())


def _is_taken(pen, cause, member):
    """Whether a pen has a modifier already where another would go; there is one second color."""
    causes = CAUSES.values() if member == "color" else (cause,)
    return any(_is_set(getattr(pen, f"{each}_{member}")) for each in causes)


def _is_set(share):
    return (share.strength if isinstance(share, style.Transfer) else share) > 0
