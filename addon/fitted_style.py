# SPDX-License-Identifier: GPL-3.0-or-later
"""Styles fitted to drawings: which line definitions, and with which thresholds, draw what artists have drawn. Without
Blender.

Each definition is drawn at a few thresholds, so that what cuts lines short or leaves them out counts as it does in
pictures, fitted, and drawn and fitted again at more thresholds near those found."""

import time
from dataclasses import dataclass
from functools import partial

import numpy as np

from . import catalogue, fitted_hand, fitted_pens, native, style

THRESHOLDS = "threshold", "angle"  # parameters that say how strong a line has to be
LEAST, MOST = 0.05, 20.0  # times a threshold's default
STEP, FINE_STEP = 1.5, 1.05  # factors between thresholds that are tried
LEAST_IN_IMAGE, STEPS_IN_IMAGE = 0.02, 8  # of definitions in the image, each of whose drawings takes long
NOTHING = (
    "no lines of the scene are near to the drawing: look at both by fovea compare, register a scan, or allow a larger "
    "tolerance"
)
PALEST = 2.0  # times the ink that is seen: less is no line of a picture, as strokes are narrow where they end
FADED = 0.01  # share of a picture's strokes that is half as dark as most, if they fade
CLOSER, CLOSE = 4.0, 0.95  # a drawing with that F1 within a share of the usual tolerance is fitted within that
ON = 1.0  # stands for the threshold of a definition without one


@dataclass(frozen=True)
class Fitted:
    """A Style, and what it is made of. `thresholds`: {definition: number, True where it has none, None: not drawn};
    `found`, `before`: precision, recall, f1 of its lines, and of those that the style had before; `held_out`: of what
    was held out of the fit, a drawing after the other, or blocks of the only one; `of_each`: of its lines by each
    drawing alone; `looks`, `hands`: what fitted_pens.looked and fitted_hand.hands found for its line sets."""

    style: object
    thresholds: dict
    found: dict
    before: dict
    held_out: dict
    of_each: list
    looks: list
    hands: list
    tolerance: float
    drawings: int  # how often lines were drawn
    seconds: float  # that this took


def threshold_of(name):
    """The parameter, as in the catalogue, that is a definition's threshold; None: it is drawn or not."""
    known = {parameter["name"]: parameter for parameter in catalogue.by_name()[name]["parameters"]}
    return next((known[word] for word in THRESHOLDS if word in known and known[word]["min"] == 0), None)


def names_of(base):
    """The definitions of a Style that are fitted where no others are asked for: all but those in the image, which take
    seconds for each threshold."""
    known = catalogue.by_name()
    held = dict.fromkeys(name for line_set in base.line_sets for name in line_set.kinds)
    return [name for name in held if not known[name]["in_image"]]


def outlines_of(base):
    """Those of them that have no threshold: contours, intersections and others that are in every drawing."""
    return [name for name in names_of(base) if threshold_of(name) is None]


def style_with(base, thresholds):
    """A Style that draws the definitions of {name: threshold}, and no others, as `base` does, with all its line sets.
    Definitions that are in none of them go to the first one that has such of smooth shapes, too, or such of others;
    else to the last one."""
    definitions = catalogue.by_name()
    held = base.line_sets or (style.LineSet(),)
    kinds = [{} for _ in held]
    for name, value in thresholds.items():
        parameter, smooth = threshold_of(name), definitions[name]["of_smooth"]
        given = {parameter["name"]: float(value)} if parameter else {}
        places = [i for i, line_set in enumerate(held) if name in line_set.kinds]
        alike = (i for i, line_set in enumerate(held) for k in line_set.kinds if definitions[k]["of_smooth"] == smooth)
        for place in places or [next(alike, len(held) - 1)]:
            kinds[place][name] = dict(held[place].kinds.get(name, {})) | given
    return base.replace(line_sets=tuple(line_set.replace(kinds=k) for line_set, k in zip(held, kinds)))


def _alone(base, thresholds):
    """A Style of the visible lines of definitions alone, none of them thinned out."""
    alone = style_with(base, thresholds)
    sets = tuple(line_set.replace(hidden=()) for line_set in alone.line_sets)
    return alone.replace(line_sets=sets, elision=style.Elision())


def drawn_outlines(draw, size, base):
    """The Bitmap of outlines_of(base), over which drawings are registered. `draw`, `size`: as for `fit`."""
    return native.load().Bitmap.of_lines(*draw(_alone(base, dict.fromkeys(outlines_of(base), ON))), *size)


def fit(draw, size, names, base, judges_of, tolerance=None, beta=1.0, pens=True, trace=None):
    """The Fitted of the definitions `names` and the Style `base`. draw(style, least): (px, offsets) of what it draws
    in a frame of (width, height) pixels at least so strongly. judges_of(reference): the Laid of the artists' drawings;
    reference() is the Bitmap of the base's outlines, for registration. `tolerance` [px]; None: the usual one, or less
    for drawings that keep to the lines, as renders do. `beta`: above 1 rather complete than clean; `pens`: whether they
    get the width and darkness of strokes, and how the hand draws, where trace(style) gives the fitted_hand.ended of
    what it draws. ValueError if nothing that can be drawn is near to the drawings."""
    core = native.load()
    laid = judges_of(lambda: drawn_outlines(draw, size, base))
    least = PALEST * core.LEAST_INK if all(_fades(each) for each in laid) else 0.0
    ladders = [_Ladder(partial(draw, least=least), base, name) for name in names]
    judges = [each.bitmap for each in laid]
    near = judges[0].usual_tolerance if tolerance is None else tolerance
    usual = [ladder.usual for ladder in ladders]
    for ladder in ladders:
        ladder.climb(ladder.coarse())
    strengths = _strengths(ladders, size)
    found = core.Evidence(strengths, judges, near).fitted(_floats(usual), beta)
    if tolerance is None:
        closely = core.Evidence(strengths, judges, near / CLOSER)
        if closely.judged(found["thresholds"])["f1"] >= CLOSE:
            near, found = near / CLOSER, closely.fitted(found["thresholds"], beta)
    for ladder, threshold in zip(ladders, found["thresholds"]):
        ladder.at(ladder.usual)
        if np.isfinite(threshold):
            ladder.climb(ladder.fine(threshold))
    strengths = _strengths(ladders, size)
    evidence = core.Evidence(strengths, judges, near)
    found = evidence.fitted(found["thresholds"], beta)
    own = [ladder.usual if ladder.in_base else np.inf for ladder in ladders]
    before = evidence.judged(_floats(own), beta)
    chosen = {ladder.name: ladder.nearest(t) for ladder, t in zip(ladders, found["thresholds"]) if np.isfinite(t)}
    if not chosen:
        raise ValueError(NOTHING)
    of_each = [found]
    if len(judges) > 1:
        of_each = [core.Evidence(strengths, [one], near).judged(found["thresholds"], beta) for one in judges]
    held_out = evidence.cross_validated(found["thresholds"], beta)
    made, looks, hands = _pruned(style_with(base, chosen)), [], []
    if pens:
        lines = {of.name: each.above(float(t)) for of, each, t in zip(ladders, strengths, found["thresholds"])}
        looks = _looks(made, lines, laid, near)
        made = fitted_pens.with_looks(made, looks, size[1])
    if pens and trace:
        every = _union(lines[name] for line_set in made.line_sets for name in line_set.kinds)
        hands = fitted_hand.hands(made.line_sets, fitted_hand.traced(trace, style_with(base, chosen)), laid, every)
        made = fitted_hand.with_hands(made, hands, size[1])
    return Fitted(
        made,
        {name: _told(name, chosen.get(name)) for name in names},
        *(_measures(of) for of in (found, before, held_out)),
        [_measures(of) for of in of_each],
        [look for look in looks if look],
        [hand for hand in hands if hand],
        near,
        sum(len(ladder.drawn) for ladder in ladders),
        sum(ladder.seconds for ladder in ladders),
    )


def _fades(laid):
    """Whether a drawing is a picture whose strokes are pale where they are weak, as those of pens are."""
    if laid.gray is None:
        return False
    _, looks = laid.stroke_looks
    return len(looks) > 0 and np.quantile(looks[:, 2], FADED) < 0.5 * np.median(looks[:, 2])


class _Ladder:
    """What a definition draws at rising thresholds: {threshold: (px, offsets)}. `usual`: that of the base, which it is
    in or not, or the default."""

    def __init__(self, draw, base, name):
        self.name, self.draw, self.style_at = name, draw, lambda threshold: _alone(base, {name: threshold})
        self.parameter, self.in_image = threshold_of(name), catalogue.by_name()[name]["in_image"]
        own = [line_set.kinds[name] for line_set in base.line_sets if name in line_set.kinds]
        self.in_base, self.usual = bool(own), ON
        if self.parameter:
            self.usual = next(iter(own), {}).get(self.parameter["name"], self.parameter["default"])
        self.drawn, self.seconds = {}, 0.0

    def coarse(self):
        if not self.parameter:
            return [ON]
        default, end = self.parameter["default"], self.parameter["max"]
        if self.in_image:
            return _between(LEAST_IN_IMAGE, end, STEPS_IN_IMAGE)
        least, most = LEAST * default, min(MOST * default, end)
        return _between(least, most, _steps(least, most, STEP))

    def fine(self, threshold):
        """Thresholds between those beside one that is drawn."""
        known = sorted(t for t in self.drawn if t > 0)
        at = known.index(self.nearest(threshold))
        low, high = known[max(at - 1, 0)], known[min(at + 1, len(known) - 1)]
        return _between(low, high, STEPS_IN_IMAGE if self.in_image else _steps(low, high, FINE_STEP))[1:-1]

    def nearest(self, threshold):
        """The one that is drawn, of a number that the core rounds."""
        return min(self.drawn, key=lambda drawn: abs(drawn - threshold))

    def climb(self, thresholds):
        """Draws what is not drawn yet, up to a threshold where nothing is left."""
        for threshold in thresholds:
            if not len(self.at(threshold)[0]):
                return

    def at(self, threshold):
        if threshold not in self.drawn:
            start = time.perf_counter()
            self.drawn[threshold] = self.draw(self.style_at(threshold))
            self.seconds += time.perf_counter() - start
        return self.drawn[threshold]

    def strengths(self, size):
        """The native Strengths: at each pixel the highest threshold at which it is drawn."""
        lengths = [len(px) for px, _ in self.drawn.values()]
        return native.load().Strengths(*_joined(self.drawn.values()), np.repeat(_floats(self.drawn), lengths), *size)


def _steps(low, high, factor):
    return max(1, round(np.log(high / low) / np.log(factor)))


def _between(low, high, steps):
    """Thresholds from low to high, in so many steps of equal factors, of as many digits as one wants to read."""
    return [float(f"{threshold:.4g}") for threshold in np.geomspace(low, high, steps + 1)]


def _floats(values):
    return np.array(list(values), np.float32)


def _strengths(ladders, size):
    return [ladder.strengths(size) for ladder in ladders]


def _joined(parts):
    """(px, offsets) of several of them, one after the other."""
    parts = list(parts)
    starts = np.cumsum([0, *(len(px) for px, _ in parts)])
    offsets = [offsets[1:] + start for (_, offsets), start in zip(parts, starts)]
    return np.concatenate([px for px, _ in parts]), np.concatenate([[0], *offsets]).astype(np.int64)


def _looks(made, lines, laid, tolerance):
    """What fitted_pens.looked finds for the line sets of a Style. `lines`: {definition: Bitmap} of what is drawn."""
    names = [line_set.name for line_set in made.line_sets]
    drawn = [_union(lines[name] for name in line_set.kinds) for line_set in made.line_sets]
    return fitted_pens.looked(names, drawn, laid, tolerance)


def _union(bitmaps):
    """The Bitmap of what is in any of some."""
    first, *others = bitmaps
    pixels = first.pixels.copy()
    for other in others:
        pixels |= other.pixels
    return type(first)(pixels)


def _pruned(made):
    return made.replace(line_sets=tuple(line_set for line_set in made.line_sets if line_set.kinds))


def _told(name, threshold):
    return None if threshold is None else threshold if threshold_of(name) else True


def _measures(found):
    return {name: found[name] for name in ("precision", "recall", "f1")}
