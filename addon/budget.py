# SPDX-License-Identifier: GPL-3.0-or-later
"""How good a picture may be when there is little time for it: a ladder of qualities, and which of them to draw in.

While a view moves, each draw should keep within a budget. What the stages cost was measured by the draws before, so
that one knows what a quality will cost before it is drawn.
"""

from dataclasses import dataclass

from . import catalogue

ENOUGH = 1.25  # times the least that any quality costs: what is nearly as fast and better looking is taken
MARGIN = 0.8  # of the budget: a better quality must keep within it, so that qualities do not alternate
OVERVIEW = 500.0  # ms: resting views show a better picture in this time, if the best takes twice as long


@dataclass(frozen=True)
class Quality:
    """What is left out or made coarser; as it is given here, nothing."""

    scale: float = 1.0  # of the picture, along each axis
    step: float = 1.0  # between visibility samples, times that of the options
    probes: int = 16  # at most
    depth_scale: int = 3  # at most
    focus_step: int = 1  # pixels between those whose focus is evaluated for colors
    blur: bool = True  # of colors out of focus; that they are faded and desaturated is in every draft
    hidden: bool = True  # hidden lines, haloes and overshoot
    elision: bool = True
    definitions: bool = True  # lines that take long to find


QUALITIES = (
    Quality(),
    Quality(probes=4, focus_step=2, blur=False),
    Quality(probes=4, depth_scale=2, step=2.0, focus_step=2, blur=False, hidden=False, elision=False),
    Quality(1.0, 4.0, 1, 1, focus_step=4, blur=False, hidden=False, elision=False, definitions=False),
    Quality(0.5, 4.0, 1, 1, focus_step=2, blur=False, hidden=False, elision=False, definitions=False),
    Quality(0.34, 4.0, 1, 1, focus_step=2, blur=False, hidden=False, elision=False, definitions=False),
)
UNKNOWN = 3  # what to draw in when nothing has been measured

# Stage -> what of a quality changes what it costs. All other stages cost the same in each.
DEPENDS = {
    "lines": ("definitions",),
    "project": ("definitions", "step"),
    "visibility": ("definitions", "step", "probes", "depth_scale", "scale"),
    "runs": ("definitions", "hidden"),
    "elision": ("elision", "definitions", "step", "scale"),
    "shape": ("definitions", "hidden"),
    "strokes": ("definitions", "scale"),
    "color": ("scale",),
    "focus": ("scale", "focus_step", "blur"),
    "paper": ("scale",),
    "show": ("scale",),
}


def simplified(style, quality):
    """A Style as a quality draws it."""
    sets = style.line_sets
    if not quality.hidden:
        sets = tuple(s.replace(hidden=(), halo=0.0, overshoot=0.0, overshoot_away=None) for s in sets)
    if not quality.definitions:
        drawn = {kind for s in sets for kind in s.kinds}
        sets = tuple(s.replace(kinds=_quick(s.kinds, drawn)) for s in sets)
    effects = style.effects if quality.blur else style.effects.replace(blur=style.effects.blur.replace(strength=0.0))
    elision = style.elision.replace(enabled=style.elision.enabled and quality.elision)
    return style.replace(line_sets=sets, effects=effects, elision=elision)


def _quick(kinds, drawn):
    """The kinds of a line set without those that take long, and with what stands for them."""
    known = catalogue.by_name()
    return {kind: values for kind, values in kinds.items() if not known[kind]["slow"]} | _stand_ins(kinds, drawn)


def _stand_ins(kinds, drawn):
    """What stands for others of a line set's kinds, and is none of them itself. `drawn`: kinds of all sets; where the
    smooth twin of a stand-in is among them, it goes before that of the mesh."""
    found, known = {}, catalogue.by_name()
    for name, definition in known.items():
        if name in kinds:
            twins = (known[quick]["smooth_twin"] for quick in definition["stand_ins"])
            found |= {twin: {} for twin in twins if twin in drawn} | definition["stand_ins"]
    return {kind: values for kind, values in found.items() if kind not in kinds}


def outlines(style, quality):
    """`outlines` of the native Options of a Style as a quality draws it."""
    if quality.definitions:
        return ()
    drawn = {kind for s in style.line_sets for kind in s.kinds}
    found = ((i, tuple(_stand_ins(s.kinds, drawn))) for i, s in enumerate(style.line_sets))
    return tuple((i, kinds) for i, kinds in found if kinds)


def coarser(options, quality):
    """Native Options in a quality."""
    return options.replace(
        sample_step=options.sample_step * quality.step,
        gap=max(options.gap, options.sample_step * quality.step + 1),
        probes=min(options.probes, quality.probes),
        depth_scale=min(options.depth_scale, quality.depth_scale),
        focus_step=max(options.focus_step, quality.focus_step),
    )


class Budget:
    """Chooses among QUALITIES by what their stages cost when they were drawn last. `cold`: of the first picture of a
    scene that has changed, for which all must be found that is kept for those after it; such costs are told apart."""

    def __init__(self):
        self._cost = {}  # (stage, what of the quality changes it, cold) -> ms

    def note(self, index, stages, *, cold=False):
        """What the stages {name: ms} of a picture in the quality of that index took. Where a stage takes longer than it
        used to, the machine has more to do or the scene has more in it: so it will in the other qualities, too."""
        for stage, ms in stages.items():
            key = self._key(stage, QUALITIES[index], cold)
            before = self._cost.setdefault(key, ms)
            now = 0.5 * (before + ms)
            for other in [other for other in self._cost if (other[0], other[2]) == (stage, cold)]:
                self._cost[other] *= now / before if before > 0 else 1.0
            self._cost[key] = now

    def known(self):
        return bool(self._cost)

    def predicted(self, index, *, cold=False):
        """ms that a picture in this quality takes."""
        quality = QUALITIES[index]
        stages = {key[0] for key in self._cost if key[0] != "elision" or quality.elision}
        return sum(self._cost_of(stage, quality, cold) for stage in stages)

    def _cost_of(self, stage, quality, cold):
        """ms that a stage takes. Where it was not measured so, as much as the dearest way in which it was, or as it took
        cold."""
        exact = self._cost.get(self._key(stage, quality, cold))
        if exact is not None:
            return exact
        found = {key: ms for key, ms in self._cost.items() if key[0] == stage}
        dearest = max([ms for key, ms in found.items() if key[2] == cold] or found.values())
        return dearest if cold else min(dearest, found.get(self._key(stage, quality, True), dearest))

    def choose(self, budget_ms, last=None, *, cold=False):
        """Index of the best quality that keeps within the budget, or that is nearly as fast as the fastest. `last`: the
        one drawn before, which needs no margin."""
        if not self.known():
            return UNKNOWN
        predicted = [self.predicted(i, cold=cold) for i in range(len(QUALITIES))]
        chosen = self._least_within(budget_ms, predicted, last)
        # What is coarser than all that was ever drawn may be faster than it is thought to be.
        coarser = 1 + max(i for i in range(len(QUALITIES)) if i == 0 or self._measured(i))
        if predicted[chosen] > budget_ms and coarser < len(QUALITIES):
            return coarser
        return chosen

    @staticmethod
    def _least_within(budget_ms, predicted, last):
        enough = ENOUGH * min(predicted)
        for i, ms in enumerate(predicted):
            better = last is not None and i < last
            if ms <= max(budget_ms * (MARGIN if better else 1.0), enough):
                return i
        return len(QUALITIES) - 1

    def _measured(self, index):
        """Whether all stages were drawn in this quality."""
        quality = QUALITIES[index]
        stages = {key[0] for key in self._cost if key[0] != "elision" or quality.elision}
        return all(any(self._key(stage, quality, cold) in self._cost for cold in (False, True)) for stage in stages)

    def next_at_rest(self, shown):
        """Index of the quality that comes after that of the picture shown, on the way to the best."""
        if self.predicted(0) > 2 * OVERVIEW:
            for i in range(1, shown):
                if self.predicted(i) <= OVERVIEW:
                    return i
        return 0

    @staticmethod
    def _key(stage, quality, cold):
        return stage, tuple(getattr(quality, name) for name in DEPENDS.get(stage, ())), cold
