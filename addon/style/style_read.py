# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a Style from the properties of a node tree; see style_groups.py."""

import json
import math

from .. import style
from ..scene import line_kinds
from ..scene.property_kinds import neat
from . import style_curves
from .style_groups import part, plain_fields, transfers

LEAST_DEPTH = 1e-6  # smallest difference between near and far


def read(tree, focus=None):
    """The Style in a node tree; an evaluated tree has the animated values of its frame. The focus belongs to the scene
    and is passed in; None: no focus."""
    held = tree.fovea
    return style.Style(
        paper=style.Paper(**_plain(held.paper, style.Paper)),
        line_sets=tuple(line_set(group) for group in held.line_sets) or (style.LineSet(),),
        focus=focus or style.Focus(),
        effects=style.Effects(**_plain(held.effects, style.Effects), **_transfers(held.effects, style.Effects)),
        distance=_distance(held.distance),
        color=_color(held.color),
        elision=_elision(held.elision),
        section=style.Section(**_plain(held.section, style.Section)),
        animation=style.Animation(**_plain(held.animation, style.Animation)),
        kept=_kept(held),
    )


def _plain(group, cls):
    """{member: value} of a record's plain members."""
    return {field["name"]: _value(group, field) for field in plain_fields(cls)}


def _value(group, field):
    value = getattr(group, field["name"])
    if field["type"] == "choice":
        return value.lower()
    if field["type"] == "color":
        return tuple(neat(v) for v in value)
    if field["type"] == "number":
        return neat(math.degrees(value) if field["unit"] == "degrees" else value)
    return value


def _transfers(group, cls, curves=None):
    """{member: Transfer} of a record. `curves`: part of the names of their curves' nodes, by default the record's."""
    found = {}
    for name in transfers(cls):
        curve = style_curves.read(group.id_data, part(cls) if curves is None else curves, name)
        found[name] = style.Transfer(**_plain(getattr(group, name), style.Transfer), curve=curve)
    return found


def _distance(group):
    found = style.Distance(**_plain(group, style.Distance), **_transfers(group, style.Distance))
    return found if found.far > found.near else found.replace(far=found.near + max(LEAST_DEPTH, 1e-6 * found.near))


def _color(group):
    background = None if group.on_paper else tuple(neat(v) for v in group.background)
    return style.Color(**_plain(group, style.Color), background=background)


def _elision(group):
    """The Elision; if all priority weights are 0, length gets weight 1, because ranking needs one."""
    found = style.Elision(**_plain(group, style.Elision))
    return found if found.ranks() else found.replace(length=1.0)


def pen(group):
    """The Pen in a pen's properties."""
    return style.Pen(**_plain(group, style.Pen), **_transfers(group, style.Pen, group.curves))


def _pens(group):
    """The pen and the defocus pen; the latter is None if it is off or equal."""
    near, away = pen(group.pen), pen(group.pen_away) if group.away else None
    return {"pen": near, "pen_away": None if away == near else away}


def line_set(group):
    """The LineSet in a line set's properties."""
    plain = _plain(group, style.LineSet)
    overshoot = neat(group.overshoot_away) if group.away else None
    return style.LineSet(
        name=group.name,
        kinds=line_kinds.read(group.kinds),
        overshoot_away=None if overshoot == plain["overshoot"] else overshoot,
        hidden=_apart(group.hidden),
        **plain,
        **_pens(group),
    )


def _apart(pens):
    """The Hidden pens sorted by their ranges of quantitative invisibility; where ranges overlap, the later one has the
    common numbers."""
    found = []
    for group in sorted(pens, key=lambda g: g.first):
        last = max(group.last, group.first) if group.last else None
        if found and (found[-1].last is None or found[-1].last >= group.first):
            before = found.pop()
            if before.first < group.first:
                found.append(before.replace(last=group.first - 1))
        found.append(style.Hidden(first=group.first, last=last, **_pens(group)))
    return tuple(found)


def _kept(held):
    """The unknown fields of the style's file, as (path, value) pairs."""
    found = [(tuple(path), value) for path, value in json.loads(held.kept or "[]")]
    for i, line_set in enumerate(held.line_sets):
        found += [(("line_sets", i, *path), value) for path, value in json.loads(line_set.kept or "[]")]
    return tuple(found)
