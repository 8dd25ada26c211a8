# SPDX-License-Identifier: GPL-3.0-or-later
"""Level of detail under a time budget: a list of quality levels, and the choice among them.

While a view moves, each draw should finish within the budget. The cost of each stage is measured in earlier draws and
predicts the cost of every quality before it is drawn.
"""

from dataclasses import dataclass

from . import catalogue

ENOUGH = 1.25  # a quality that costs at most this multiple of the cheapest one is accepted even beyond the budget
MARGIN = 0.8  # hysteresis: switching to a better quality requires this fraction of the budget
OVERVIEW = 500.0  # ms: a resting view first shows a quality within this time if the best takes over twice as long


@dataclass(frozen=True)
class Quality:
    """One level of detail; the defaults are full quality."""

    scale: float = 1.0  # image resolution, factor along each axis
    step: float = 1.0  # spacing of visibility samples, factor on Options.sample_step
    probes: int = 16  # upper limit of Options.probes
    depth_scale: int = 3  # upper limit of Options.depth_scale
    focus_step: int = 1  # lower limit of Options.focus_step: pixels between evaluations of focus for colors
    blur: bool = True  # blur colors out of focus; fading and desaturation are in every quality
    hidden: bool = True  # hidden lines, haloes and overshoot
    elision: bool = True
    definitions: bool = True  # definitions marked slow in the registry


QUALITIES = (
    Quality(),
    Quality(probes=4, focus_step=2, blur=False),
    Quality(0.5, 2.0, 4, 2, focus_step=2, blur=False),
    Quality(0.5, 4.0, 1, 1, focus_step=2, blur=False, hidden=False, elision=False),
    Quality(0.5, 4.0, 1, 1, focus_step=2, blur=False, hidden=False, elision=False, definitions=False),
    Quality(0.34, 4.0, 1, 1, focus_step=2, blur=False, hidden=False, elision=False, definitions=False),
)
UNKNOWN = 4  # index of the quality drawn when nothing has been measured

# Stage -> members of Quality that its cost depends on. All other stages cost the same in every quality.
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
    """The Style reduced to what a quality draws."""
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
    """A line set's kinds without the slow definitions, plus their stand-ins."""
    known = catalogue.by_name()
    return {kind: values for kind, values in kinds.items() if not known[kind]["slow"]} | _stand_ins(kinds, drawn)


def _stand_ins(kinds, drawn):
    """{definition: {parameter: value}} of the stand-ins for a line set's kinds, without those the set already has.
    `drawn`: kinds of all line sets; if it contains the smooth twin of a stand-in, the twin is put before it."""
    found, known = {}, catalogue.by_name()
    for name, definition in known.items():
        if name in kinds:
            twins = (known[quick]["smooth_twin"] for quick in definition["stand_ins"])
            found |= {twin: {} for twin in twins if twin in drawn} | definition["stand_ins"]
    return {kind: values for kind, values in found.items() if kind not in kinds}


def outlines(style, quality):
    """`outlines` of the native Options for a Style in a quality: (index of the line set, its stand-in kinds), ..."""
    if quality.definitions:
        return ()
    drawn = {kind for s in style.line_sets for kind in s.kinds}
    found = ((i, tuple(_stand_ins(s.kinds, drawn))) for i, s in enumerate(style.line_sets))
    return tuple((i, kinds) for i, kinds in found if kinds)


def coarser(options, quality):
    """Native Options reduced to a quality."""
    return options.replace(
        sample_step=options.sample_step * quality.step,
        gap=max(options.gap, options.sample_step * quality.step + 1),
        probes=min(options.probes, quality.probes),
        depth_scale=min(options.depth_scale, quality.depth_scale),
        focus_step=max(options.focus_step, quality.focus_step),
    )


class Budget:
    """Chooses among QUALITIES by the measured costs of their stages. `cold`: the first picture of a changed scene,
    which fills caches that later pictures reuse; its costs are recorded separately."""

    def __init__(self):
        self._cost = {}  # (stage, values of the Quality members in DEPENDS, cold) -> ms

    def note(self, index, stages, *, cold=False):
        """Records the stage times {name: ms} of a picture in QUALITIES[index]. Each is averaged with the time recorded
        before; the stage's times in all other qualities are scaled by the same factor, since a change of machine load
        or scene size affects them equally."""
        for stage, ms in stages.items():
            key = self._key(stage, QUALITIES[index], cold)
            before = self._cost.setdefault(key, ms)
            now = 0.5 * (before + ms)
            for other in [other for other in self._cost if (other[0], other[2]) == (stage, cold)]:
                self._cost[other] *= now / before if before > 0 else 1.0
            self._cost[key] = now

    def predicted(self, index, *, cold=False):
        """Expected ms of a picture in this quality."""
        quality = QUALITIES[index]
        stages = {key[0] for key in self._cost if key[0] != "elision" or quality.elision}
        return sum(self._cost_of(stage, quality, cold) for stage in stages)

    def _cost_of(self, stage, quality, cold):
        """Expected ms of a stage. Without a measurement for this quality: the maximum over the qualities measured, and
        if not `cold`, at most the stage's cold time in this quality."""
        exact = self._cost.get(self._key(stage, quality, cold))
        if exact is not None:
            return exact
        found = {key: ms for key, ms in self._cost.items() if key[0] == stage}
        dearest = max([ms for key, ms in found.items() if key[2] == cold] or found.values())
        return dearest if cold else min(dearest, found.get(self._key(stage, quality, True), dearest))

    def choose(self, budget_ms, last=None, *, cold=False):
        """Index of the best quality whose expected time is within the budget or within ENOUGH times the cheapest.
        `last`: index of the quality drawn before, or None; better ones must fit into MARGIN of the budget."""
        if not self._cost:
            return UNKNOWN
        predicted = [self.predicted(i, cold=cold) for i in range(len(QUALITIES))]
        chosen = self._least_within(budget_ms, predicted, last)
        # Costs of qualities coarser than every measured one are overestimated: try the next coarser one.
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
        """Whether all stages have been measured in this quality."""
        quality = QUALITIES[index]
        stages = {key[0] for key in self._cost if key[0] != "elision" or quality.elision}
        return all(any(self._key(stage, quality, cold) in self._cost for cold in (False, True)) for stage in stages)

    def next_at_rest(self, shown):
        """Index of the quality to refine a resting view to, from that of the picture shown: 0, or first the best one
        within OVERVIEW where the best takes over twice as long."""
        if self.predicted(0) > 2 * OVERVIEW:
            for i in range(1, shown):
                if self.predicted(i) <= OVERVIEW:
                    return i
        return 0

    @staticmethod
    def _key(stage, quality, cold):
        return stage, tuple(getattr(quality, name) for name in DEPENDS.get(stage, ())), cold
