# SPDX-License-Identifier: GPL-3.0-or-later
"""A Style from the properties that hold it, in a node tree; see style_groups.py."""

import json
import math
from dataclasses import replace

from ..color import Color
from ..elision import Elision
from ..focus import Distance, Effects, Focus, Transfer
from ..stages import Pen
from ..style_parts import Hidden, LineSet, Paper, Style
from . import line_kinds, style_curves, style_words
from .property_kinds import neat
from .style_groups import PARTS, plain_fields, transfers

LEAST_DEPTH = 1e-6  # between near and far


def read(tree, focus=Focus()):
    """The Style in a node tree; evaluated ones have the values of their frame. Where to look is the scene's."""
    held = tree.fovea
    return Style(
        paper=Paper(**_plain(held.paper, Paper)),
        line_sets=tuple(line_set(group) for group in held.line_sets) or (LineSet(),),
        focus=focus,
        effects=Effects(**_plain(held.effects, Effects), **_transfers(tree, held.effects, Effects)),
        distance=_distance(tree, held.distance),
        color=_color(held.color),
        elision=_elision(held.elision),
        kept=_kept(held),
    )


def _plain(group, cls):
    """{field: value} of what are plain properties."""
    return {name: _value(group, PARTS[cls], name, default) for name, default in plain_fields(cls)}


def _value(group, part, name, default):
    value = getattr(group, name)
    if f"{part}.{name}" in style_words.CHOICES:
        return value.lower()
    if isinstance(default, tuple):
        return tuple(neat(v) for v in value)
    if isinstance(default, float):
        return neat(math.degrees(value) if style_words.of(part, name)[2].get("subtype") == "ANGLE" else value)
    return value


def _transfers(tree, group, cls):
    found = {}
    for name in transfers(cls):
        curve = style_curves.read(tree, PARTS[cls], name)
        found[name] = Transfer(**_plain(getattr(group, name), Transfer), curve=curve)
    return found


def _distance(tree, group):
    found = Distance(**_plain(group, Distance), **_transfers(tree, group, Distance))
    return found if found.far > found.near else replace(found, far=found.near + max(LEAST_DEPTH, 1e-6 * found.near))


def _color(group):
    background = None if group.on_paper else tuple(neat(v) for v in group.background)
    return Color(**_plain(group, Color), background=background)


def _elision(group):
    """Something must count: length does where nothing else would."""
    found = Elision(**_plain(group, Elision))
    return found if any(found.weights().values()) else replace(found, length=1.0)


def pen(group):
    """The Pen of a pen's properties."""
    return Pen(**_plain(group, Pen))


def _pens(group):
    """The pen in focus, and the one out of it if that is another."""
    near, away = pen(group.pen), pen(group.pen_away) if group.away else None
    return {"pen": near, "pen_away": None if away == near else away}


def line_set(group):
    """The LineSet of a line set's properties."""
    plain = _plain(group, LineSet)
    overshoot = neat(group.overshoot_away) if group.away else None
    return LineSet(
        name=group.name,
        kinds=line_kinds.read(group.kinds),
        overshoot_away=None if overshoot == plain["overshoot"] else overshoot,
        hidden=_apart(group.hidden),
        **plain,
        **_pens(group),
    )


def _apart(pens):
    """The hidden pens in the order of their ranges; where ranges share numbers of surfaces, the later one has them."""
    found = []
    for group in sorted(pens, key=lambda g: g.first):
        last = max(group.last, group.first) if group.last else None
        if found and (found[-1].last is None or found[-1].last >= group.first):
            before = found.pop()
            if before.first < group.first:
                found.append(replace(before, last=group.first - 1))
        found.append(Hidden(first=group.first, last=last, **_pens(group)))
    return tuple(found)


def _kept(held):
    """What the style's file said that nobody here knew."""
    found = [(tuple(path), value) for path, value in json.loads(held.kept or "[]")]
    for i, line_set in enumerate(held.line_sets):
        found += [(("line_sets", i, *path), value) for path, value in json.loads(line_set.kept or "[]")]
    return tuple(found)
