# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts a Style into the properties that hold it, in a node tree; see style_groups.py."""

import json
import math

from .. import style
from ..color import Color
from ..elision import Elision
from ..focus import Distance, Effects, Transfer
from ..stages import Pen
from ..style_parts import LineSet, Paper
from . import line_kinds, style_curves, style_words
from .style_groups import PARTS, plain_fields, transfers


def write(tree, wanted):
    """Makes a node tree hold a Style, but for where to look, which is the scene's."""
    held = tree.fovea
    held.schema = style.SCHEMA
    _write_plain(held.paper, wanted.paper, Paper)
    _write_plain(held.color, wanted.color, Color)
    held.color.on_paper = wanted.color.background is None
    if wanted.color.background is not None:
        held.color.background = wanted.color.background
    _write_plain(held.elision, wanted.elision, Elision)
    for cls, value in ((Effects, wanted.effects), (Distance, wanted.distance)):
        _write_transfers(tree, getattr(held, PARTS[cls]), value, cls)
    held.line_sets.clear()
    for line_set in wanted.line_sets:
        write_line_set(held.line_sets.add(), line_set)
    held.line_set_index = len(held.line_sets) - 1
    _write_kept(held, wanted.kept)


def write_line_set(group, wanted):
    """Makes a line set's properties those of a LineSet."""
    group.name = wanted.name
    line_kinds.write(group.kinds, wanted.kinds)
    _write_plain(group, wanted, LineSet)
    _write_pens(group, wanted)
    group.away = wanted.pen_away is not None or wanted.overshoot_away is not None
    group.overshoot_away = wanted.overshoot if wanted.overshoot_away is None else wanted.overshoot_away
    group.hidden.clear()
    for hidden in wanted.hidden:
        write_hidden(group.hidden.add(), hidden)


def write_hidden(group, wanted):
    """Makes a hidden pen's properties those of a Hidden."""
    group.first, group.last = wanted.first, wanted.last or 0
    _write_pens(group, wanted)


def _write_pens(group, wanted):
    _write_plain(group.pen, wanted.pen, Pen)
    _write_plain(group.pen_away, wanted.pen_away or wanted.pen, Pen)
    group.away = wanted.pen_away is not None


def _write_plain(group, wanted, cls):
    for name, _ in plain_fields(cls):
        value, part = getattr(wanted, name), PARTS[cls]
        if f"{part}.{name}" in style_words.CHOICES:
            value = value.upper()
        elif style_words.of(part, name)[2].get("subtype") == "ANGLE":
            value = math.radians(value)
        setattr(group, name, value)


def _write_transfers(tree, group, wanted, cls):
    _write_plain(group, wanted, cls)
    for name in transfers(cls):
        transfer = getattr(wanted, name)
        _write_plain(getattr(group, name), transfer, Transfer)
        style_curves.write(tree, PARTS[cls], name, transfer.curve)


def _write_kept(held, kept):
    """What nobody here knows stays with the line set it was said of."""
    held.kept = json.dumps([(path, value) for path, value in kept if not _of_line_set(path)])
    for i, line_set in enumerate(held.line_sets):
        line_set.kept = json.dumps([(path[2:], value) for path, value in kept if _of_line_set(path) and path[1] == i])


def _of_line_set(path):
    return len(path) > 2 and path[0] == "line_sets"
