# SPDX-License-Identifier: GPL-3.0-or-later
"""A style between two: for changes of style over time.

Numbers and colours go over steadily. Lines that both styles draw go from the one's pen to the other's, lines of one
alone fade. Words and switches (textures, shading) change half way.
"""

from dataclasses import fields, is_dataclass, replace

from .stages import Pen
from .style_parts import FILTERS, Hidden, LineSet, Style


def mix(one, other, share):
    """The Style that is `one` at a share of 0 and `other` at 1. Where to look is said by `one`."""
    if share <= 0.0:
        return one
    if share >= 1.0:
        return replace(other, focus=one.focus)
    names = (f.name for f in fields(Style) if f.name not in ("line_sets", "focus", "kept"))
    mixed = {name: _between(getattr(one, name), getattr(other, name), share) for name in names}
    return replace(one, line_sets=_line_sets(one, other, share), **mixed)


def _between(a, b, share):
    if is_dataclass(a) and type(a) is type(b):
        return replace(a, **{f.name: _between(getattr(a, f.name), getattr(b, f.name), share) for f in fields(a)})
    if isinstance(a, tuple) and isinstance(b, tuple) and len(a) == len(b):
        return tuple(_between(x, y, share) for x, y in zip(a, b))
    if _is_number(a) and _is_number(b):
        value = a + (b - a) * share
        return round(value) if isinstance(a, int) and isinstance(b, int) else value
    return a if share < 0.5 else b


def _is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _line_sets(one, other, share):
    """For each pair of line sets that have kinds of the same things in common one for these, and one for the kinds of
    either set that the other style does not draw of them. Edges go to the first: they stand as in the style that is
    nearer."""
    ours, theirs = _drawn(one), _drawn(other)
    pairs = {}  # (index in `one`, in `other`, -1: in none): kinds
    for what in (*ours, *(what for what in theirs if what not in ours)):
        pairs.setdefault((ours.get(what, -1), theirs.get(what, -1)), []).append(what[0])
    last = max(len(one.line_sets), len(other.line_sets))

    def place(pair):
        order = [last if index < 0 else index for index in pair]
        return order if share < 0.5 else order[::-1]

    mixed = (_line_set(one, other, pair, pairs[pair], share) for pair in sorted(pairs, key=place))
    return tuple(mixed) or (LineSet(kinds={}),)


def _drawn(style):
    """{(kind, what filters say, how many sets before have both): index of the line set that draws it}."""
    found = {}
    for index, line_set in enumerate(style.line_sets):
        for kind in line_set.kinds:
            what = kind, tuple(_filters(line_set).values())
            found[*what, sum(known[:2] == what for known in found)] = index
    return found


def _filters(line_set):
    return {name: getattr(line_set, name) for pair in FILTERS.items() for name in pair}


def _line_set(one, other, pair, kinds, share):
    i, j = pair
    if j < 0:
        return _fading(one.line_sets[i], kinds, 1.0 - share)
    if i < 0:
        return _fading(other.line_sets[j], kinds, share)
    a, b = one.line_sets[i], other.line_sets[j]
    values = {kind: _parameters(a.kinds[kind], b.kinds[kind], share) for kind in kinds}
    overshoot_away = None
    if a.overshoot_away is not None or b.overshoot_away is not None:
        overshoot_away = _between(
            *(s.overshoot if s.overshoot_away is None else s.overshoot_away for s in (a, b)), share
        )
    plain = ("corner_angle", "least_length", "overshoot", "halo", "pen", "name")
    mixed = {name: _between(getattr(a, name), getattr(b, name), share) for name in plain} | _filters(a)
    hidden = _hidden(a.hidden, b.hidden, share)
    return LineSet(kinds=values, pen_away=_away(a, b, share), overshoot_away=overshoot_away, hidden=hidden, **mixed)


def _parameters(a, b, share):
    """Of a kind of lines; what one of the two leaves at its default goes over half way."""
    nearer = a if share < 0.5 else b
    return nearer | {name: _between(a[name], b[name], share) for name in a.keys() & b.keys()}


def _hidden(a, b, share):
    """Pens for what is hidden: those of the same range are mixed; others fade out, then the other style's fade in."""
    same = [(x, y) for x in a for y in b if (x.first, x.last) == (y.first, y.last)]
    if len(same) == len(a) == len(b):
        return tuple(_hidden_pen(x, y, share) for x, y in same)
    near, opacity = (a, 1.0 - 2.0 * share) if share < 0.5 else (b, 2.0 * share - 1.0)
    return tuple(_faint_hidden(hidden, opacity) for hidden in near)


def _hidden_pen(a, b, share):
    return Hidden(_between(a.pen, b.pen, share), a.first, a.last, _away(a, b, share))


def _away(a, b, share):
    """The pen out of focus of two line sets or hidden pens: where one has none, its pen in focus stands for it."""
    return _between(a.pen_away or a.pen, b.pen_away or b.pen, share) if a.pen_away or b.pen_away else None


def _fading(line_set, kinds, opacity):
    """Some kinds of a line set, so much fainter."""
    return replace(
        line_set,
        kinds={kind: line_set.kinds[kind] for kind in kinds},
        pen=_faint(line_set.pen, opacity),
        pen_away=_faint(line_set.pen_away, opacity),
        hidden=tuple(_faint_hidden(hidden, opacity) for hidden in line_set.hidden),
    )


def _faint_hidden(hidden, opacity):
    return replace(hidden, pen=_faint(hidden.pen, opacity), pen_away=_faint(hidden.pen_away, opacity))


def _faint(pen: Pen | None, opacity):
    return pen and replace(pen, opacity=pen.opacity * opacity)
