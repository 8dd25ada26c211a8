# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures by salience whether the eye goes to the focus: in styles and places, as they are and strengthened, and by
color and lines alone (the viewing conditions of Cole 2009, 5.3.3)."""

from dataclasses import dataclass

import numpy as np
from bl_ext.user_default.fovea import gaze, style
from bl_ext.user_default.fovea.render import gaze_check
from command import variants

from . import emphasis
from .world import named_style

PLACES = (0.2, 0.5), (0.8, 0.5)  # as fractions of the frame, from the left and the top
COLORFUL = "watercolor"
CONDITIONS = {"color and lines": {}, "color": {"lines": "uniform"}, "lines": {"colors": "uniform"}}


@dataclass(frozen=True)
class Result:
    judged: gaze.Judged


class Stage:
    """A World in a style, with focus at a place of the image."""

    def __init__(self, world, name, at):
        point = style.FocusPlace(at=(*at, 0.0), near=emphasis.NEAR, far=emphasis.FAR)
        self.world = world
        self.base = named_style(name).replace(focus=style.Focus(model="image", points=(point,)))
        self.evenly = self._looked(gaze_check.evenly(self.base))[0]

    def _looked(self, chosen):
        """(Gaze, (H, W) focus) of its drawing in a Style."""
        drawn = self.world.draw(chosen)
        return gaze_check.look(drawn.image, drawn.frame)[0], drawn.frame.focus_of_pixels()

    def at(self, **effects):
        """The Result with other effects."""
        seen, focus = self._looked(self.base.replace(effects=self.base.effects.replace(**effects)))
        return Result(gaze.judge(seen, self.evenly, focus))

    def strengthened(self):
        """(emphasis, Result) at which the focus wins, or of the most."""
        return gaze.strengthened(lambda emphasis: self.at(emphasis=emphasis), 1.0, gaze_check.most_emphasis())


def rows(scene, world, count):
    """Of so many places, at most."""
    found, before, after, wins = [], [], [], 0
    for name in variants.STYLES:
        for at in PLACES[:count]:
            stage = Stage(world, name, at)
            drawn = stage.at()
            emphasis, strong = (1.0, drawn) if drawn.judged.wins else stage.strengthened()
            before.append(drawn.judged.gain)
            after.append(strong.judged.gain)
            wins += strong.judged.wins
            what = f"{name}, focus at {at[0]:g},{at[1]:g}"
            found += [
                (f"{what}: gain", drawn.judged.gain, "> 1"),
                (f"{what}: gain, strengthened", strong.judged.gain, "> 1"),
                (f"{what}: emphasis", emphasis, None),
            ]
    found += [
        ("focus gains, share", float(np.mean([gain > 1 for gain in before])), ">= .875"),
        ("focus gains, share, strengthened", float(np.mean([gain > 1 for gain in after])), ">= 1"),
        ("focus wins, share, strengthened", wins / len(before), None),
    ]
    stages = [Stage(world, COLORFUL, at) for at in PLACES[:count]]
    for words, effects in CONDITIONS.items():
        gain = float(np.mean([stage.at(**effects).judged.gain for stage in stages]))
        found.append((f"{COLORFUL}, emphasis of {words}: mean gain", gain, "less than the one before"))
    return [{"figure": figure, "scene": scene, "value": value, "wanted": wanted} for figure, value, wanted in found]
