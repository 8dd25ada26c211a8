# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a Style to the properties of a node tree; see style_groups.py."""

import json
import math

from .. import style
from ..scene import line_kinds
from . import style_curves
from .style_groups import part, plain_fields, transfers


def write(tree, wanted):
    """Writes a Style to a node tree, except the focus, which belongs to the scene."""
    held = tree.fovea
    held.schema = style.SCHEMA
    _write_plain(held.paper, wanted.paper)
    _write_plain(held.color, wanted.color)
    held.color.on_paper = wanted.color.background is None
    if wanted.color.background is not None:
        held.color.background = wanted.color.background
    _write_plain(held.elision, wanted.elision)
    _write_plain(held.section, wanted.section)
    _write_plain(held.animation, wanted.animation)
    _write_transfers(tree, held.effects, wanted.effects)
    _write_transfers(tree, held.distance, wanted.distance)
    held.line_sets.clear()
    style_curves.drop_unused(tree)
    for line_set in wanted.line_sets:
        write_line_set(held.line_sets.add(), line_set)
    held.line_set_index = len(held.line_sets) - 1
    _write_kept(held, wanted.kept)


def write_line_set(group, wanted):
    """Writes a LineSet to a line set's properties."""
    group.name = wanted.name
    line_kinds.write(group.kinds, wanted.kinds)
    _write_plain(group, wanted)
    _write_pens(group, wanted)
    group.away = wanted.pen_away is not None or wanted.overshoot_away is not None
    group.overshoot_away = wanted.overshoot if wanted.overshoot_away is None else wanted.overshoot_away
    group.hidden.clear()
    for hidden in wanted.hidden:
        write_hidden(group.hidden.add(), hidden)


def write_hidden(group, wanted):
    """Writes a Hidden to a hidden pen's properties."""
    group.first, group.last = wanted.first, wanted.last or 0
    _write_pens(group, wanted)


def _write_pens(group, wanted):
    _write_pen(group.pen, wanted.pen)
    _write_pen(group.pen_away, wanted.pen_away or wanted.pen)
    group.away = wanted.pen_away is not None


def _write_pen(group, wanted):
    _write_plain(group, wanted)
    for name in transfers(style.Pen):
        transfer = getattr(wanted, name)
        _write_plain(getattr(group, name), transfer)
        style_curves.write_of_pen(group, name, transfer.curve)


def _write_plain(group, wanted):
    for field in plain_fields(type(wanted)):
        value = getattr(wanted, field["name"])
        if field["type"] == "choice":
            value = value.upper()
        elif field["unit"] == "degrees":
            value = math.radians(value)
        setattr(group, field["name"], value)


def _write_transfers(tree, group, wanted):
    _write_plain(group, wanted)
    for name in transfers(type(wanted)):
        transfer = getattr(wanted, name)
        _write_plain(getattr(group, name), transfer)
        style_curves.write(tree, part(type(wanted)), name, transfer.curve)


def _write_kept(held, kept):
    """Stores unknown fields; those of a line set in that line set's properties."""
    held.kept = json.dumps([(path, value) for path, value in kept if not _of_line_set(path)])
    for i, line_set in enumerate(held.line_sets):
        line_set.kept = json.dumps([(path[2:], value) for path, value in kept if _of_line_set(path) and path[1] == i])


def _of_line_set(path):
    return len(path) > 2 and path[0] == "line_sets"
